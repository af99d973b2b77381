// The explorer: its data against the exploration and the theory, and its page in a browser, by clicks and keys, against
// the predicted graph. Meshes that the page shows are rebuilt from its face lists and compared by their signatures.
#include <algorithm>
#include <deque>
#include <filesystem>
#include <set>

#include "enumerate/generators.hpp"
#include "figures/explorer/explorer.hpp"
#include "mesh/geometry/drawing.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "tests/support/browser.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/support.hpp"
#include "theory/configuration_graph.hpp"

using namespace requad;
using namespace requad::figures;
using namespace requad::tests;
using nlohmann::json;
using nlohmann::ordered_json;
using theory::Apex;
using theory::Configuration;
using theory::IntegerVector;
using theory::PairType;

namespace {

using Example = theory::RegionShape;

std::vector<Example> examples() {
  return {{theory::kDigon, sides({6, 6})},
          {theory::kDigon, sides({3, 3})},
          {theory::kDigon, sides({5, 9})},
          {theory::kHexagon, sides({5, 5, 5, 5, 5, 5})},
          {theory::kHexagon, sides({6, 6, 6, 6, 6, 6})},
          {theory::kHexagon, sides({5, 6, 7, 6, 5, 7})},
          {theory::kQuad, sides({6, 5, 5, 8})},
          {theory::kQuad, sides({6, 5, 6, 9})},
          {theory::kQuad, sides({6, 5, 4, 7})}};
}

enumerate::Exploration explored(const Example& e) { return enumerate::explore_all(e, Apex::with); }

// A mesh from the page's face list, null where an id is free, with the root edge v -> w.
mesh::Region rebuilt(const json& faces, const json& root) {
  std::map<int, int> name;
  std::vector<std::array<int, 4>> lists;
  for (const json& face : faces) {
    if (face.is_null()) continue;
    std::array<int, 4> corners{};
    for (std::size_t k = 0; k < 4; ++k) {
      corners[k] = name.emplace(face[k].get<int>(), static_cast<int>(name.size())).first->second;
    }
    lists.push_back(corners);
  }
  mesh::Region region{mesh::QuadMesh::from_faces(static_cast<int>(name.size()), lists), {}};
  region.root = region.mesh.find_half_edge(mesh::VertexId(name.at(root[0])), mesh::VertexId(name.at(root[1])));
  return region;
}

json patched(json faces, const json& operations) {
  for (const json& operation : operations) {
    for (const json& entry : operation["patch"]) {
      const auto face = entry[0].get<std::size_t>();
      while (faces.size() <= face) faces.push_back(nullptr);
      faces[face] = entry.size() == 1 ? json() : json{entry[1], entry[2], entry[3], entry[4]};
    }
  }
  return faces;
}

// What the theory says an arrow key does at a configuration: the label it leads to, "" if there is no room. The order
// of a predicted node's moves is that of configuration_graph.hpp, not of the mesh.
std::map<std::string, std::map<std::string, std::string>> predicted_keys(const Example& e) {
  const theory::ConfigurationMap map = theory::configuration_map(e, Apex::with);
  std::map<std::string, std::map<std::string, std::string>> keys;
  for (const theory::MapNode& node : map.nodes) {
    auto& here = keys[theory::label(e.type(), node.configuration)];
    for (std::size_t i = 0; i < node.moves.size(); ++i) {
      std::string key;
      const Configuration& labelling = node.labellings[i];
      if (!e.type().symmetric()) {
        key = std::array{"right", "up", "left", "down"}[static_cast<std::size_t>(node.steps[i])];
      } else if (node.configuration.merged()) {
        key = e.type() == theory::kDigon
                  ? "up"
                  : std::array{"left", "right", "down"}[static_cast<std::size_t>(labelling.p - 1)];
      } else {
        key = std::array{"up", "left", "down", "right"}[static_cast<std::size_t>(node.steps[i])];
        if (key == "up" && !(labelling == node.configuration)) key = "down";  // a segment opens on both sides
      }
      const int target = node.moves[i].target;
      REQUIRE(here.count(key) == 0);
      here[key] = target < 0 ? "" : theory::label(e.type(), map.nodes[static_cast<std::size_t>(target)].configuration);
    }
  }
  return keys;
}

// Moves on a shortest path in the predicted graph.
int predicted_distance(const Example& e, const std::string& from, const std::string& to) {
  const auto keys = predicted_keys(e);
  std::map<std::string, int> distance{{from, 0}};
  std::deque<std::string> queue{from};
  while (!queue.empty()) {
    const std::string here = queue.front();
    queue.pop_front();
    for (const auto& [key, there] : keys.at(here)) {
      if (!there.empty() && distance.emplace(there, distance.at(here) + 1).second) queue.push_back(there);
    }
  }
  return distance.at(to);
}

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("the explorer's meshes and moves are those of the exploration", "[explorer]") {
  for (const Example& e : examples()) {
    const enumerate::Exploration found = explored(e);
    const json data = explorer_data(found);
    CAPTURE(data["pair"], data["sides"]);
    const auto keys = predicted_keys(e);
    REQUIRE(data["nodes"].size() == keys.size());
    std::map<std::string, std::map<std::string, std::string>> moves;
    for (const auto& [name, unused] : keys) {
      for (const auto& [key, to] : unused) moves[name][key] = "";
    }
    for (const json& node : data["nodes"]) {
      CAPTURE(node["label"]);
      REQUIRE(keys.count(node["label"]) == 1);
      const mesh::Region region = rebuilt(node["faces"], node["root"]);
      // Glued from the parameters, not moved.
      const auto all = e.type().symmetric() && node["d1"] == 0 && node["d2"] == 0 ? theory::merged_configurations(e)
                                                                                  : theory::parameter_set(e);
      const auto c = std::find_if(all.begin(), all.end(),
                                  [&](const Configuration& x) { return theory::label(e.type(), x) == node["label"]; });
      REQUIRE(c != all.end());
      CHECK(mesh::signature(region) == mesh::signature(enumerate::glue_region(e.type(), *c)));
      CHECK(mesh::signature(region) == node["signature"]);
      CHECK(node["quads"] == region.mesh.face_count());
      CHECK(node["alpha"].size() == static_cast<std::size_t>(c->d1() * c->d2()));
      const auto around = static_cast<std::size_t>(c->d1() + c->d2());
      CHECK(node["rim"].size() == (c->merged() ? 1 : c->degenerate() ? around + 1 : 2 * around));
      // e_i, by the side that the separatrix meets: label i lies on side i + p - 1.
      const auto k = static_cast<std::size_t>(e.type().side_count());
      for (std::size_t i = 0; i < k; ++i) {
        const auto& path = node["outward"][(i + static_cast<std::size_t>(c->p) - 1) % k];
        if (!c->degenerate())
          CHECK(path.size() == static_cast<std::size_t>(c->parameters.e(static_cast<Eigen::Index>(i))) + 1);
      }
      // Rounded to whole numbers, quads still do not overlap.
      std::vector<Eigen::Vector2d> at;
      for (const json& p : node["vertices"])
        at.emplace_back(p.is_null() ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(p[0], p[1]));
      const auto it = std::find_if(found.nodes.begin(), found.nodes.end(),
                                   [&](const auto& n) { return n.signature == node["signature"]; });
      REQUIRE(it != found.nodes.end());
      CHECK(mesh::drawing_problem(it->region, at).empty());
    }
    for (const json& move : data["moves"]) {
      const json& from = data["nodes"][move["from"].get<std::size_t>()];
      const json& to = data["nodes"][move["to"].get<std::size_t>()];
      CAPTURE(from["label"], to["label"], move["key"]);
      CHECK(moves[from["label"]][move["key"]].empty());
      moves[from["label"]][move["key"]] = to["label"];
      CHECK(mesh::signature(rebuilt(patched(from["faces"], move["operations"]), from["root"])) == to["signature"]);
      CHECK(to["quads"].get<int>() - from["quads"].get<int>() == move["made"].get<int>() - move["deleted"].get<int>());
    }
    CHECK(moves == keys);
  }
}

// Figure 9's purpose: to predict a move before it is made. The pair is drawn after the move, in the same boundary; the
// arrows of the move must point to where its vertices come to lie, and do so better than those of any other move.
TEST_CASE("the arrows point where the pair goes", "[explorer]") {
  int pairs = 0;
  for (const Example& e : examples()) {
    const json data = explorer_data(explored(e));
    for (const json& move : data["moves"]) {
      const json& from = data["nodes"][move["from"].get<std::size_t>()];
      const json& to = data["nodes"][move["to"].get<std::size_t>()];
      CAPTURE(data["pair"], data["sides"], from["label"], to["label"], move["key"]);
      const auto place = [](const json& node, std::size_t v) {
        const json& p = node["vertices"][v];
        return Eigen::Vector2d(p[0], p[1]);
      };
      if (move["operations"].empty()) continue;  // the mesh stays: the pair changes places
      const std::vector<std::size_t> before = from["irregular"];
      const std::vector<std::size_t> after = to["irregular"];
      // Which vertex is which is not written in the mesh: of both assignments, that of less movement. Where the pair
      // was merged, or turns by 90 degrees, both are alike: then the one that the arrows prefer.
      const auto along = [&](const json& arrows, bool swapped) {
        double sum = 0;
        for (std::size_t i = 0; i < 2; ++i) {
          const Eigen::Vector2d start = place(from, arrows[i][0]);
          const std::size_t which = before.size() == 1 ? i : arrows[i][0] == before[0] ? 0 : 1;
          const Eigen::Vector2d end = place(to, after[std::min(swapped ? 1 - which : which, after.size() - 1)]);
          sum += (place(from, arrows[i][1]) - start).normalized().dot(end - start);
        }
        return sum;
      };
      const auto movement = [&](bool swapped) {
        double sum = 0;
        for (std::size_t i = 0; i < 2; ++i) {
          const Eigen::Vector2d start = place(from, before[std::min(i, before.size() - 1)]);
          sum += (place(to, after[std::min(swapped ? 1 - i : i, after.size() - 1)]) - start).norm();
        }
        return sum;
      };
      const double difference = movement(true) - movement(false);
      const bool either = std::abs(difference) < 0.02 * movement(true);
      const auto fit = [&](const json& arrows) {
        if (either) return std::max(along(arrows, false), along(arrows, true));
        return along(arrows, difference < 0);
      };
      CHECK(fit(move["arrows"]) > 0);
      for (const json& other : data["moves"]) {
        if (other["from"] != move["from"] || other == move) continue;
        CAPTURE(other["key"]);
        if (!either || before.size() == 1) CHECK(fit(move["arrows"]) > fit(other["arrows"]));
      }
      ++pairs;
    }
  }
  CHECK(pairs > 150);
}

TEST_CASE("the explorer's graph has the places of Figures 10, 11 and 12", "[explorer]") {
  for (const Example& e : examples()) {
    const json data = explorer_data(explored(e));
    for (const json& node : data["nodes"]) {
      CAPTURE(data["sides"], node["label"]);
      int m = 0, n = 0, p = 1;
      const std::string label = node["label"];
      const int read = std::sscanf(label.c_str(), "(%d,%d,%d)", &m, &n, &p);
      REQUIRE(read >= 2);
      if (e.type() == theory::kQuad) {
        CHECK(node["spots"] == json{{m, n, 0}});
      } else if (e.type() == theory::kDigon) {
        json spots{{m - n, m + n, 0}};
        if (n == 0 && m > 0) spots.push_back({-m, m, 0});  // (0,m)
        CHECK(node["spots"] == spots);
      } else {
        // Three unit vectors; (x,0,p) and (0,x,p+1) are one place.
        json spot{0, 0, 0};
        spot[static_cast<std::size_t>((p + 2) % 3)] = m;
        if (n > 0) spot[static_cast<std::size_t>((p + 1) % 3)] = n;
        CHECK(node["spots"] == json::array({spot}));
      }
    }
  }
}

TEST_CASE("the explorer's claims hold, and fail on false facts", "[explorer]") {
  const auto claim = [](const std::vector<RegionClaim>& claims, const std::string& id) {
    const auto it = std::find_if(claims.begin(), claims.end(), [&](const RegionClaim& c) { return c.id == id; });
    REQUIRE(it != claims.end());
    return *it;
  };
  const auto failing = [](const std::vector<RegionClaim>& claims) {
    std::multiset<std::string> ids;
    for (const RegionClaim& c : claims) {
      if (!c.holds) ids.insert(c.id);
    }
    return ids;
  };
  using Ids = std::multiset<std::string>;
  for (const Example& e : examples()) CHECK(failing(region_claims(explored(e))).empty());

  // tau by Theorems 7.2 and 7.3, K by 7.4, by hand: N = 3, 3 * 2; N = 2, 3 * 2^2; M = 5 - 1, N = 6 - 2 - 1.
  const Example digon{theory::kDigon, sides({6, 6})};
  const auto claims = region_claims(explored(digon));
  CHECK(claim(claims, "T2").predicted == "tau(6) = N (N - 1) = 6 with N = 3");
  CHECK(claim(claims, "T2").found == "6 configurations reached by moves");
  CHECK(claim(claims, "N2").found == "d1 + d2 even, a v2");
  const Example hexagon{theory::kHexagon, sides({5, 5, 5, 5, 5, 5})};
  CHECK(claim(region_claims(explored(hexagon)), "T3").predicted == "tau(5) = 3 N^2 = 12 with N = 2");
  const Example quad{theory::kQuad, sides({6, 5, 5, 8})};
  CHECK(claim(region_claims(explored(quad)), "T4").predicted == "K = 4 x 3 = 12");

  // A configuration less, with its moves.
  enumerate::Exploration less = explored(digon);
  less.nodes.erase(less.nodes.begin());
  std::erase_if(less.moves, [](const auto& move) { return move.from == 0 || move.to == 0; });
  for (auto& move : less.moves) {
    --move.from;
    --move.to;
  }
  CHECK(failing(region_claims(less)) == Ids{"T2", "T2", "T11"});
  // A move that is refused, both ways: the graph lacks an edge.
  enumerate::Exploration refused = explored(digon);
  for (auto& move : refused.moves) {
    if ((move.from == 0 && move.to == 3) || (move.from == 3 && move.to == 0)) move.to = -1;
  }
  CHECK(failing(region_claims(refused)).count("T2") == 1);
  // All moves refused.
  enumerate::Exploration none = explored(digon);
  none.moves.clear();
  CHECK(failing(region_claims(none)) == Ids{"M1", "T2"});
  // A move that changes nothing, one that cannot be undone, one that makes a quad too many.
  enumerate::Exploration lame = explored(digon);
  lame.moves[0].after = lame.moves[0].before;
  lame.moves[1].restored = false;
  ++lame.moves[2].faces_made;
  CHECK(failing(region_claims(lame)) == Ids{"B3", "P2", "P3"});
  // Meshes of another region; and a merged vertex in a region of odd side.
  enumerate::Exploration other = explored(digon);
  other.shape = {theory::kDigon, sides({8, 8})};
  CHECK(failing(region_claims(other)).count("L9") == 1);
  enumerate::Exploration odd = explored({theory::kDigon, sides({5, 5})});
  odd.nodes.push_back(explored(digon).nodes.back());
  CHECK(failing(region_claims(odd)).count("N2") == 1);
}

TEST_CASE("the explorer takes regions of a bounded size", "[explorer]") {
  CHECK(explorer_problem({theory::kDigon, sides({6, 6})}).empty());
  CHECK(theory::RegionShape::problem(theory::kDigon, sides({6, 6, 6})) ==
        "a convex region with a 3-3 pair has 2 sides, not 3");
  CHECK(explorer_problem({theory::kDigon, sides({2, 2})}) == "the region has no configuration with a 3-3 pair");
  CHECK(explorer_problem({theory::kDigon, sides({60, 60})}) ==
        "870 configurations; the explorer, to stay quick, takes at most 150");
  CHECK(theory::RegionShape::problem(theory::kDigon, sides({3, 1'000'001})).find("1000001") != std::string::npos);
  CHECK(explorer_problem({theory::kDigon, sides({3, 61})}) ==
        "a side of 61 edges; the explorer, to stay quick, takes at most 60");
  CHECK(explorer_problem({theory::kQuad, sides({40, 9, 30, 59})}).find(" quads in ") != std::string::npos);
}

TEST_CASE("requad-figures --explorer writes one file that stands alone", "[explorer][program]") {
  const std::filesystem::path path = scratch() / "page.html";
  const Outcome done = call("figures", "--explorer --sides 6,6 --pair 3-3 -o page.html --json -");
  CHECK(done.code == 0);
  CHECK(done.err.empty());
  const json summary = json::parse(done.out);
  CHECK(summary["configurations"] == 7);
  CHECK(summary["moves"] == 20);
  const std::string page = slurp(path);
  CHECK(summary["bytes"] == page.size());
  CHECK(page.size() < 100'000);
  // Nothing is loaded: the only address is the name of SVG's namespace.
  CHECK(occurrences(page, "://") == 1);
  CHECK(page.find("http://www.w3.org/2000/svg") != std::string::npos);
  for (const char* word : {"<script src", "<link rel=\"style", "@import", "fetch(", "XMLHttpRequest", "<!-- data"}) {
    CAPTURE(word);
    CHECK(page.find(word) == std::string::npos);
  }
  CHECK(call("figures", "--explorer --sides 6,6 --pair 3-3 -o -").out == page);
  for (const auto& [arguments, message] : std::vector<std::pair<std::string, std::string>>{
           {"--explorer --sides 6,6", "--pair is missing"},
           {"--explorer --pair 3-3", "--sides is missing"},
           {"--explorer --pair 4-4 --sides 6,6", "'4-4' is not one of 3-3, 5-5, 3-5"},
           {"--explorer --pair 3-3 --sides 40,40",
            "380 configurations; the explorer, to stay quick, takes at most 150"},
           {"--explorer --pair 3-3 --sides 6,6 --figure 10", "--figure"},
           {"--pair 3-3", "no use for --pair"}}) {
    CAPTURE(arguments);
    const Outcome refused = call("figures", arguments);
    CHECK(refused.code == 2);
    CHECK(refused.err.find(message) != std::string::npos);
    CHECK(occurrences(refused.err, "\n") == 1);
  }
}

namespace {

const char* const kAtRest = "explorer.state().moving === false && explorer.state().playing === false";

std::string write_page(const Example& e) {
  static int number = 0;
  const std::filesystem::path path = scratch() / ("explorer-" + std::to_string(number++) + ".html");
  spill(path, explorer_page(explorer_data(explored(e))));
  return path.string();
}

std::string label_shown(Browser& browser) { return browser.evaluate("explorer.state().label"); }

// The mesh that the operations of the last move made on the page, by its signature.
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
  browser.set_reduced_motion(true);  // the results at once
  for (const Example& e : examples()) {
    const bool large = e.sides().sum() > 36 || (e.sides().size() == 4 && e.sides() == sides({6, 5, 6, 9}));
    if (large) continue;  // enough of each kind without it
    const std::string page = write_page(e);
    std::map<std::string, std::string> signatures;  // glued, not moved
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
        browser.evaluate("location.hash = ''; location.hash = '" + from + "'");
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

TEST_CASE("in a browser, clicks move, films play, and the keyboard alone is enough", "[explorer][browser]") {
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
    browser.set_size(1280, 900, false);
    for (const auto& [e, start, next, far] : {std::tuple{digon, "(1,1)", "(2,2)", "(0,4)"},
                                              {hexagon, "(1,0,1)", "(2,1,1)", "(3,0,2)"},
                                              {quad, "(1,1)", "(2,1)", "(4,3)"}}) {
      open_at(browser, write_page(e), start);
      hurry();
      CAPTURE(e.type().name());
      // A neighbour: its move, operation by operation.
      browser.click(spot(next));
      CHECK(browser.wait("document.querySelector('#mesh.moving')"));
      CHECK(browser.wait(kAtRest));
      CHECK(label_shown(browser) == next);
      const json state = browser.evaluate("explorer.state()");
      CHECK(signature_of(state["last"]) == browser.evaluate("explorer.data.nodes[explorer.state().node].signature"));
      // A button of the move back, which is an arrow on the mesh as well.
      browser.evaluate(
          "explorer.back = explorer.data.moves.find((m) => m.from === explorer.state().node && "
          "explorer.data.nodes[m.to].label === '" +
          std::string(start) + "').key");
      browser.click("document.querySelector(`.move.${explorer.back}`)");
      CHECK(browser.wait(kAtRest));
      CHECK(label_shown(browser) == start);
      CHECK(browser.evaluate("document.querySelectorAll('#mesh .arrow').length") ==
            browser.evaluate("document.querySelectorAll('.move[aria-disabled=false]').length"));
      // A configuration far away, by a shortest path; (0,4) is (4,0).
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
    browser.set_size(1280, 900, false);
    open_at(browser, write_page(digon), "(1,1)");
    hurry();
    browser.click("document.querySelector('#mesh .arrow.up .head')");
    CHECK(browser.wait("explorer.state().label === '(2,2)'"));
  }

  SECTION("films") {
    browser.set_size(1280, 900, false);
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
      // Pause ends the move that is under way; then on.
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
      // One move after the other, from the start.
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
    browser.set_size(1280, 900, false);
    browser.set_reduced_motion(true);
    open_at(browser, write_page(hexagon), "(1,0,1)");
    // Everything that can be used is met by Tab, in the order of the page, and its focus is seen.
    std::vector<std::string> met;
    for (int i = 0; i < 22; ++i) {
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
    CHECK(met ==
          std::vector<std::string>{
              "graph-frame",       "jump",       "turn-left", "turn-right", "turn-reset", "mesh-frame", "show-arrows",
              "show-separatrices", "show-alpha", "close-up",  "up",         "left",       "right",      "down",
              "film-from",         "film-to",    "film-swap", "film-play",  "film-step",  "speed",      "scroll"});
    // Shift and an arrow key turn the cube, and move nothing.
    browser.evaluate("document.getElementById('graph-frame').focus()");
    const std::string at = "document.querySelector('#graph .spot.current').getAttribute('transform')";
    const json straight = browser.evaluate(at);
    browser.press("Shift+ArrowUp");
    CHECK(browser.evaluate(at) != straight);
    CHECK(label_shown(browser) == "(1,0,1)");
    browser.evaluate("document.getElementById('turn-reset').click()");
    CHECK(browser.evaluate(at) == straight);
    // A move by Enter on its button, which keeps the focus.
    browser.evaluate("document.querySelector('.move.left').focus()");
    browser.press("Enter");
    CHECK(label_shown(browser) == predicted_keys(hexagon).at("(1,0,1)").at("left"));
    CHECK(browser.evaluate("document.activeElement.dataset.key") == "left");
    // Arrow keys in a list choose from it and make no move.
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
    browser.set_size(390, 844, true);
    for (const Example& e : {digon, hexagon, quad}) {
      const std::string start = predicted_keys(e).begin()->first;
      open_at(browser, write_page(e), start);
      CAPTURE(e.type().name());
      CHECK(browser.evaluate("document.documentElement.scrollWidth") <= 390);
      // A thumb needs 44 pixels.
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
