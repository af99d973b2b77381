// Sectors of fixed vertices: Law editing-6, plans from angles, and transports that repair features and boundaries.
#include <map>
#include <numeric>
#include <random>

#include "mesh/files/feature_edges.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/irregular/reduce.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;

namespace {

// A plane grid with its boundary, and features along the middle column and the middle row.
struct Sheet {
  QuadMesh mesh;
  Positions positions;
  FeatureSet features;
};
Sheet sheet(int columns, int rows) {
  Sheet s;
  const auto at = [columns](int x, int y) { return y * (columns + 1) + x; };
  std::vector<std::array<int, 4>> faces;
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) {
      s.positions.push_back({double(x), double(y), 0});
      if (x < columns && y < rows) faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  s.mesh = QuadMesh::from_faces((columns + 1) * (rows + 1), faces);
  for (int y = 0; y < rows; ++y) s.features.insert(VertexId(at(columns / 2, y)), VertexId(at(columns / 2, y + 1)));
  for (int x = 0; x < columns; ++x) s.features.insert(VertexId(at(x, rows / 2)), VertexId(at(x + 1, rows / 2)));
  return s;
}

// The sum of the excesses over each patch, by brute force. A patch is named by its least face. Faces on both sides of
// an edge that is no feature belong to one patch. At each vertex, the corners of the patch's faces are counted and
// compared with the intended number.
std::map<int, int> patch_sums(const QuadMesh& m, const FeatureSet& features, const SectorPlan& plan) {
  std::vector<int> patch(static_cast<std::size_t>(m.face_capacity()));
  std::iota(patch.begin(), patch.end(), 0);
  const auto find = [&](int f) {
    while (patch[static_cast<std::size_t>(f)] != f) f = patch[static_cast<std::size_t>(f)];
    return f;
  };
  for (const HalfEdgeId h : m.half_edges()) {
    if (m.is_boundary(h) || features.is_edge(m.origin(h), m.target(h))) continue;
    const int a = find(QuadMesh::face(h).index());
    const int b = find(QuadMesh::face(m.twin(h)).index());
    patch[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  std::map<int, int> corners;
  std::map<int, int> free;
  std::map<int, int> planned;
  for (const FaceId f : m.faces()) corners[find(f.index())] += 4;
  for (const VertexId v : m.vertices()) {
    if (!m.is_boundary(v) && !features.is_vertex(v)) ++free[find(QuadMesh::face(m.out(v)).index())];
  }
  for (const HalfEdgeId h : m.half_edges()) {
    if (!m.is_boundary(h) && !features.is_edge(m.origin(h), m.target(h))) continue;
    planned[find(QuadMesh::face(h).index())] += plan.get(m.origin(h), m.target(h)).value();
  }
  // Ids of faces change, so the sums of the patches are compared in sorted order.
  std::map<int, int> sums;
  for (const auto& [p, count] : corners) sums[p] = count - 4 * free[p] - planned[p];
  return sums;
}
std::vector<int> sorted_sums(const QuadMesh& m, const FeatureSet& features, const SectorPlan& plan) {
  std::vector<int> result;
  for (const auto& [patch, sum] : patch_sums(m, features, plan)) result.push_back(sum);
  std::sort(result.begin(), result.end());
  return result;
}

int irregular_count(const Sectors& sectors, const QuadMesh& m) {
  int count = 0;
  for (const VertexId v : m.vertices()) count += sectors.is_irregular(v) ? 1 : 0;
  return count;
}

void check_kept(const QuadMesh& m, const Positions& positions, const FeatureSet& features, const QuadMesh& before,
                const Positions& positions_before) {
  CHECK(validate(m).empty());
  for (const auto& [a, b] : features.edges()) {
    REQUIRE(m.is_live(a));
    REQUIRE(m.is_live(b));
    CHECK(m.adjacent(a, b));
  }
  for (const VertexId v : before.vertices()) {
    if (!before.is_boundary(v) && !features.is_vertex(v)) continue;
    REQUIRE(m.is_live(v));
    CHECK(m.is_boundary(v) == before.is_boundary(v));
    CHECK(positions[v.slot()] == positions_before[v.slot()]);
  }
}

}  // namespace

TEST_CASE("sectors have the sizes, starts and excesses that are counted by hand", "[sectors]") {
  const Sheet s = sheet(4, 4);
  SectorPlan plan = plan_by_angles(s.mesh, s.features, s.positions);
  const Sectors sectors(s.mesh, &s.features, &plan);
  std::map<int, int> sizes;  // the number of sectors of fixed vertices of each size
  int count = 0;
  for (const VertexId v : s.mesh.vertices()) {
    CHECK_FALSE(sectors.is_irregular(v));
    if (!sectors.is_fixed(v)) continue;
    sectors.for_each_sector(v, [&](HalfEdgeId h) {
      ++sizes[sectors.size(h)], ++count;
      CHECK(sectors.start(h) == h);
      CHECK(sectors.excess(h) == 0);
    });
  }
  // Size 1: one sector at each of 4 corners, two at each of 4 ends of features, four at the crossing. Size 2: one at
  // each of 8 boundary vertices, two at each of 4 feature vertices.
  CHECK(sizes == std::map<int, int>{{1, 4 + 8 + 4}, {2, 8 + 8}});
  CHECK(sectors.is_minimal());
  // If a corner should have two quads, it lacks one. Nothing else changes.
  plan.set(VertexId(0), s.mesh.target(s.mesh.out(VertexId(0))), 2);
  CHECK(sectors.lacks(VertexId(0)));
  CHECK_FALSE(sectors.exceeds(VertexId(0)));
  CHECK(irregular_count(sectors, s.mesh) == 1);
  CHECK(sectors.is_minimal());
  // The plan is not minimal if one patch has both signs. It is minimal if each of two patches has one sign.
  SectorPlan both = plan, apart = plan;
  both.set(VertexId(1), VertexId(2), 1);
  CHECK_FALSE(Sectors(s.mesh, &s.features, &both).is_minimal());
  apart.set(VertexId(3), VertexId(4), 1);
  CHECK(Sectors(s.mesh, &s.features, &apart).is_minimal());
  // Without a plan, no fixed vertex may change, and none has an excess.
  const Sectors without(s.mesh, &s.features);
  CHECK_FALSE(without.may_change(VertexId(0)));
  CHECK_FALSE(without.is_irregular(VertexId(0)));
}

TEST_CASE("Law editing-6: no operation changes the sum of the excesses over a patch", "[sectors]") {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    Sheet s = sheet(8, 6);
    SectorPlan plan = plan_by_angles(s.mesh, s.features, s.positions);
    // The plans are changed, so that the patches differ.
    plan.set(VertexId(0), VertexId(1), 3);
    plan.set(VertexId(7), VertexId(8), 5);
    const QuadMesh before = s.mesh;
    const Positions positions = s.positions;
    const std::vector<int> sums = sorted_sums(s.mesh, s.features, plan);
    CHECK(sums == std::vector<int>{-3, -2, 0, 0});
    Editor editor(s.mesh, &s.features, &s.positions, &plan);
    for (int i = 0; i < 400; ++i) {
      if (editor.run(tests::random_operation(s.mesh, random)).refusal != Refusal::none) continue;
      REQUIRE(sorted_sums(s.mesh, s.features, plan) == sums);
      // The excesses of all vertices have the same sum.
      int total = 0;
      for (const VertexId v : s.mesh.vertices())
        editor.sectors().for_each_sector(v, [&](HalfEdgeId h) { total += editor.sectors().excess(h); });
      REQUIRE(total == -5);
    }
    CHECK(editor.mark() > 60);
    check_kept(s.mesh, s.positions, s.features, before, positions);
  }
}

TEST_CASE("a disturbed sheet is repaired up to its features and boundary", "[sectors][reduce]") {
  int repaired = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    Sheet s = sheet(12, 10);
    const SectorPlan plan = plan_by_angles(s.mesh, s.features, s.positions);
    Editor editor(s.mesh, &s.features, &s.positions, &plan);
    const Positions positions = s.positions;
    for (int made = 0; made < 25;)
      made += editor.run(tests::random_operation(s.mesh, random)).refusal == Refusal::none ? 1 : 0;
    int at_fixed = 0;
    for (const VertexId v : s.mesh.vertices())
      at_fixed += editor.is_fixed(v) && editor.sectors().is_irregular(v) ? 1 : 0;
    CHECK(at_fixed > 4);
    const QuadMesh disturbed = s.mesh;
    const int before = irregular_count(editor.sectors(), s.mesh);
    const ReduceReport report = reduce(editor, {});
    CHECK(report.before == before);
    CHECK(report.after == irregular_count(editor.sectors(), s.mesh));
    // The sum over each patch is 0. So the patch becomes regular, except for a lone 3-5 pair, which cannot be cancelled
    // (Theorem 7.4).
    CHECK(2 * report.after < before);
    int fixed_left = 0;
    for (const VertexId v : s.mesh.vertices())
      fixed_left += editor.is_fixed(v) && editor.sectors().is_irregular(v) ? 1 : 0;
    repaired += fixed_left < at_fixed ? 1 : 0;
    check_kept(s.mesh, s.positions, s.features, disturbed, positions);
  }
  CHECK(repaired >= 8);
}

TEST_CASE("a disturbed fandisk keeps its features and loses more than half of its irregular vertices",
          "[sectors][reduce][real]") {
  const auto path = tests::real_mesh("fandisk_bommes");
  if (!path) return;
  const Surface input = read_surface(*path, false);
  FeatureSet features;
  for (const auto& [a, b] : sharp_edges(input.mesh, input.positions, 40)) features.insert(a, b);
  const SectorPlan plan = plan_by_angles(input.mesh, features, input.positions);
  std::mt19937 random(1);
  QuadMesh m = input.mesh;
  Positions positions = input.positions;
  Editor editor(m, &features, &positions, &plan);
  CHECK(editor.sectors().is_minimal());
  CHECK(irregular_count(editor.sectors(), m) == 4);
  for (int made = 0; made < 60;)
    made += editor.run(tests::random_operation(m, random)).refusal == Refusal::none ? 1 : 0;
  const int before = irregular_count(editor.sectors(), m);
  CHECK(before > 60);
  const ReduceReport report = reduce(editor, {});
  CHECK(report.before == before);
  CHECK(2 * report.after < before);
  check_kept(m, positions, features, input.mesh, input.positions);
}
