// The explorer's page in a browser. Tests click and press keys, and compare the page with the predicted graph. They
// rebuild its meshes from the face lists, and compare their signatures.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "enumerate/generators.hpp"
#include "figures/explorer/explorer.hpp"
#include "mesh/topology/signature.hpp"
#include "tests/figures/explorer_examples.hpp"
#include "tests/support/browser.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/enumerate/census.hpp"
#include "tests/support/programs.hpp"
#include "theory/configuration_graph.hpp"

using namespace requad;
using namespace requad::figures;
using namespace requad::tests;
using nlohmann::json;

namespace {

const char* const kAtRest = "explorer.state().moving === false && explorer.state().playing === false";

std::string write_page(const Example& e) {
  static int number = 0;
  const std::filesystem::path path = scratch() / ("explorer-" + std::to_string(number++) + ".html");
  spill(path, explorer_page(explorer_data(explored(e))));
  return path.string();
}

std::string label_shown(Browser& browser) { return browser.evaluate("explorer.state().label"); }

// The signature of the mesh that the operations of the last move made on the page.
std::string signature_of(const json& last) {
  REQUIRE(last["arrives"] == true);
  return mesh::signature(rebuilt(last["faces"], last["root"]));
}

std::string spot(const std::string& label) {
  return "[...document.querySelectorAll('#graph .spot')].find((s) => s.querySelector('text').textContent === '" +
         label + "').querySelector('ellipse')";
}

void open_at(Browser& browser, const std::string& page, const std::string& label) {
  browser.open(page, label);
  REQUIRE(browser.wait("window.explorer"));
  REQUIRE(label_shown(browser) == label);
}

}  // namespace

TEST_CASE("in a browser, each arrow key makes the move that the theory predicts", "[explorer][browser]") {
  const auto program = chromium();
  if (!program) return;
  Browser browser(*program);
  browser.set_reduced_motion(true);  // results appear at once
  for (const Example& e : examples()) {
    const bool large = e.sides().sum() > 30 || (e.sides().size() == 4 && e.sides() == sides({6, 5, 6, 9}));
    if (large) continue;  // the other examples suffice
    const std::string page = write_page(e);
    std::map<std::string, std::string> signatures;  // of meshes that are glued
    for (const auto& c : theory::parameter_set(e))
      signatures[theory::label(e.type(), c)] = mesh::signature(enumerate::glue_region(e.type(), c));
    for (const auto& c : theory::merged_configurations(e))
      signatures[theory::label(e.type(), c)] = mesh::signature(enumerate::glue_region(e.type(), c));
    const auto keys = predicted_keys(e);
    open_at(browser, page, keys.begin()->first);
    CHECK(browser.evaluate("document.querySelectorAll('#graph .spot:not(.copy)').length") == keys.size());
    CHECK(browser.evaluate("document.querySelectorAll('#claims .holds').length") ==
          browser.evaluate("explorer.data.claims.length"));
    for (const auto& [from, moves] : keys) {
      for (const auto& [key, to] : moves) {
        CAPTURE(e.type().name(), from, key, to);
        // (Chromium ignores addresses that change more than 200 times in half a minute.)
        browser.evaluate(
            "(() => { const s = document.getElementById('jump'); s.value = explorer.data.nodes.findIndex((n) => "
            "n.label === '" +
            from + "'); s.dispatchEvent(new Event('change')); })()");
        REQUIRE(browser.wait("explorer.state().label === '" + from + "'"));
        browser.press("Arrow" + std::string(1, static_cast<char>(std::toupper(key[0]))) + key.substr(1));
        const json after =
            browser.evaluate("({...explorer.state(), said: document.getElementById('live').textContent})");
        CHECK(after["moving"] == false);
        CHECK(after["label"] == (to.empty() ? from : to));
        CHECK(after["said"].get<std::string>().find(to.empty() ? "No room" : to) != std::string::npos);
        if (!to.empty()) CHECK(signature_of(after["last"]) == signatures.at(to));
      }
    }
    CHECK(browser.complaints() == std::vector<std::string>{});
  }
}

TEST_CASE("in a browser, the claims are shown with what was predicted and found", "[explorer][browser]") {
  const auto program = chromium();
  if (!program) return;
  Browser browser(*program);
  enumerate::Exploration found = explored({theory::kDigon, sides({6, 6})});
  found.moves.front().inverse_returns = false;
  const nlohmann::ordered_json data = explorer_data(found);
  const std::filesystem::path path = scratch() / "claims.html";
  spill(path, explorer_page(data));
  browser.open(path.string());
  REQUIRE(browser.wait("window.explorer"));
  CHECK(browser.evaluate("document.getElementById('claims-title').textContent") == "Claims, some of which fail here");
  const json rows = browser.evaluate(
      "[...document.querySelectorAll('#claims tbody tr')].map((r) => [...r.cells].map((c) => c.textContent))");
  REQUIRE(rows.size() == data["claims"].size());
  int failing = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& claim = data["claims"][i];
    const auto word = [&claim](const char* key) { return claim[key].get<std::string>(); };
    CHECK(rows[i][0] == word("id") + ". " + word("statement") + " (" + word("where") + ")");
    CHECK(rows[i][1] == word("predicted"));
    CHECK(rows[i][2] == word("found"));
    CHECK(rows[i][3] == (claim["holds"] == true ? "✓ holds" : "✗ fails " + word("violation")));
    failing += claim["holds"] == true ? 0 : 1;
  }
  CHECK(failing == 1);  // T2 alone looks at a move's inverse
  CHECK(browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, clicks make moves, films play, and the keyboard suffices", "[explorer][browser]") {
  const auto program = chromium();
  if (!program) return;
  Browser browser(*program);
  const Example digon{theory::kDigon, sides({6, 6})};
  const Example hexagon{theory::kHexagon, sides({5, 5, 5, 5, 5, 5})};
  const Example quad{theory::kQuad, sides({6, 5, 5, 8})};
  const auto set = [&browser](const std::string& id, const std::string& label) {
    browser.evaluate("(() => { const s = document.getElementById('" + id +
                     "'); s.value = explorer.data.nodes.findIndex((n) => n.label === '" + label +
                     "'); s.dispatchEvent(new Event('change')); })()");
  };
  const auto hurry = [&browser] { browser.evaluate("document.getElementById('speed').value = 2"); };

  SECTION("mouse") {
    browser.show_on(false);
    for (const auto& [e, start, next, far] : {std::tuple{digon, "(1,1)", "(2,2)", "(0,4)"},
                                              {hexagon, "(1,0,1)", "(2,1,1)", "(3,0,2)"},
                                              {quad, "(1,1)", "(2,1)", "(4,3)"}}) {
      open_at(browser, write_page(e), start);
      hurry();
      CAPTURE(e.type().name());
      // A click on a neighbour makes its move, operation by operation.
      browser.click(spot(next));
      CHECK(browser.wait("document.querySelector('#mesh.moving')"));
      CHECK(browser.wait(kAtRest));
      CHECK(label_shown(browser) == next);
      const json state = browser.evaluate("explorer.state()");
      CHECK(signature_of(state["last"]) == browser.evaluate("explorer.data.nodes[explorer.state().node].signature"));
      // A button makes the move back. The mesh has an arrow for this move, too.
      browser.evaluate(
          "explorer.back = explorer.data.moves.find((m) => m.from === explorer.state().node && "
          "explorer.data.nodes[m.to].label === '" +
          std::string(start) + "').key");
      browser.click("document.querySelector(`.move.${explorer.back}`)");
      CHECK(browser.wait(kAtRest));
      CHECK(label_shown(browser) == start);
      CHECK(browser.evaluate("document.querySelectorAll('#mesh .arrow').length") ==
            browser.evaluate("document.querySelectorAll('.move[aria-disabled=false]').length"));
      // A click on a configuration far away leads there by a shortest path. (0,4) is (4,0).
      browser.click(spot(far));
      CHECK(browser.evaluate("explorer.state().playing") == true);
      const std::string arrived = std::string(far) == "(0,4)" ? "(4,0)" : far;
      CHECK(browser.evaluate("explorer.state().path.length") == predicted_distance(e, start, arrived));
      CHECK(browser.wait(kAtRest));
      CHECK(label_shown(browser) == arrived);
      CHECK(browser.complaints() == std::vector<std::string>{});
    }
  }

  SECTION("an arrow on the mesh") {
    browser.show_on(false);
    open_at(browser, write_page(digon), "(1,1)");
    hurry();
    browser.click("document.querySelector('#mesh .arrow.up .head')");
    CHECK(browser.wait("explorer.state().label === '(2,2)'"));
  }

  SECTION("films") {
    browser.show_on(false);
    for (const auto& [e, from, to] :
         {std::tuple{digon, "(4,0)", "(0,0)"}, {hexagon, "(3,0,1)", "(1,2,3)"}, {quad, "(1,3)", "(4,1)"}}) {
      open_at(browser, write_page(e), to);
      CAPTURE(e.type().name(), from, to);
      set("film-from", from);
      set("film-to", to);
      const json state = browser.evaluate("explorer.state()");
      const int steps = predicted_distance(e, from, to);
      REQUIRE(state["path"].size() == static_cast<std::size_t>(steps));
      browser.evaluate("document.getElementById('speed').value = -2");
      browser.click("document.getElementById('film-play')");
      CHECK(browser.wait(
          "document.querySelector('#mesh.moving') && document.getElementById('caption').textContent.includes(' of ')"));
      // A pause ends the present move. Then the film continues.
      browser.click("document.getElementById('film-play')");
      CHECK(browser.wait(kAtRest));
      const int made = browser.evaluate("explorer.state().step");
      CHECK(made >= 1);
      CHECK(made < steps);
      CHECK(browser.evaluate("document.getElementById('film-play').textContent") == "Go on");
      hurry();
      browser.click("document.getElementById('film-play')");
      CHECK(browser.wait(kAtRest));
      CHECK(label_shown(browser) == to);
      CHECK(browser.evaluate("explorer.state().step") == steps);
      // The button for single moves makes one move after the other, from the start.
      for (int i = 0; i <= steps; ++i) {
        browser.click("document.getElementById('film-step')");
        CHECK(browser.wait(kAtRest));
        if (i == 0) CHECK(label_shown(browser) == from);
      }
      CHECK(label_shown(browser) == to);
      CHECK(browser.complaints() == std::vector<std::string>{});
    }
  }

  SECTION("keyboard") {
    browser.show_on(false);
    browser.set_reduced_motion(true);
    open_at(browser, write_page(hexagon), "(1,0,1)");
    // Tab reaches every control in the order of the page, and the focus is visible.
    std::vector<std::string> met;
    for (int i = 0; i < 25; ++i) {
      browser.press("Tab");
      const json here = browser.evaluate(
          "(() => { const e = document.activeElement; return [e.id || e.dataset.key || e.className || e.tagName,"
          " getComputedStyle(e).outlineStyle, Boolean(e.getAttribute('aria-label') || e.getAttribute('aria-labelledby')"
          " || (e.labels && e.labels.length) || e.textContent.trim())]; })()");
      if (here[0] == "BODY") break;
      met.push_back(here[0]);
      CAPTURE(here[0]);
      CHECK(here[1] != "none");
      CHECK(here[2] == true);
    }
    CHECK(met == std::vector<std::string>{"graph-frame", "jump",      "turn-left",  "turn-right",  "turn-reset",
                                          "save-svg",    "save-obj",  "mesh-frame", "show-arrows", "show-separatrices",
                                          "show-alpha",  "close-up",  "up",         "left",        "right",
                                          "down",        "film-from", "film-to",    "film-swap",   "film-play",
                                          "film-step",   "speed",     "scroll"});
    // Shift with an arrow key turns the cube and makes no move.
    browser.evaluate("document.getElementById('graph-frame').focus()");
    const std::string at = "document.querySelector('#graph .spot.current').getAttribute('transform')";
    const json straight = browser.evaluate(at);
    browser.press("Shift+ArrowUp");
    CHECK(browser.evaluate(at) != straight);
    CHECK(label_shown(browser) == "(1,0,1)");
    browser.evaluate("document.getElementById('turn-reset').click()");
    CHECK(browser.evaluate(at) == straight);
    // Enter on the button of a move makes the move. The button keeps the focus.
    browser.evaluate("document.querySelector('.move.left').focus()");
    browser.press("Enter");
    CHECK(label_shown(browser) == predicted_keys(hexagon).at("(1,0,1)").at("left"));
    CHECK(browser.evaluate("document.activeElement.dataset.key") == "left");
    // Arrow keys in a list choose an entry and make no move.
    browser.evaluate("document.getElementById('film-to').focus()");
    const std::string before = label_shown(browser);
    browser.press("ArrowDown");
    CHECK(label_shown(browser) == before);
    // A film without motion still stops at each configuration.
    browser.evaluate("document.getElementById('speed').value = 2");
    set("film-from", "(1,0,1)");
    set("film-to", "(3,0,1)");
    browser.evaluate("document.getElementById('film-play').focus()");
    browser.press("Enter");
    CHECK(browser.evaluate("document.querySelector('#mesh.moving')").is_null());
    CHECK(browser.wait(kAtRest));
    CHECK(label_shown(browser) == "(3,0,1)");
    CHECK(browser.complaints() == std::vector<std::string>{});
  }

  SECTION("phone") {
    browser.show_on(true);
    for (const Example& e : {digon, hexagon, quad}) {
      const std::string start = predicted_keys(e).begin()->first;
      open_at(browser, write_page(e), start);
      CAPTURE(e.type().name());
      CHECK(browser.evaluate("document.documentElement.scrollWidth") <= 390);
      // Controls must be at least 44 pixels high for a thumb.
      CHECK(browser.evaluate("[...document.querySelectorAll('button, select')].filter((b) => b.offsetParent && "
                             "(b.offsetHeight < 44 || b.offsetWidth < 44)).length") == 0);
      browser.evaluate("document.getElementById('speed').value = 2");
      const auto moves = predicted_keys(e).at(start);
      const auto move = std::find_if(moves.begin(), moves.end(), [](const auto& m) { return !m.second.empty(); });
      browser.click("document.querySelector('.move." + move->first + "')");
      CHECK(browser.wait("explorer.state().label === '" + move->second + "' && !explorer.state().moving"));
      browser.click(spot(start));
      CHECK(browser.wait("explorer.state().label === '" + start + "' && !explorer.state().moving"));
      CHECK(browser.complaints() == std::vector<std::string>{});
    }
  }
}
