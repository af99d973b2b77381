#include "mesh/geometry/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace requad::mesh {

using Eigen::Vector3d;

namespace {

std::array<Vector3d, 4> corner_positions(const QuadMesh& m, const Positions& positions, FaceId f) {
  const auto at = [&](int k) { return positions[m.origin(QuadMesh::half_edge(f, k)).slot()]; };
  return {at(0), at(1), at(2), at(3)};
}

Vector3d area_vector(const std::array<Vector3d, 4>& c) { return (c[2] - c[0]).cross(c[3] - c[1]) / 2; }

}  // namespace

Vector3d unit_or_zero(const Vector3d& v) {
  const Vector3d unit = v.stableNormalized();
  return unit.allFinite() ? unit : Vector3d(Vector3d::Zero());
}

Vector3d area_vector(const QuadMesh& m, const Positions& positions, FaceId f) {
  return area_vector(corner_positions(m, positions, f));
}

double area(const QuadMesh& m, const Positions& positions, FaceId f) { return area_vector(m, positions, f).norm(); }

Vector3d face_normal(const QuadMesh& m, const Positions& positions, FaceId f) {
  return unit_or_zero(area_vector(m, positions, f));
}

Vector3d face_centre(const QuadMesh& m, const Positions& positions, FaceId f) {
  const auto c = corner_positions(m, positions, f);
  return (c[0] + c[1] + c[2] + c[3]) / 4;
}

FaceTriangles triangles_of(const QuadMesh& m, const Positions& positions, FaceId f) {
  const auto c = corner_positions(m, positions, f);
  const Vector3d normal = area_vector(c);
  const auto inside = [&](std::size_t i, std::size_t j, std::size_t k) {
    return (c[j] - c[i]).cross(c[k] - c[i]).dot(normal) > 0;
  };
  const bool first_inside = inside(0, 1, 2) && inside(0, 2, 3), second_inside = inside(1, 2, 3) && inside(1, 3, 0);
  const bool first =
      first_inside != second_inside ? first_inside : (c[2] - c[0]).squaredNorm() <= (c[3] - c[1]).squaredNorm();
  if (first) return {{{{c[0], c[1], c[2]}, {c[0], c[2], c[3]}}}, {{{0, 1, 2}, {0, 2, 3}}}};
  return {{{{c[1], c[2], c[3]}, {c[1], c[3], c[0]}}}, {{{1, 2, 3}, {1, 3, 0}}}};
}

std::array<Triangle, 2> triangles(const QuadMesh& m, const Positions& positions, FaceId f) {
  return triangles_of(m, positions, f).triangles;
}

double scaled_jacobian(const QuadMesh& m, const Positions& positions, FaceId f) {
  const auto c = corner_positions(m, positions, f);
  const Vector3d normal = unit_or_zero(area_vector(c));
  if (normal.isZero(0)) return 0;
  std::array<Vector3d, 4> sides;
  for (std::size_t k = 0; k < 4; ++k) {
    sides[k] = unit_or_zero(c[(k + 1) % 4] - c[k]);
    if (sides[k].isZero(0)) return 0;
  }
  double least = 1;
  for (std::size_t k = 0; k < 4; ++k) least = std::min(least, sides[(k + 3) % 4].cross(sides[k]).dot(normal));
  return least;
}

int count_inverted(const QuadMesh& m, const Positions& positions) {
  const std::vector<FaceId> all = m.faces();
  return static_cast<int>(
      std::count_if(all.begin(), all.end(), [&](FaceId f) { return is_inverted(m, positions, f); }));
}

double aspect_ratio(const QuadMesh& m, const Positions& positions, FaceId f) {
  const auto c = corner_positions(m, positions, f);
  double longest = 0, perimeter = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double length = (c[(k + 1) % 4] - c[k]).norm();
    longest = std::max(longest, length);
    perimeter += length;
  }
  const double projected_area = area_vector(c).norm();
  return projected_area > 0 ? longest * perimeter / (4 * projected_area) : std::numeric_limits<double>::infinity();
}

double edge_length(const QuadMesh& m, const Positions& positions, HalfEdgeId h) {
  return (positions[m.target(h).slot()] - positions[m.origin(h).slot()]).norm();
}

double dihedral_angle(const QuadMesh& m, const Positions& positions, HalfEdgeId h) {
  const HalfEdgeId t = m.twin(h);
  if (!t.valid()) return 0;
  const Vector3d left = face_normal(m, positions, QuadMesh::face(h));
  const Vector3d right = face_normal(m, positions, QuadMesh::face(t));
  if (left.isZero(0) || right.isZero(0)) return 0;
  const Vector3d axis = left.cross(right);
  const double angle = std::atan2(axis.norm(), left.dot(right));
  // At a ridge, the rotation from the left normal to the right one has the direction of the edge as its axis.
  return axis.dot(positions[m.target(h).slot()] - positions[m.origin(h).slot()]) >= 0 ? angle : -angle;
}

double mean_curvature(const QuadMesh& m, const Positions& positions, VertexId v) {
  double sum = 0;
  // The last edge of a boundary vertex, which has no half-edge out of v, is on the boundary: its angle is 0.
  m.for_each_out(v, [&](HalfEdgeId h) { sum += edge_length(m, positions, h) * dihedral_angle(m, positions, h) / 4; });
  return sum;
}

double bounding_box_diagonal(const QuadMesh& m, const Positions& positions) {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const VertexId v : m.vertices()) {
    low = low.cwiseMin(positions[v.slot()]);
    high = high.cwiseMax(positions[v.slot()]);
  }
  return m.vertex_count() == 0 ? 0 : (high - low).norm();
}

}  // namespace requad::mesh
