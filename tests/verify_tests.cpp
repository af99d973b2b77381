// requad-verify's library: claims hold on small ranges, and each claim fails when its facts are falsified.
#include "enumerate/generators.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"
#include "verify/report.hpp"

using namespace requad;
using namespace requad::verify;
using requad::tests::sides;

namespace {

const Claim& claim(const std::string& id) {
  for (const Claim& c : claims()) {
    if (c.id == id) return c;
  }
  throw std::logic_error("no claim " + id);
}

Study study_of(Family family, theory::PairType type, const theory::IntegerVector& s) { return study({family, type, s}); }

Ranges small_ranges() {
  Ranges r;
  r.digon = {3, 8};
  r.hexagon = {3, 5};
  r.quad_perimeter = {8, 16};
  r.other_perimeter = {4, 16};
  return r;
}

CampaignResult run_small(int threads) {
  std::vector<const Claim*> all;
  std::set<Family> families;
  for (const Claim& c : claims()) {
    all.push_back(&c);
    families.merge(families_of(c.id));
  }
  return run_campaign(all, list_cases(small_ranges(), families), threads, true);
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

TEST_CASE("the report has the keys that others rely on", "[verify]") {
  const auto json = report_json(run_small(2), small_ranges());
  CHECK(json["passed"] == true);
  CHECK(json["claims"].size() == 16);
  for (const auto& c : json["claims"]) {
    for (const char* key : {"id", "statement", "verdict", "instances", "range", "methods", "seconds", "counterexample", "table"}) {
      CHECK(c.contains(key));
    }
    CHECK(c["verdict"] == "holds");
    CHECK(c["counterexample"].is_null());
    CHECK(!c["table"].empty());
  }
}

// A check that can not fail is worse than none: falsify the facts it looks at, one by one.
TEST_CASE("each claim fails on falsified facts", "[verify]") {
  const Study digon = study_of(Family::regular_digon, theory::kDigon, sides({6, 6}));
  const Study hexagon = study_of(Family::regular_hexagon, theory::kHexagon, sides({5, 5, 5, 5, 5, 5}));
  const Study quad = study_of(Family::quad, theory::kQuad, sides({5, 4, 4, 7}));
  const auto fails = [](const std::string& id, Study s, auto falsify) {
    INFO(id);
    REQUIRE_FALSE(claim(id).judge(s).violation.has_value());
    falsify(s);
    const Judgement j = claim(id).judge(s);
    REQUIRE(j.violation.has_value());
    CHECK(!j.violation->what.empty());
  };
  const auto first_made = [](Study& s) -> enumerate::FoundMove& {
    return *std::find_if(s.found.moves.begin(), s.found.moves.end(), [](const auto& m) { return m.to >= 0; });
  };
  const auto first_refused = [](Study& s) -> enumerate::FoundMove& {
    return *std::find_if(s.found.moves.begin(), s.found.moves.end(), [](const auto& m) { return m.to < 0; });
  };
  const auto lose_last_node = [](Study& s) {
    const int last = static_cast<int>(s.found.nodes.size()) - 1;
    s.found.nodes.pop_back();
    s.predicted_of.pop_back();
    std::erase_if(s.found.moves, [last](const auto& m) { return m.from == last || m.to == last; });
  };
  for (const auto& [id, s] : {std::pair{"T2", digon}, std::pair{"T3", hexagon}, std::pair{"T4", quad}}) {
    fails(id, s, lose_last_node);
    fails(id, s, [](Study& x) { ++x.exact_count; });
    fails(id, s, [](Study& x) { x.predicted_of[0] = -1; });
    fails(id, s, [](Study& x) { std::swap(x.predicted_of[0], x.predicted_of[1]); });
    fails(id, s, [&](Study& x) { x.found.moves.erase(x.found.moves.begin() + (&first_made(x) - x.found.moves.data())); });
    fails(id, s, [&](Study& x) { first_made(x).restored = false; });
    fails(id, s, [&](Study& x) { first_made(x).inverse_returns = false; });
    fails(id, s, [&](Study& x) { first_refused(x).refused_unchanged = false; });
    fails(id, s, [&](Study& x) { first_made(x).after.parameters.d1 += 2; });
  }
  fails("P1", quad, [&](Study& x) { ++first_made(x).after.parameters.d1; });
  fails("P1", quad, [](Study& x) { x.found.moves.pop_back(); });
  fails("P2", digon, [&](Study& x) { first_made(x).after.parameters.d2 += 3; });
  fails("P3", hexagon, [&](Study& x) { ++first_made(x).faces_made; });
  fails("G1", digon, [](Study& x) {
    // Every valid mesh keeps the law, so take one whose arrays have lost a vertex: its index is missing from the sum.
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
  fails("L8", digon, [](Study& x) { x.found.nodes[0].reading.frames.push_back(x.found.nodes[0].reading.frames[0]); });
  fails("L8", hexagon, [](Study& x) { ++x.found.nodes[0].reading.frames[0].frame.a; });
  fails("L9", digon, [](Study& x) {
    // An L of three quads: five corners, no curvature.
    x.found.nodes[0].region = {mesh::QuadMesh::from_faces(8, tests::FaceList{{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}}), mesh::HalfEdgeId(0)};
  });
  fails("L10", hexagon, [](Study& x) { std::swap(x.found.nodes[0].signature, x.found.nodes[1].signature); });
  fails("T11", quad, [](Study& x) {
    x.found.nodes[1].region = x.found.nodes[0].region;
    x.found.nodes[1].reading.frames = x.found.nodes[0].reading.frames;
  });
  fails("M1", hexagon, lose_last_node);
  fails("R1", quad, [](Study& x) { x.found.nodes[0].signature += "0"; });
  fails("F1", digon, [](Study& x) { ++x.found.nodes[0].reading.configuration.parameters.d1; });
  fails("F1", digon, [](Study& x) { x.map.nodes.front().moves.front() = {}; });
  fails("F1", hexagon, lose_last_node);
  fails("N1", quad, [](Study& x) { x.region.sides = sides({5, 4, 5, 4}); });
  fails("N1", quad, [](Study& x) { x.found.nodes[0].reading.irregular.pop_back(); });
  fails("N2", digon, [](Study& x) { ++x.found.nodes[0].reading.configuration.parameters.d1; });
  fails("N2", digon, [](Study& x) {
    std::erase_if(x.found.moves, [&](const auto& m) { return m.to >= 0 && !x.found.holds_pair(m.to); });
  });
}
