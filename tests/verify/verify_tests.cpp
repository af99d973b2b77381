// The library of requad-verify: claims hold on small ranges, and the reports of a campaign.
#include <cstdlib>

#include "enumerate/generators.hpp"
#include "enumerate/search/search.hpp"
#include "mesh/topology/signature.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/support/theory/integer_vector.hpp"
#include "tests/verify/falsifying.hpp"
#include "tests/verify/small_campaign.hpp"
#include "verify/claims/convex_subregions.hpp"
#include "verify/errata.hpp"
#include "verify/report/html.hpp"
#include "verify/report/report.hpp"
#include "verify/sentences.hpp"

using namespace requad;
using namespace requad::verify;
using requad::tests::claim;
using requad::tests::fails;
using requad::tests::kAll;
using requad::tests::kOtherPerimeter;
using requad::tests::run_small;
using requad::tests::sides;
using requad::tests::small_ranges;
using requad::tests::study_of;

namespace {

// The report with each line as long as it is.
std::string unbroken_report(const CampaignResult& campaign) {
  ::setenv("COLUMNS", "10000", 1);
  const std::string text = report_text(campaign, small_ranges());
  ::unsetenv("COLUMNS");
  return text;
}

// Every non-regular hexagon of this perimeter, once up to rotation.
template <class Visit>
void enumerate_hexagons(int perimeter, Visit&& visit) {
  std::set<std::vector<int>> seen;
  std::vector<int> s(6, 1);
  const auto fill = [&](auto&& self, std::size_t at, int left) -> void {
    if (at == 5) {
      s[5] = left;
      std::vector<int> least = s;
      for (std::size_t shift = 1; shift < 6; ++shift) {
        std::vector<int> rotated = s;
        std::rotate(rotated.begin(), rotated.begin() + static_cast<std::ptrdiff_t>(shift), rotated.end());
        least = std::min(least, rotated);
      }
      if (least.front() < *std::max_element(least.begin(), least.end()) && seen.insert(least).second)
        visit(theory::to_vector({least.begin(), least.end()}));
      return;
    }
    for (int x = 1; left - x >= 5 - static_cast<int>(at); ++x) s[at] = x, self(self, at + 1, left - x);
  };
  fill(fill, 0, perimeter);
}

}  // namespace

TEST_CASE("every claim holds on small ranges, whatever the number of threads", "[verify]") {
  const CampaignResult one = run_small(1);
  CHECK(one.passed());
  for (const ClaimResult& c : one.claims) {
    INFO(c.claim->id << ": " << (c.violation ? c.violation->what : ""));
    CHECK_FALSE(c.violation.has_value());
    CHECK(c.instances > 1);
    for (const auto& [family, total] : c.totals) CHECK(total.checks > 0);
  }
  const auto without_seconds = [](CampaignResult r) {
    for (ClaimResult& c : r.claims) c.seconds = 0;
    for (auto& [method, seconds] : r.method_seconds) seconds = 0;
    return report_json(r, small_ranges());
  };
  CHECK(without_seconds(one) == without_seconds(run_small(2)));
}

TEST_CASE("regions without a configuration are searched, counted, and judged by what the search finds", "[verify]") {
  const std::set<Method> moves{Method::moves};
  // By hand: a digon with a pair has two sides of at least 3, a 3-5 region has opposite sides that differ, and no side
  // of a hexagon with a pair is 1.
  for (const PairStudy& s : {study_of(theory::kDigon, sides({1, 7})), study_of(theory::kQuad, sides({3, 3, 3, 3})),
                             study_of(theory::kHexagon, sides({1, 1, 1, 1, 1, 5}))}) {
    const std::string id = s.shape.type() == theory::kDigon ? "T2" : s.shape.type() == theory::kQuad ? "T4" : "T3";
    REQUIRE(s.searched);
    CHECK(s.searched->empty());
    CHECK(fillings_searched(s) == 0);
    for (const RegionVerdict& v : judge_region(s, {"M1", "N1", "N2", "R1", "L8", "B2"})) FAIL(v.claim->id);
    CHECK(claim(id).judge(s).row.is_null());
    fails(id, s, [](PairStudy& x) { x.searched->push_back("a filling"); });
    // Nothing but a search finds out that there is none.
    const PairStudy by_moves = study_pair(s.shape, moves);
    CHECK_FALSE(claim(id).judge(by_moves).applies);
    CHECK_FALSE(fillings_searched(by_moves).has_value());
  }
  const CampaignResult campaign = run_small(1);
  std::int64_t hexagons = 0, empty = 0;
  for (int perimeter = 6; perimeter <= kOtherPerimeter; perimeter += 2) {
    // All sequences of six sides, up to rotation, and the counts of their fillings.
    enumerate_hexagons(perimeter, [&](const theory::IntegerVector& s) {
      ++hexagons;
      if (enumerate::search(enumerate::search_problem({s.begin(), s.end()}, {5, 5}), {}, {}).count == 0) ++empty;
    });
  }
  const RegionTotal& total = campaign.regions.at(Family::other_hexagon);
  CHECK(total.regions == hexagons);
  CHECK(total.searched == hexagons);
  CHECK(total.empty == empty);
  CHECK(campaign.regions.at(Family::regular_digon).empty == 0);
  const auto json = report_json(campaign, small_ranges());
  for (const auto& family : json["regions"]) {
    if (family["family"] == "non-regular hexagons") CHECK(family["empty"] == empty);
  }
  const std::string line = "non-regular hexagons of perimeter 4.." + std::to_string(kOtherPerimeter) + ": " +
                           std::to_string(hexagons) + " regions, " + std::to_string(hexagons) + " searched, " +
                           std::to_string(empty) + " of these empty\n";
  CHECK(unbroken_report(campaign).find(line) != std::string::npos);
}

TEST_CASE("sentences without a check have a place and a reason", "[verify]") {
  const auto json = report_json(CampaignResult{}, small_ranges());
  REQUIRE(json["sentences"].size() == undecided_sentences().size());
  REQUIRE(!undecided_sentences().empty());
  const std::string html = report_html(CampaignResult{}, small_ranges());
  for (const auto& s : json["sentences"]) {
    for (const char* key : {"where", "sentence", "reason"}) CHECK(!s[key].get<std::string>().empty());
    CHECK(sentences_text().find(s["reason"].get<std::string>()) != std::string::npos);
  }
  CHECK(html.find("<h2 id=\"sentences\">") != std::string::npos);
}

TEST_CASE("the report has the keys that others rely on", "[verify]") {
  const auto json = report_json(run_small(2), small_ranges());
  CHECK(json["passed"] == true);
  CHECK(json["claims"].size() == claims().size());
  for (const auto& c : json["claims"]) {
    for (const char* key :
         {"id", "statement", "verdict", "instances", "range", "methods", "seconds", "counterexample", "table"}) {
      CHECK(c.contains(key));
    }
    CHECK(c["verdict"] == "holds");
    CHECK(!c["fails_if"].get<std::string>().empty());
    CHECK(c["counterexample"].is_null());
    CHECK(!c["table"].empty());
  }
}

TEST_CASE("errata come with instances", "[verify]") {
  const auto& errata = find_errata();
  CHECK(errata.size() == 8);
  for (const Erratum& e : errata) {
    CHECK(!e.instance.empty());
    CHECK(e.written != e.found);
  }
  // By hand: 0 < m+n <= 1 has (1,0) and (0,1), one configuration; three quadrants of that in a hexagon.
  CHECK(errata[0].instance == "digon of side 3: the set as written has 2 elements, there are 1 configurations");
  CHECK(errata[1].instance == "hexagon of side 3: the set as written has 6 elements, there are 3 configurations");
}

TEST_CASE("a region is judged by the requested claims that apply to it", "[verify]") {
  const std::vector<std::string> ids{"M1", "T2", "T3", "N1"};
  const auto verdicts = judge_region(study_of(theory::kDigon, sides({6, 6})), ids);
  REQUIRE(verdicts.size() == 2);  // T3 is about hexagons, N1 about 3-5 regions
  CHECK(verdicts[0].claim->id == "M1");
  CHECK(verdicts[1].claim->where == "Theorem 7.2");
  CHECK(verdicts[1].holds());
  CHECK(verdicts[1].judgement.row["tau"] == 6);  // N (N - 1) with N = 3
  CHECK(find_claim("T5") == nullptr);
  // A check that an exception ends is a violation. The label is that of no configuration with these sides.
  PairStudy other = study_moves(enumerate::explore_all({theory::kDigon, sides({6, 6})}, theory::Apex::with));
  other.shape = {theory::kDigon, sides({8, 8})};
  CHECK_THROWS(find_claim("R1")->judge(other));
  CHECK_FALSE(judge_region(other, {"R1"}).front().holds());
}

TEST_CASE("each check says what was predicted and what was found", "[verify]") {
  std::vector<std::string> ids;
  for (const Claim& c : claims()) ids.push_back(c.id);
  std::set<std::string> judged;
  const auto judge = [&](const Study& s) {
    std::map<std::string, std::pair<std::string, std::string>> said;
    for (const RegionVerdict& v : judge_region(s, ids)) {
      INFO(v.claim->id);
      CHECK(!v.judgement.predicted.empty());
      CHECK(!v.judgement.found.empty());
      CHECK(v.judgement.checks > 0);
      judged.insert(v.claim->id);
      said[v.claim->id] = {v.judgement.predicted, v.judgement.found};
    }
    return said;
  };
  // tau and K by hand, as Theorems 7.2 to 7.4 write them.
  const auto digon = judge(study_of(theory::kDigon, sides({6, 6})));
  CHECK(digon.at("T2").first == "tau(6) = N (N - 1) = 6 with N = 3, 10 edges with the v2");
  CHECK(digon.at("T2").second ==
        "moves: 6 configurations, 10 edges with the v2; search: 6 fillings; walk: 6 configurations, 10 of 10 edges");
  CHECK(digon.at("P2").second == "20 of 20 moves");
  CHECK(digon.at("N2").first == "even distances, room to merge into a v2");
  CHECK(digon.at("N2").second == "even distances, 6 of 6 configurations merge, slides align 6");
  CHECK(digon.at("M1").second == "6 reached from (1,1), and 6 of 6 fillings that search finds");
  const auto hexagon = judge(study_of(theory::kHexagon, sides({5, 5, 5, 5, 5, 5})));
  CHECK(hexagon.at("T3").first == "tau(5) = 3 N^2 = 12 with N = 2, 18 edges");
  CHECK(hexagon.at("L9").first == "6 sides, as G = -2");
  const auto other = judge(study_of(theory::kDigon, sides({5, 9})));
  CHECK(other.at("T2").first == "exactly 4, at most tau(9) = N^2 = 16 with N = 4, 6 edges");
  CHECK(judge(study_of(theory::kQuad, sides({6, 5, 5, 8}))).at("T4").first == "K = 4 x 3 = 12, 17 edges");
  judge(study_of(theory::kQuad, sides({5, 4, 4, 5})));
  for (const int valence : {2, 3, 4, 5, 6}) judge(study(VertexCase{theory::IntegerVector::Constant(valence, 6)}, kAll));
  judge(study(TripleCase{{3, 3, 5}, sides({4, 4, 4})}, kAll));
  CHECK(judged.size() == claims().size());
}

TEST_CASE("a violation is reported with where it is and with the region's numbers", "[verify]") {
  PairStudy s = study_of(theory::kDigon, sides({6, 6}));
  const auto made = std::find_if(s.found.moves.begin(), s.found.moves.end(), [](const auto& m) { return m.to >= 0; });
  ++made->faces_made;
  const RegionVerdict verdict = judge_region(s, {"P3"}).front();
  CHECK(verdict.judgement.found == "19 of 20 moves");
  const std::string where = described(*verdict.judgement.violation);
  CHECK(where == "configuration (1,1), move " + std::string(mesh::name(made->move.step)) +
                     ": the reported faces are not those by which the mesh grew");

  CampaignResult campaign;
  ClaimResult& c = campaign.claims.emplace_back();
  c.claim = verdict.claim;
  c.instances = 1;
  c.violation = verdict.judgement.violation;
  c.violating_region = PairCase{s.shape};
  c.predicted = verdict.judgement.predicted;
  c.found = verdict.judgement.found;
  const auto json = report_json(campaign, small_ranges())["claims"][0]["counterexample"];
  CHECK(json["found"] == "19 of 20 moves");
  CHECK(json["predicted"] == verdict.judgement.predicted);
  const std::string text = unbroken_report(campaign);
  CHECK(text.find("P3 fails: 3-3 region with sides 6 6: " + where + "\n  predicted: " + c.predicted +
                  "\n  found: 19 of 20 moves\n") != std::string::npos);
  CHECK(report_html(campaign, small_ranges()).find("<br>Found: 19 of 20 moves</p>") != std::string::npos);
}

// By hand: a grid of 3 x 3 quads has 6 x 6 rectangles.
TEST_CASE("the convex regions inside a mesh are all found", "[verify]") {
  const mesh::Region grid = tests::grid(3, 3);
  const auto regions = convex_subregions(grid.mesh, BoundaryIrregular::none);
  CHECK(regions.size() == 36);
  std::set<std::vector<bool>> different;
  for (const ConvexSubregion& region : regions) {
    std::vector<bool> faces;
    for (std::size_t f = 0; f < region.faces.size(); ++f) faces.push_back(region.faces.test(f));
    CHECK(different.insert(faces).second);
    const auto around = sides_of(grid.mesh, region.faces);
    REQUIRE(around.size() == 4);
    CHECK(around[0].size() * around[1].size() == region.faces.count());
    CHECK(around[0].size() == around[2].size());
  }
  // Three quads round a v3: all of them; with the v3 on the boundary, where it is straight, each single one.
  const mesh::QuadMesh corner =
      mesh::QuadMesh::from_faces(7, tests::FaceList{{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 1}});
  CHECK(convex_subregions(corner, BoundaryIrregular::none).size() == 1);
  const auto with_v3 = convex_subregions(corner, BoundaryIrregular::convex);
  CHECK(with_v3.size() == 4);
  for (const ConvexSubregion& region : with_v3) {
    CHECK(region.inside.size() + region.on_boundary.size() == 1);
    CHECK(sides_of(corner, region.faces).size() == 3);
  }
}
