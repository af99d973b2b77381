// The explorer's data, and its page as a file. They are compared with the exploration and with theory/.
#include <algorithm>
#include <filesystem>
#include <set>

#include "enumerate/generators.hpp"
#include "figures/explorer/explorer.hpp"
#include "mesh/geometry/drawing.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "tests/figures/explorer_examples.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/theory/integer_vector.hpp"
#include "theory/configuration_graph.hpp"
#include "verify/claims/claims.hpp"

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
      // The expected mesh is glued from the parameters.
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
      // The strip counts e_i by the side that the separatrix meets. Label i lies on side i + p - 1.
      const auto k = static_cast<std::size_t>(e.type().side_count());
      for (std::size_t i = 0; i < k; ++i) {
        const auto& path = node["outward"][(i + static_cast<std::size_t>(c->p) - 1) % k];
        if (!c->degenerate())
          CHECK(path.size() == static_cast<std::size_t>(c->parameters.e(static_cast<Eigen::Index>(i))) + 1);
      }
      // Quads do not overlap, although positions are rounded to whole numbers.
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

// Figure 9 lets readers predict a move before it is made. The region has the same outline before and after the move.
// The arrows of the move must point to where the vertices of the pair go, and must do so better than those of other
// moves.
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
      if (move["operations"].empty()) continue;  // the mesh stays the same, but v1 and v2 change places
      const std::vector<std::size_t> before = from["irregular"];
      const std::vector<std::size_t> after = to["irregular"];
      // The mesh does not say which vertex is which. Of the two assignments, the one with less movement counts. If both
      // are equal, since the pair was merged or turns by 90 degrees, the one that the arrows prefer counts.
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

TEST_CASE("the explorer's graph has the positions of Figures 10, 11 and 12", "[explorer]") {
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
        // Three unit vectors span the half cube. (x,0,p) and (0,x,p+1) have one spot.
        json spot{0, 0, 0};
        spot[static_cast<std::size_t>((p + 2) % 3)] = m;
        if (n > 0) spot[static_cast<std::size_t>((p + 1) % 3)] = n;
        CHECK(node["spots"] == json::array({spot}));
      }
    }
  }
}

TEST_CASE("the explorer's claims are those of verify, and fail on false facts", "[explorer]") {
  using Ids = std::set<std::string>;
  const auto failing = [](const ordered_json& claims) {
    Ids ids;
    for (const auto& c : claims) {
      CHECK(c["holds"].get<bool>() == c["violation"].get<std::string>().empty());
      if (!c["holds"].get<bool>()) ids.insert(c["id"]);
    }
    return ids;
  };
  for (const Example& e : examples()) {
    const enumerate::Exploration found = explored(e);
    const ordered_json claims = explorer_data(found)["claims"];
    CHECK(claims == explorer_claims(found));
    CHECK(failing(claims).empty());
    Ids ids;
    for (const auto& c : claims) {
      const verify::Claim* const claim = verify::find_claim(c["id"]);
      REQUIRE(claim != nullptr);
      CHECK(c["where"] == claim->where);
      CHECK(c["statement"] == claim->statement);
      CHECK(!c["predicted"].get<std::string>().empty());
      CHECK(!c["found"].get<std::string>().empty());
      ids.insert(c["id"]);
    }
    const std::string count = e.type() == theory::kDigon ? "T2" : e.type() == theory::kHexagon ? "T3" : "T4";
    for (const std::string& id : Ids{count, e.type().symmetric() ? "P2" : "P1", "P3", "L8", "L9", "T11", "M1"})
      CHECK(ids.count(id) == 1);
  }

  const Example digon{theory::kDigon, sides({6, 6})};
  // A configuration and its moves are missing.
  enumerate::Exploration less = explored(digon);
  less.nodes.erase(less.nodes.begin());
  std::erase_if(less.moves, [](const auto& move) { return move.from == 0 || move.to == 0; });
  for (auto& move : less.moves) {
    --move.from;
    --move.to;
  }
  CHECK(failing(explorer_claims(less)).count("T2") == 1);
  CHECK(failing(explorer_claims(less)).count("M1") == 1);
  // A move and its inverse are refused, so the graph lacks an edge.
  enumerate::Exploration refused = explored(digon);
  for (auto& move : refused.moves) {
    if ((move.from == 0 && move.to == 3) || (move.from == 3 && move.to == 0)) move.to = -1;
  }
  CHECK(failing(explorer_claims(refused)).count("T2") == 1);
  // All moves are refused. Every configuration is there, since each was a start, but none leads to another.
  enumerate::Exploration none = explored(digon);
  none.moves.clear();
  CHECK(failing(explorer_claims(none)).count("M1") == 1);
  CHECK(failing(explorer_claims(none)).count("T2") == 1);
  // A move that cannot be undone, and one that makes a quad too many.
  enumerate::Exploration lame = explored(digon);
  lame.moves[1].restored = false;
  ++lame.moves[2].faces_made;
  CHECK(failing(explorer_claims(lame)) == Ids{"P3", "T2"});
  // The meshes are those of another region. A region of odd side has a merged vertex.
  enumerate::Exploration other = explored(digon);
  other.shape = {theory::kDigon, sides({8, 8})};
  CHECK(failing(explorer_claims(other)).count("T2") == 1);
  enumerate::Exploration odd = explored({theory::kDigon, sides({5, 5})});
  odd.nodes.push_back(explored(digon).nodes.back());
  CHECK(failing(explorer_claims(odd)).count("T2") == 1);
}

TEST_CASE("the explorer refuses regions that are too large", "[explorer]") {
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

TEST_CASE("requad-figures --explorer writes one file that needs no other", "[explorer][program]") {
  const std::filesystem::path path = scratch() / "page.html";
  const Outcome done = call("figures", "--explorer --sides 6,6 --pair 3-3 -o page.html --json -");
  CHECK(done.code == 0);
  CHECK(done.err.empty());
  const json summary = json::parse(done.out);
  CHECK(summary["configurations"] == 6);
  CHECK(summary["merged"] == 1);
  CHECK(summary["moves"] == 20);
  const std::string page = slurp(path);
  CHECK(summary["bytes"] == page.size());
  CHECK(page.size() < 100'000);
  // The page loads nothing: its only address is the name of SVG's namespace.
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
