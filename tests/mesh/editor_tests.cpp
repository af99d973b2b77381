// Editors, features, transport and the complementary operations, on generated meshes.
#include <map>
#include <random>

#include "enumerate/exploration.hpp"
#include "enumerate/generators.hpp"
#include "enumerate/search/search.hpp"
#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/topology/distances.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/support.hpp"

using namespace requad;
using namespace requad::mesh;
using requad::tests::irregular_valences;
using requad::tests::random_operation;
using requad::tests::random_positions;
using requad::tests::sides;

namespace {

const theory::Configuration kHexagonStart{{2, 2, theory::IntegerVector::Constant(6, 2)}, 1};

}  // namespace

TEST_CASE("Laws editing-1 to editing-4: random edits keep features and fixed positions, and roll back bit by bit",
          "[editor]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const Region start = enumerate::glue_region(theory::kHexagon, kHexagonStart);
    QuadMesh m = start.mesh;
    Positions positions = random_positions(m, random);
    const Positions before = positions;
    FeatureSet features;
    const auto inner = m.half_edges();
    for (int i = 0; i < 6; ++i) {
      const HalfEdgeId h = inner[random() % inner.size()];
      features.insert(m.origin(h), m.target(h));
    }
    Editor editor(m, &features, &positions);
    int refused_for_features = 0;
    for (int i = 0; i < 400; ++i) {
      const BasicOperation op = random_operation(m, random);
      const QuadMesh kept = m;
      const Refusal refusal = editor.run(op).refusal;
      if (refusal != Refusal::none) REQUIRE(m == kept);
      if (refusal == FeatureRefusal::breaks_feature) {
        ++refused_for_features;
        // Law editing-5 says no more than needed: the operation does break the feature.
        QuadMesh broken = m;
        REQUIRE(apply(broken, op).refusal == Refusal::none);
        const auto edges = features.edges();
        const bool all = std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
          return broken.is_live(e[0]) && broken.is_live(e[1]) && broken.adjacent(e[0], e[1]);
        });
        CHECK_FALSE(all);
      }
    }
    CHECK(refused_for_features > 0);
    CHECK(validate(m).empty());
    CHECK(editor.mark() > 50);
    for (const auto& [a, b] : features.edges()) {
      REQUIRE(m.is_live(a));
      REQUIRE(m.is_live(b));
      CHECK(m.adjacent(a, b));
      CHECK(positions[a.slot()] == before[a.slot()]);
    }
    for (const VertexId v : start.mesh.vertices()) {
      if (start.mesh.is_boundary(v)) CHECK(positions[v.slot()] == before[v.slot()]);
    }
    editor.roll_back();
    CHECK(m == start.mesh);
    for (const VertexId v : m.vertices()) CHECK(positions[v.slot()] == before[v.slot()]);
  }
}

TEST_CASE("Law editing-2: a move from 0 to -0 is a move, and is taken back", "[editor]") {
  QuadMesh m = tests::torus(3, 3);
  Positions positions(9, Eigen::Vector3d::Zero());
  Editor editor(m, nullptr, &positions);
  const std::array moved{VertexId(4)};
  editor.rearrange(moved, [](Positions& p) { p[4].y() = -0.0; });
  REQUIRE(editor.edits().size() == 1);
  editor.rearrange(moved, [](Positions&) {});
  CHECK(editor.edits().size() == 1);
  editor.roll_back();
  CHECK(same_bits(positions[4], Eigen::Vector3d::Zero()));
}

TEST_CASE("Law irregular-1: a step changes the valences of both positions of the adjacent pair and no other",
          "[transport]") {
  // By hand: u gains and v loses an edge, the next u loses and the next v gains one.
  const Region start = enumerate::glue_region(theory::kQuad, {{1, 0, theory::IntegerVector::Constant(4, 3)}, 1});
  const auto pair = irregular_vertices(start.mesh);
  REQUIRE(pair.size() == 2);
  const VertexId three = start.mesh.valence(pair[0]) == 3 ? pair[0] : pair[1];
  const VertexId five = three == pair[0] ? pair[1] : pair[0];
  const HalfEdgeId edge = start.mesh.find_half_edge(three, five);
  for (const TransportStep step : kTransportSteps) {
    for (const bool other_names : {false, true}) {
      INFO(name(step.kind) << (step.hand == Hand::left ? " left" : " right"));
      QuadMesh m = start.mesh;
      PlannedStep planned = plan(m, {edge}, step);
      if (other_names) planned = renamed(m, planned);
      REQUIRE(apply(m, planned.operation).refusal == Refusal::none);
      const AdjacentPair now = planned.next;
      CHECK(irregular_valences(m) == std::map<int, int>{{3, 1}, {5, 1}});
      CHECK(m.valence(now.u(m)) == 3);
      CHECK(m.valence(now.v(m)) == 5);
      if (step.kind != TransportStep::Kind::collapse || other_names) CHECK(now.v(m) == planned.next_v);
      // Both choices of names make the same mesh.
      QuadMesh same = start.mesh;
      apply(same, plan(same, {edge}, step).operation);
      const VertexId root = start.mesh.origin(start.root);
      CHECK(signature(m, m.out(root)) == signature(same, same.out(root)));
    }
  }
}

TEST_CASE("Transport goes as the pair moves do where nothing is in the way", "[transport]") {
  // Transport reaches every configuration that pair moves reach in one step, and no other.
  const theory::Configuration start{{1, 1, theory::IntegerVector::Constant(6, 2)}, 1};
  const auto found = enumerate::explore({theory::kHexagon, theory::region_sides(theory::kHexagon, start)},
                                        {enumerate::glue_region(theory::kHexagon, start)});
  std::map<int, std::set<std::string>> by_moves, by_transport;
  for (const auto& move : found.moves) {
    if (move.to >= 0 && found.holds_pair(move.to) && found.holds_pair(move.from))
      by_moves[move.from].insert(found.nodes[static_cast<std::size_t>(move.to)].signature);
  }
  for (std::size_t i = 0; i < found.nodes.size(); ++i) {
    if (!found.holds_pair(static_cast<int>(i))) continue;
    const Region& region = found.nodes[i].region;
    QuadMesh m = region.mesh;
    Editor editor(m);
    PairTransport transport(editor);
    const auto pair = irregular_vertices(m);
    for (int k = 0; k < 2; ++k) {
      std::vector<HalfEdgeId> starts;
      m.for_each_out(pair[static_cast<std::size_t>(k)], [&](HalfEdgeId h) { starts.push_back(m.twin(h)); });
      for (const HalfEdgeId first : starts) {
        if (transport.carry({first}, std::array{pair[static_cast<std::size_t>(1 - k)]}).refusal != Refusal::none)
          continue;
        CHECK(validate(m).empty());
        by_transport[static_cast<int>(i)].insert(signature(m, m.out(region.mesh.origin(region.root))));
        editor.roll_back();
        CHECK(m == region.mesh);
      }
    }
  }
  std::set<std::string> known;
  for (const auto& node : found.nodes) known.insert(node.signature);
  int same = 0;
  for (const auto& [node, results] : by_transport) {
    for (const auto& result : results) CHECK(known.count(result) == 1);
    same += std::includes(results.begin(), results.end(), by_moves[node].begin(), by_moves[node].end()) ? 1 : 0;
  }
  CHECK(by_moves.size() > 4);
  CHECK(same > 0);
}

TEST_CASE("Section 8: a 3-5 pair is cancelled with a third vertex, never without", "[complementary]") {
  // 6,6,6 has 75 fillings with 3-3-5 and one with a single v3 (exhaustive search).
  enumerate::SearchLimits limits;
  limits.threads = 1;
  int fillings = 0;
  enumerate::search(enumerate::search_problem({6, 6, 6}, {3, 3, 5}), limits, [&](const enumerate::Filling& f) {
    ++fillings;
    const Region region = enumerate::region_of(f);
    QuadMesh m = region.mesh;
    Editor editor(m);
    PairTransport transport(editor);
    std::vector<VertexId> threes;
    VertexId five;
    for (const VertexId v : irregular_vertices(m)) {
      if (m.valence(v) == 5) five = v;
      if (m.valence(v) == 3) threes.push_back(v);
    }
    CHECK(cancel_pair(editor, transport, threes[0], five, {}).refusal == EditRefusal::lone_pair);
    CHECK(cancel_pair(editor, transport, five, threes[0], {threes[1]}).refusal == EditRefusal::wrong_valences);
    CHECK(m == region.mesh);
    const Cancellation done = cancel_pair(editor, transport, threes[0], five, {threes[1]});
    REQUIRE(done.refusal == Refusal::none);
    CHECK(done.transports >= graph_distance(region.mesh, threes[0], five));
    CHECK(irregular_valences(m) == std::map<int, int>{{3, 1}});
    CHECK(done.helpers == irregular_vertices(m));
    CHECK(m.vertex_count() - m.face_count() == region.mesh.vertex_count() - region.mesh.face_count());
  });
  CHECK(fillings == 75);
}

TEST_CASE("Section 8: merging and aligning, and why not", "[complementary]") {
  const auto irregular_of = [](const QuadMesh& m) { return irregular_vertices(m); };
  for (const auto& [type, merged] : {std::pair{theory::kDigon, 2}, std::pair{theory::kHexagon, 6}}) {
    for (const theory::Configuration& c : theory::parameter_set(theory::RegionShape::regular(type, 7 + merged % 4))) {
      const Region region = enumerate::glue_region(type, c);
      QuadMesh m = region.mesh;
      Editor editor(m);
      auto pair = irregular_of(m);
      const PairResult aligned = align_pair(editor, pair[0], pair[1]);
      REQUIRE(aligned.refusal == Refusal::none);
      CHECK(aligned.frame.degenerate());
      pair = irregular_of(m);
      CHECK(pair.size() == 2);
      const PairResult result = merge_pair(editor, pair[0], pair[1]);
      if ((c.d1() + c.d2()) % 2 == 0) {
        REQUIRE(result.refusal == Refusal::none);
        CHECK(irregular_valences(m) == std::map<int, int>{{merged, 1}});
        // Back into a pair, at once (Figure 5).
        CHECK(part_vertex(editor, irregular_of(m)[0]) == Refusal::none);
        CHECK(irregular_valences(m) == std::map<int, int>{{merged == 2 ? 3 : 5, 2}});
      } else {
        CHECK(result.refusal == EditRefusal::odd_distance);
      }
      editor.roll_back();
      CHECK(m == region.mesh);
      CHECK(merge_pair(editor, pair[0], pair[0]).refusal == EditRefusal::wrong_valences);
    }
  }
}

TEST_CASE("Any valence is parted into v3s and v5s", "[complementary]") {
  for (int valence = 6; valence <= 12; ++valence) {
    const theory::PairType type{valence + 1, 3};
    const Region region = enumerate::glue_region(type, {{0, 0, theory::IntegerVector::Constant(valence, 4)}, 1});
    QuadMesh m = region.mesh;
    REQUIRE(irregular_valences(m) == std::map<int, int>{{valence, 1}});
    Editor editor(m);
    CHECK(part_all(editor) >= 1);
    const auto after = irregular_valences(m);
    for (const auto& [l, count] : after) CHECK((l == 3 || l == 5));
    CHECK(total_index(m) == 4 - valence);
    CHECK(validate(m).empty());
    CHECK(part_vertex(editor, irregular_vertices(m)[0]) == EditRefusal::wrong_valences);
    editor.roll_back();
    CHECK(m == region.mesh);
  }
}
