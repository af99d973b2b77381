// What the explorer's page is like to use, in a browser: its address, its words, its keys, its film, its files.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>
#include <thread>

#include <libxml/parser.h>

#include "mesh/files/read_polygons.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/topology/signature.hpp"
#include "tests/figures/explorer_page.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/theory/integer_vector.hpp"

using namespace requad;
using namespace requad::tests;
using nlohmann::json;

namespace {

// Waits until the file is there and has an end, and reads it.
std::string downloaded(const std::filesystem::path& path, const std::string& end) {
  for (int i = 0; i < 500; ++i) {
    if (std::filesystem::exists(path)) {
      std::string text = slurp(path);
      if (text.ends_with(end)) return text;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  FAIL(path << " was not saved");
  return "";
}

}  // namespace

TEST_CASE("in a browser, the explorer's address follows the moves", "[explorer][browser]") {
  const auto program = chromium();
  if (!program) return;
  ExplorerPage page(*program);
  Browser& browser = page.browser;
  page.open(kDigon6);
  CHECK(page.label() == "(1,1)");
  CHECK(page.hash() == "#1,1");
  browser.press("ArrowUp");
  REQUIRE(page.comes_to("(2,2)"));
  CHECK(page.hash() == "#2,2");
  browser.press("ArrowRight");
  REQUIRE(page.comes_to("(3,1)"));
  CHECK(page.hash() == "#3,1");
  browser.evaluate("history.back()");
  REQUIRE(page.comes_to("(2,2)"));
  CHECK(browser.evaluate("document.getElementById('mesh-title').textContent") == "Mesh of (2,2)");
  browser.evaluate("history.back()");
  REQUIRE(page.comes_to("(1,1)"));
  browser.evaluate("history.forward()");
  REQUIRE(page.comes_to("(2,2)"));
  CHECK(page.hash() == "#2,2");

  // A film is one step: back from its end is where it started.
  const json before = browser.evaluate("history.length");
  browser.evaluate(
      "document.getElementById('speed').value = 2; document.getElementById('film-from').value = 0;"
      "document.getElementById('film-to').value = explorer.data.nodes.findIndex((n) => n.label === '(4,0)');"
      "document.getElementById('film-to').dispatchEvent(new Event('change'))");
  CHECK(browser.evaluate("explorer.state().path.length") == 3);
  browser.click("document.getElementById('film-play')");
  REQUIRE(page.comes_to("(4,0)"));
  REQUIRE(browser.wait("!explorer.state().playing"));
  CHECK(page.hash() == "#4,0");
  browser.evaluate("history.back()");
  REQUIRE(page.comes_to("(1,1)"));

  // Another reader opens the address; the names that the page shows are understood, too.
  for (const char* address : {"3,1", "(3,1)", "%283,1%29"}) {
    page.open(kDigon6, address);
    CHECK(page.label() == "(3,1)");
    CHECK(page.hash() == "#3,1");
    CHECK_FALSE(page.notice());
  }
  page.open(kDigon6, "0,4");  // the other name of (4,0)
  CHECK(page.label() == "(4,0)");
  page.open(kHexagon6, "2,0,1");
  CHECK(page.label() == "(2,0,1)");

  // An address that names no configuration says so until the next one.
  for (const char* address : {"9,9", "(2,1)", "moves", "%E0%A4%A"}) {
    CAPTURE(address);
    page.open(kDigon6, address);
    CHECK(page.label() == "(1,1)");
    CHECK(page.notice());
    CHECK(page.hash() == "#1,1");
  }
  page.open(kDigon6, "9,9");
  CHECK(browser.evaluate("document.getElementById('notice').textContent") ==
        "This region has no configuration (9,9). Here is (1,1) in its place.");
  browser.press("ArrowUp");
  REQUIRE(page.comes_to("(2,2)"));
  CHECK_FALSE(page.notice());
  browser.evaluate("location.hash = '5,5'");
  CHECK(browser.wait("document.getElementById('notice').checkVisibility()", 5));
  CHECK(page.label() == "(2,2)");
  CHECK(browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, the explorer calls configurations and moves by one name each", "[explorer][browser]") {
  const auto program = chromium();
  if (!program) return;
  ExplorerPage page(*program);
  Browser& browser = page.browser;
  for (const bool phone : {false, true}) {
    browser.show_on(phone);
    for (const Example& e : {kDigon6, Example{theory::kDigon, sides({5, 5})}, kHexagon6,
                             Example{theory::kHexagon, sides({5, 5, 5, 5, 5, 5})}, kQuad5}) {
      page.open(e);
      const std::size_t nodes = browser.evaluate("explorer.data.nodes.length");
      for (std::size_t i = 0; i < nodes; ++i) {
        browser.evaluate("location.hash = explorer.data.nodes[" + std::to_string(i) + "].label");
        REQUIRE(browser.wait("explorer.state().node === " + std::to_string(i)));
        const json seen = browser.evaluate(R"((() => {
        const buttons = [...document.querySelectorAll('button')].filter((b) => b.checkVisibility());
        const moves = buttons.filter((b) => b.dataset.key);
        const words = (b) => b.querySelector('.change').innerText + ' ' + b.querySelector('.what').innerText;
        return {
          label: explorer.state().label,
          names: buttons.map((b) => b.getAttribute('aria-label') ?? b.textContent),
          words: moves.map(words),
          targets: moves.filter((b) => b.getAttribute('aria-disabled') === 'false')
                       .map((b) => b.querySelector('.what').textContent.match(/to (\([^)]*\))/)[1]),
          spots: [...document.querySelectorAll('#graph .spot text')].map((t) => t.textContent),
          reachable: [...document.querySelectorAll('#graph .choice')].length,
        };
      })())");
        CAPTURE(phone, e.type().name(), seen.dump());
        for (const char* list : {"names", "words"}) {
          const std::set<std::string> different(seen[list].begin(), seen[list].end());
          CHECK(different.size() == seen[list].size());
        }
        CHECK(seen["words"].size() == 4);
        CHECK(seen["targets"].size() == seen["reachable"]);
        for (const json& target : seen["targets"])
          CHECK(std::find(seen["spots"].begin(), seen["spots"].end(), target) != seen["spots"].end());
      }
    }
  }
  browser.show_on(false);
  // The page counts as the terminal does, and as Theorem 7.3: tau(6) = 18.
  page.open(kHexagon6);
  CHECK(browser.evaluate("document.getElementById('graph-title').textContent") ==
        "18 configurations and the merged one");
  const Outcome done = call("figures", "--explorer --sides 6,6,6,6,6,6 --pair 5-5 -o count.html");
  CHECK(done.out.find(": 18 configurations and the merged one, 60 moves, ") != std::string::npos);
  page.open(kQuad5);
  CHECK(browser.evaluate("document.getElementById('graph-title').textContent") == "12 configurations");
}

TEST_CASE("on a phone, the explorer's film plays where it is seen", "[explorer][browser]") {
  const auto program = chromium();
  if (!program) return;
  ExplorerPage page(*program);
  Browser& browser = page.browser;
  browser.show_on(true);
  browser.set_reduced_motion(false);
  for (const Example& e : {kDigon6, kHexagon6, kQuad5}) {
    page.open(e);
    browser.evaluate("document.getElementById('speed').value = -2");
    browser.click("document.getElementById('film-play')");
    CHECK(browser.wait("document.querySelector('#mesh.moving')"));
    // All of the mesh lies between the upper edge of the screen and the moves, and nothing else lies on it.
    const json seen = browser.evaluate(R"((() => {
      const mesh = document.getElementById('mesh-frame').getBoundingClientRect();
      const moves = document.getElementById('moves-panel').getBoundingClientRect();
      const play = document.getElementById('film-play').getBoundingClientRect();
      const at = (x, y) => document.elementFromPoint(x, y).closest('#mesh-frame') !== null;
      return [mesh.top >= 0 && mesh.bottom <= moves.top, mesh.height > 200,
              at(mesh.left + mesh.width / 2, mesh.top + 5), at(mesh.left + mesh.width / 2, mesh.bottom - 5),
              Math.abs(moves.bottom - innerHeight) < 2, play.top >= mesh.bottom && play.bottom <= moves.top];
    })())");
    CHECK(seen == json{true, true, true, true, true, true});
  }
}

TEST_CASE("in a browser, arrow keys scroll where they make no move", "[explorer][browser]") {
  const auto program = chromium();
  if (!program) return;
  ExplorerPage page(*program);
  Browser& browser = page.browser;
  const auto scrolled_within = [&](const std::string& key, double seconds) {
    const double before = browser.evaluate("scrollY");
    browser.press(key);
    return browser.wait("Math.abs(scrollY - " + std::to_string(before) + ") > 5", seconds);
  };
  const auto scrolled = [&](const std::string& key) { return scrolled_within(key, 20); };
  const auto stayed = [&](const std::string& key) { return !scrolled_within(key, 2); };
  const auto scroll_to = [&](const std::string& where) { browser.evaluate("scrollTo(0, " + where + ")"); };
  page.open(kDigon6, "2,2");
  // There is no move upwards from the topmost level, so the page scrolls.
  scroll_to("50");
  CHECK(scrolled("ArrowUp"));
  CHECK(page.label() == "(2,2)");
  // There is one downwards.
  scroll_to("0");
  CHECK(stayed("ArrowDown"));
  CHECK(page.label() == "(1,1)");
  // Below the drawings the keys scroll.
  scroll_to("document.body.scrollHeight");
  CHECK(scrolled("ArrowUp"));
  CHECK(page.label() == "(1,1)");
  // A drawing that has the focus takes all of them, a table none.
  scroll_to("0");
  browser.evaluate("document.getElementById('graph-frame').focus()");
  CHECK(stayed("ArrowDown"));
  CHECK(page.label() == "(0,0)");
  CHECK(stayed("ArrowDown"));
  browser.evaluate("document.querySelector('.scroll').focus(); scrollTo(0, 300)");
  CHECK(scrolled("ArrowUp"));
  CHECK(page.label() == "(0,0)");
}

TEST_CASE("in a browser, the explorer saves its mesh as OBJ and as SVG", "[explorer][browser]") {
  const auto program = chromium();
  if (!program) return;
  ExplorerPage page(*program);
  Browser& browser = page.browser;
  const std::filesystem::path folder = scratch() / "saved";
  std::filesystem::create_directory(folder);
  browser.set_downloads(folder.string());
  std::string light;
  for (const bool dark : {false, true}) {
    for (const auto& [e, address, name] : {std::tuple{kDigon6, "4,0", "digon-6-6_4-0"},
                                           {kHexagon6, "0,0", "hexagon-6-6-6-6-6-6_0-0"},
                                           {kQuad5, "2,3", "quadrilateral-6-5-5-8_2-3"}}) {
      CAPTURE(name);
      browser.set_dark(dark);
      page.open(e, address);
      std::filesystem::remove(folder / (std::string(name) + ".obj"));
      browser.click("document.getElementById('save-obj')");
      const std::string obj = downloaded(folder / (std::string(name) + ".obj"), "\n");
      const mesh::Surface surface = mesh::to_quad_mesh(mesh::parse_obj(obj, name));
      // The root is the first edge of the first face.
      const mesh::Region region{surface.mesh, mesh::HalfEdgeId(0)};
      CHECK(mesh::region_problem(region).empty());
      CHECK(mesh::signature(region) == browser.evaluate("explorer.data.nodes[explorer.state().node].signature"));
      CHECK(mesh::side_lengths(region) == std::vector<int>(e.sides().begin(), e.sides().end()));
      // No two vertices have one place.
      std::set<std::pair<double, double>> places;
      for (const auto& p : surface.positions) places.emplace(p.x(), p.y());
      CHECK(places.size() == surface.positions.size());

      const std::filesystem::path svg_path = folder / (std::string(name) + ".svg");
      std::filesystem::remove(svg_path);
      browser.click("document.getElementById('save-svg')");
      const std::string svg = downloaded(svg_path, "</svg>\n");
      xmlDoc* document = xmlReadMemory(svg.data(), static_cast<int>(svg.size()), nullptr, nullptr,
                                       XML_PARSE_NOERROR | XML_PARSE_NONET);
      CHECK(document != nullptr);
      xmlFreeDoc(document);
      // Nothing depends on a style sheet, and nothing is in pixels of the page.
      for (const char* word : {"class=", "var(", "style=", "vector-effect", "url(", "display"}) {
        CAPTURE(word);
        CHECK(svg.find(word) == std::string::npos);
      }
      CHECK(svg.find("<title>" + e.type().name() + " pair, ") != std::string::npos);
      CHECK(svg.find("stroke-width=\"") != std::string::npos);
      // The colours are those of the light page.
      if (std::string(address) != "2,3") continue;
      if (!dark) light = svg;
      CHECK(svg == light);
    }
  }
  CHECK(browser.complaints() == std::vector<std::string>{});
}
