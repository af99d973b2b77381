#include "tests/support/mesh/drawings.hpp"

#include "mesh/geometry/drawing.hpp"
#include "tests/support/catch.hpp"

namespace requad::tests {

using namespace requad::mesh;
using Eigen::Vector2d;

double area(const std::vector<Vector2d>& polygon) {
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    doubled += p.x() * q.y() - p.y() * q.x();
  }
  return doubled / 2;
}

void check_drawing(const Region& region, double least_sine) {
  const QuadMesh& m = region.mesh;
  const std::vector<Vector2d> at = draw(region);
  double smallest = 0;
  REQUIRE(drawing_problem(region, at, &smallest).empty());
  REQUIRE(smallest > least_sine);
  std::vector<Vector2d> boundary;
  for (const HalfEdgeId h : boundary_loop(m, region.root)) boundary.push_back(at[m.origin(h).slot()]);
  REQUIRE(boundary == outline(side_lengths(region), turn(m, m.origin(region.root)) > 0));
  double sum = 0;
  for (const FaceId f : m.faces()) {
    std::vector<Vector2d> quad;
    for (const VertexId v : m.corners(f)) quad.push_back(at[v.slot()]);
    REQUIRE(area(quad) > 0.05);
    sum += area(quad);
    for (std::size_t k = 0; k < 4; ++k) {
      const VertexId v = m.corners(f)[k];
      if (!m.is_boundary(v) && m.valence(v) == 2) continue;
      REQUIRE(area({quad[k], quad[(k + 1) % 4], quad[(k + 3) % 4]}) > 0);
    }
  }
  REQUIRE(sum == Approx(area(boundary)));
}

}  // namespace requad::tests
