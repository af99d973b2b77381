// The library of requad-verify: claims hold on small ranges, and each claim fails if its facts are falsified.
#include "enumerate/generators.hpp"
#include "enumerate/search/search.hpp"
#include "mesh/topology/signature.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/theory/integer_vector.hpp"
#include "verify/claims/convex_subregions.hpp"
#include "verify/errata.hpp"
#include "verify/report.hpp"
#include "verify/sentences.hpp"

using namespace requad;
using namespace requad::verify;
using requad::tests::sides;

namespace {

const Claim& claim(const std::string& id) {
  const Claim* const found = find_claim(id);
  if (found == nullptr) throw std::logic_error("no claim " + id);
  return *found;
}

const std::set<Method> kAll{Method::moves, Method::search, Method::walk};

PairStudy study_of(theory::PairType type, const theory::IntegerVector& s) { return study_pair({type, s}, kAll); }

// Checks that a claim holds for this study, and fails after the study is falsified.
template <class Kind, class Falsify>
void fails(const std::string& id, Kind s, Falsify falsify) {
  INFO(id);
  REQUIRE_FALSE(claim(id).judge(s).violation.has_value());
  falsify(s);
  const Judgement j = claim(id).judge(s);
  REQUIRE(j.violation.has_value());
  CHECK(!j.violation->what.empty());
  CHECK(!j.predicted.empty());
  CHECK(!j.found.empty());
}

Ranges small_ranges() {
  Ranges r;
  r.digon = {3, 8};
  r.hexagon = {3, 5};
  r.quad_perimeter = {8, 20};
  r.other_perimeter = {4, 16};
  return r;
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

CampaignResult run_small(int threads) {
  std::vector<const Claim*> all;
  std::set<Family> families;
  for (const Claim& c : claims()) {
    all.push_back(&c);
    families.insert(c.families.begin(), c.families.end());
  }
  return run_campaign(all, list_cases(small_ranges(), families), kAll, {.threads = threads, .quiet = true});
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
  for (int perimeter = 6; perimeter <= 16; perimeter += 2) {
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
  const std::string line = "non-regular hexagons of perimeter 4..16: " + std::to_string(hexagons) + " regions, " +
                           std::to_string(hexagons) + " searched, " + std::to_string(empty) + " of these empty\n";
  CHECK(report_text(campaign, small_ranges()).find(line) != std::string::npos);
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

TEST_CASE("the HTML report has a section for each claim and is self-contained", "[verify]") {
  const std::string html = report_html(run_small(2), small_ranges());
  for (const Claim& c : claims()) CHECK(html.find("<h2 id=\"" + c.id + "\">") != std::string::npos);
  for (const char* outside : {"http:", "https:", "<script", "<link", "src="})
    CHECK(html.find(outside) == std::string::npos);
  CHECK(html.find("</html>") != std::string::npos);
}

TEST_CASE("errata come with instances", "[verify]") {
  const auto errata = find_errata();
  CHECK(errata.size() == 6);
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
  const std::string text = report_text(campaign, small_ranges());
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

// A check that cannot fail is worse than none. So this test falsifies the facts that each check reads, one by one.
TEST_CASE("each claim fails on falsified facts", "[verify]") {
  const PairStudy digon = study_of(theory::kDigon, sides({6, 6}));
  const PairStudy hexagon = study_of(theory::kHexagon, sides({5, 5, 5, 5, 5, 5}));
  const PairStudy quad = study_of(theory::kQuad, sides({5, 4, 4, 7}));
  const auto first_made = [](PairStudy& s) -> enumerate::FoundMove& {
    return *std::find_if(s.found.moves.begin(), s.found.moves.end(), [](const auto& m) { return m.to >= 0; });
  };
  const auto first_refused = [](PairStudy& s) -> enumerate::FoundMove& {
    return *std::find_if(s.found.moves.begin(), s.found.moves.end(), [](const auto& m) { return m.to < 0; });
  };
  const auto lose_last_node = [](PairStudy& s) {
    const int last = static_cast<int>(s.found.nodes.size()) - 1;
    s.found.nodes.pop_back();
    s.predicted_of.pop_back();
    std::erase_if(s.found.moves, [last](const auto& m) { return m.from == last || m.to == last; });
  };
  for (const auto& [id, s] : {std::pair{"T2", digon}, std::pair{"T3", hexagon}, std::pair{"T4", quad}}) {
    fails(id, s, lose_last_node);
    fails(id, s, [](PairStudy& x) { ++x.exact_count; });
    fails(id, s, [](PairStudy& x) { x.predicted_of[0] = -1; });
    fails(id, s, [](PairStudy& x) { std::swap(x.predicted_of[0], x.predicted_of[1]); });
    fails(id, s,
          [&](PairStudy& x) { x.found.moves.erase(x.found.moves.begin() + (&first_made(x) - x.found.moves.data())); });
    fails(id, s, [&](PairStudy& x) { first_made(x).restored = false; });
    fails(id, s, [&](PairStudy& x) { first_made(x).inverse_returns = false; });
    fails(id, s, [&](PairStudy& x) { first_refused(x).refused_unchanged = false; });
    fails(id, s, [&](PairStudy& x) { first_made(x).after->parameters.d1 += 2; });
    fails(id, s, [&](PairStudy& x) { first_made(x).after.reset(); });
    fails(id, s, [&](PairStudy& x) { x.found.moves.push_back(first_made(x)); });
    fails(id, s, [](PairStudy& x) { x.searched->pop_back(); });
    fails(id, s, [](PairStudy& x) { x.searched->front() += "0"; });
  }
  fails("T2", digon, [](PairStudy& x) { x.searched_merged->clear(); });
  // The predicted order of the moves round a node, of a rectangle, of a segment and of a merged v6, is another one.
  const auto swap_two_moves = [](theory::MapNode& node) {
    std::swap(node.moves[0], node.moves[1]);
    std::swap(node.labellings[0], node.labellings[1]);
    std::swap(node.steps[0], node.steps[1]);
  };
  const auto swap_where = [&](auto wanted) {
    return [&swap_two_moves, wanted](PairStudy& x) {
      swap_two_moves(*std::find_if(x.map.nodes.begin(), x.map.nodes.end(), [&](const theory::MapNode& node) {
        const bool all_made =
            std::all_of(node.moves.begin(), node.moves.end(), [](auto dart) { return dart.target >= 0; });
        return all_made && wanted(node.configuration);
      }));
    };
  };
  const auto rectangle = [](const theory::Configuration& c) { return !c.degenerate(); };
  const auto segment = [](const theory::Configuration& c) { return c.degenerate() && !c.merged(); };
  const PairStudy even = study_of(theory::kHexagon, sides({6, 6, 6, 6, 6, 6}));
  fails("T2", study_of(theory::kDigon, sides({7, 7})), swap_where(rectangle));
  fails("T2", digon, swap_where(segment));
  fails("T3", even, swap_where(rectangle));
  fails("T3", even, swap_where([](const theory::Configuration& c) { return c.merged(); }));
  fails("T4", study_of(theory::kQuad, sides({6, 5, 5, 8})), swap_where(rectangle));
  // The edges along which a v6 is parted are found in another order.
  const auto swap_parting = [](PairStudy& x) {
    std::vector<enumerate::FoundMove*> parting;
    for (enumerate::FoundMove& move : x.found.moves) {
      if (!x.found.holds_pair(move.from)) parting.push_back(&move);
    }
    REQUIRE(parting.size() == 3);
    std::swap(parting[0]->move.frame, parting[1]->move.frame);
  };
  fails("T3", even, swap_parting);
  fails("F1", even, swap_parting);
  const auto other_d1 = [&](PairStudy& x) {
    auto& reading = x.found.nodes[static_cast<std::size_t>(first_made(x).to)].reading;
    reading.configuration.parameters.d1 += 3;
    for (auto& f : reading.frames) f.labelling.parameters.d1 += 3;
  };
  fails("P1", quad, other_d1);
  fails("P1", quad, [](PairStudy& x) { x.found.moves.pop_back(); });
  fails("P1", quad, [&](PairStudy& x) {
    first_made(x) = *std::find_if(x.found.moves.begin(), x.found.moves.end(), [&](const auto& m) {
      return m.to >= 0 && &m != &first_made(x) && m.from == first_made(x).from;
    });
  });
  fails("P2", digon, other_d1);
  fails("P2", hexagon, other_d1);
  fails("P3", hexagon, [&](PairStudy& x) { ++first_made(x).faces_made; });
  fails("P3", digon, [](PairStudy& x) { ++x.found.nodes[0].reading.configuration.parameters.d1; });
  fails("P3", quad, [&](PairStudy& x) { ++first_made(x).move.frame.d2; });
  fails("N4", hexagon, [&](PairStudy& x) { ++first_made(x).operations; });
  fails("N4", quad, [&](PairStudy& x) { std::swap(first_made(x).before, first_made(x).after); });
  fails("G1", digon, [](PairStudy& x) {
    // Every valid mesh obeys the law. So this mesh has lost a vertex from its arrays, and the sum lacks its index.
    const auto& m = x.found.nodes[0].region.mesh;
    std::vector<mesh::HalfEdgeId> twin, out;
    std::vector<mesh::VertexId> origin;
    for (int h = 0; h < m.half_edge_capacity(); ++h) {
      twin.push_back(m.twin(mesh::HalfEdgeId(h)));
      origin.push_back(m.origin(mesh::HalfEdgeId(h)));
    }
    for (int v = 0; v < m.vertex_capacity(); ++v) out.push_back(m.out(mesh::VertexId(v)));
    out.back() = mesh::HalfEdgeId();
    x.found.nodes[0].region.mesh = mesh::QuadMesh::from_arrays_unchecked(twin, origin, out);
  });
  fails("L8", digon,
        [](PairStudy& x) { x.found.nodes[0].reading.frames.push_back(x.found.nodes[0].reading.frames[0]); });
  fails("L8", hexagon, [](PairStudy& x) { ++x.found.nodes[0].reading.frames[0].frame.d2; });
  fails("L9", digon, [](PairStudy& x) {
    // Three quads in the shape of an L have five corners and no curvature.
    x.found.nodes[0].region = {mesh::QuadMesh::from_faces(8, tests::FaceList{{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}}),
                               mesh::HalfEdgeId(0)};
  });
  fails("L10", hexagon, [](PairStudy& x) { std::swap(x.found.nodes[0].signature, x.found.nodes[1].signature); });
  fails("T11", quad, [](PairStudy& x) {
    x.found.nodes[1].region = x.found.nodes[0].region;
    x.found.nodes[1].reading.frames = x.found.nodes[0].reading.frames;
  });
  fails("T11", hexagon, [](PairStudy& x) { ++x.found.nodes[0].reading.frames[0].labelling.parameters.e(2); });
  const auto swap_extents = [](PairStudy& x) {
    for (auto& node : x.found.nodes) {
      theory::StripParameters& p = node.reading.frames[0].labelling.parameters;
      std::swap(p.d1, p.d2);
    }
  };
  fails("U2", digon, swap_extents);
  fails("U3", even, swap_extents);
  for (const char* id : {"L8", "D5", "S1"}) {
    fails(id, study_of(theory::kQuad, sides({3, 2, 2, 3})),
          [](PairStudy& x) { x.found.nodes[0].signature = mesh::signature(tests::grid(3, 3)); });
  }
  fails("M1", hexagon, lose_last_node);
  // Several starts: every configuration is there, but no moves join them.
  const auto forget_moves = [](PairStudy& x) { x.found.moves.clear(); };
  fails("M1", study_moves(enumerate::explore_all({theory::kDigon, sides({6, 6})}, theory::Apex::with)), forget_moves);
  fails("M1", digon, [](PairStudy& x) { x.searched->push_back(mesh::signature(tests::grid(3, 3))); });
  fails("R1", quad, [](PairStudy& x) { x.found.nodes[0].signature += "0"; });
  fails("F1", digon, [](PairStudy& x) { ++x.found.nodes[0].reading.configuration.parameters.d1; });
  fails("F1", digon,
        [&](PairStudy& x) { x.found.moves.erase(x.found.moves.begin() + (&first_made(x) - x.found.moves.data())); });
  fails("F1", hexagon, lose_last_node);
  fails("N1", quad, [](PairStudy& x) { x.shape = {theory::kQuad, sides({5, 4, 5, 4})}; });
  fails("N1", quad, [](PairStudy& x) { x.found.nodes[0].region = tests::grid(3, 3); });
  fails("N1", quad, [](PairStudy& x) { x.found.nodes[0].reading.irregular.pop_back(); });
  fails("N2", digon, [](PairStudy& x) { ++x.found.nodes[0].reading.configuration.parameters.d1; });
  fails("N2", digon, [](PairStudy& x) {
    std::erase_if(x.found.moves, [&](const auto& m) { return m.to >= 0 && !x.found.holds_pair(m.to); });
  });

  // The found graph lacks the moves out of merged configurations. So a distance differs from the length of a path.
  fails("R1", digon, [&](PairStudy& x) {
    std::erase_if(x.found.moves, [&](const auto& m) { return m.to >= 0 && !x.found.holds_pair(m.from); });
  });

  // Claims about one irregular vertex: another vertex is in its place, or configurations are missing.
  const auto single = [](int valence, theory::Integer length) {
    const RegionCase region = VertexCase{theory::IntegerVector::Constant(valence, length)};
    return std::get<VertexStudy>(study(region, kAll));
  };
  fails("T1", single(5, 4), [](VertexStudy& x) { x.searched->clear(); });
  fails("T1", single(5, 4), [](VertexStudy& x) { x.glued.clear(); });
  fails("T1", single(8, 3), [](VertexStudy& x) { x.searched->pop_back(), x.glued.pop_back(); });
  fails("T1", single(5, 4),
        [](VertexStudy& x) { x.glued.push_back(x.glued[0]), x.searched->push_back(x.searched->front()); });
  const auto instead = [](const VertexStudy& other) { return [other](VertexStudy& x) { x.glued = other.glued; }; };
  fails("A2", single(3, 6), [&](VertexStudy& x) { x.glued = single(5, 6).glued; });
  fails("A3", single(4, 6), instead(single(5, 6)));
  fails("N5", single(4, 8), instead(single(5, 6)));
  fails("B1", single(5, 6), [&](VertexStudy& x) { x.glued = single(3, 6).glued; });
  fails("A6", single(5, 6), [&](VertexStudy& x) { x.glued = single(6, 6).glued; });
  fails("A4", single(2, 6), instead(single(3, 6)));
  fails("A4", single(6, 6), instead(single(7, 8)));
  // This region has a v3 and a far v5. Claims about the neighbourhood of a vertex do not apply where other vertices are
  // irregular.
  VertexStudy not_single = single(3, 6);
  not_single.glued = {quad.found.nodes[0].region};
  CHECK_FALSE(claim("B1").judge(not_single).applies);
  fails("P4", digon, [](PairStudy& x) {
    // The configuration that the transport should make is missing.
    for (auto& node : x.found.nodes) node.signature += "0";
  });
  fails("P4", quad, [&](PairStudy& x) {
    for (auto& node : x.found.nodes) node.signature += "0";
  });
  const auto three = [](const theory::IntegerVector& s) {
    return std::get<TripleStudy>(study(TripleCase{{3, 3, 5}, s}, kAll));
  };
  const TripleStudy equal = three(sides({4, 4, 4}));
  REQUIRE(equal.fewer.at({3}).size() == 1);
  fails("N3", equal, [](TripleStudy& x) { x.fewer.erase({3}); });
  fails("N3", equal, [](TripleStudy& x) { x.fewer.at({3}).front() += "0"; });
  const TripleStudy other = three(sides({2, 4, 6}));
  REQUIRE(other.fewer.count({2, 5}) == 1);
  fails("N3", other, [](TripleStudy& x) { x.fewer.erase({2, 5}); });
  fails("N3", other, [](TripleStudy& x) { x.fewer[{3}].push_back("0"); });
  // An edit that makes something unknown, fillings that no edit joins to the rest, and fillings from which no edit leads
  // to fewer vertices.
  fails("N3", equal, [](TripleStudy& x) { x.edits.front().push_back({{3, 3, 5}, "0"}); });
  fails("N3", other, [](TripleStudy& x) { x.edits.back().push_back({{2, 5}, "0"}); });
  fails("N3", three(sides({4, 5, 5})), [](TripleStudy& x) {
    for (auto& edits : x.edits) edits.clear();
  });
  const auto three_v5 = [](const theory::IntegerVector& s) {
    return std::get<TripleStudy>(study(TripleCase{{5, 5, 5}, s}, kAll));
  };
  // No filling has fewer irregular vertices. This is the region of the erratum.
  const TripleStudy no_room = three_v5(sides({2, 2, 3, 3, 2, 2, 4}));
  CHECK(no_room.fewer.empty());
  CHECK(claim("N3").judge(no_room).row["not_edited"] == no_room.signatures);
  CHECK(find_errata().back().instance.find("sides 2 2 3 3 2 2 4") != std::string::npos);
  CHECK(find_errata().back().instance.find(no_room.signatures.front()) != std::string::npos);
  fails("N3", no_room, [](TripleStudy& x) { x.fewer[{5, 6}].push_back("0"); });
  const TripleStudy room = three_v5(sides({2, 3, 2, 4, 2, 3, 4}));
  fails("N3", room, [](TripleStudy& x) { x.fewer.clear(); });
  // Claim A1 for a pair that is not adjacent.
  const PairStudy adjacent = study_of(theory::kQuad, sides({5, 4, 4, 5}));
  fails("A1", adjacent, [&](PairStudy& x) {
    for (auto& node : x.found.nodes)
      node.region = enumerate::glue_region(theory::kQuad, {{2, 1, theory::IntegerVector::Constant(4, 2)}, 1});
  });
}
