// Editors, features, transport and the parting of vertices, on generated meshes.
#include <map>
#include <random>

#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/mesh/regions.hpp"

using namespace requad;
using namespace requad::mesh;
using requad::tests::irregular_valences;
using requad::tests::random_operation;
using requad::tests::random_positions;

TEST_CASE("Laws editing-1 to editing-4: random edits keep features and fixed positions, and roll back bit by bit",
          "[editor]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const Region start = tests::pair_region({5, 5, 2, 2}, {2, 2, 2, 2, 2, 2});
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
        // Law editing-5 forbids nothing else: the refused operation would break the feature.
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

TEST_CASE("Law editing-2: a vertex that moves from 0 to -0 is rolled back, too", "[editor]") {
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

TEST_CASE("an editor restores where fans start, and makes again what was rolled back", "[editor]") {
  std::mt19937 random(7);
  QuadMesh m = tests::pair_region({5, 5, 2, 2}, {2, 2, 2, 2, 2, 2}).mesh;
  Positions positions = random_positions(m, random);
  Editor editor(m, nullptr, &positions);
  const auto fans = [&m] {
    std::vector<HalfEdgeId> all;
    for (const VertexId v : m.vertices()) all.push_back(m.out(v));
    return all;
  };
  const auto before = fans();
  while (editor.mark() < 100) editor.run(random_operation(m, random));
  const QuadMesh after = m;
  const Positions moved = positions;
  const auto then = fans();
  const std::vector<Edit> edits = editor.edits();
  editor.roll_back();
  CHECK(fans() == before);
  for (const Edit& edit : edits) editor.redo(edit);
  CHECK(m == after);
  for (const VertexId v : m.vertices()) CHECK(same_bits(positions[v.slot()], moved[v.slot()]));
  CHECK(fans() == then);
  CHECK(editor.mark() == edits.size());
  editor.roll_back(edits.size() - 1);
  editor.roll_back(0);
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (edits[i].operates && editor.why_not(edits[i].operation) != Refusal::none) {
      CHECK_THROWS_AS(editor.redo(edits[i]), std::logic_error);
      break;
    }
  }
}

TEST_CASE("Law irregular-1: a step changes the valences of both positions of the adjacent pair and no other",
          "[transport]") {
  // By hand: u gains an edge and v loses one. The next u loses an edge and the next v gains one.
  const Region start = tests::pair_region({3, 5, 1, 0}, {3, 3, 3, 3});
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
      // Both choices of ids make the same mesh.
      QuadMesh same = start.mesh;
      apply(same, plan(same, {edge}, step).operation);
      const VertexId root = start.mesh.origin(start.root);
      CHECK(signature(m, m.out(root)) == signature(same, same.out(root)));
    }
  }
}

TEST_CASE("vertices of any valence are parted into v3s and v5s", "[complementary]") {
  for (int valence = 6; valence <= 12; ++valence) {
    const Region region = tests::star(std::vector<int>(static_cast<std::size_t>(valence), 4));
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
