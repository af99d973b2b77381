#include "mesh/embedding.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/SparseCholesky>

namespace requad::mesh {

namespace {

// Two corners: a lens of two arcs, each turning by 2 * kLensHalfAngle. Less: the unit circle.
constexpr double kLensHalfAngle = 1.0;

std::vector<Eigen::Vector2d> boundary_positions_in_plane(const std::vector<int>& sides) {
  std::vector<Eigen::Vector2d> points;
  const double total = [&sides] {
    double sum = 0;
    for (const int s : sides) sum += s;
    return sum;
  }();
  const auto on_circle = [](double angle) { return Eigen::Vector2d(std::cos(angle), std::sin(angle)); };
  if (sides.size() == 1) {
    for (int j = 0; j < sides[0]; ++j) points.push_back(on_circle(2 * std::numbers::pi * j / total));
    return points;
  }
  if (sides.size() == 2) {
    // Corners at (0,-1) and (0,1); the first side bulges to the right, so the boundary runs counter-clockwise.
    const double radius = 1 / std::sin(kLensHalfAngle);
    const double shift = radius * std::cos(kLensHalfAngle);
    for (int s = 0; s < 2; ++s) {
      for (int j = 0; j < sides[static_cast<std::size_t>(s)]; ++j) {
        const double angle = kLensHalfAngle * (2.0 * j / sides[static_cast<std::size_t>(s)] - 1);
        const Eigen::Vector2d right(radius * std::cos(angle) - shift, radius * std::sin(angle));
        points.emplace_back(s == 0 ? right : Eigen::Vector2d(-right));
      }
    }
    return points;
  }
  double start = 0;
  for (const int side : sides) {
    const Eigen::Vector2d from = on_circle(2 * std::numbers::pi * start / total);
    const Eigen::Vector2d to = on_circle(2 * std::numbers::pi * (start + side) / total);
    for (int j = 0; j < side; ++j) points.emplace_back(from + (to - from) * (static_cast<double>(j) / side));
    start += side;
  }
  return points;
}

}  // namespace

std::vector<Eigen::Vector2d> embed(const Region& r) {
  const QuadMesh& m = r.mesh;
  std::vector<Eigen::Vector2d> position(static_cast<std::size_t>(m.vertex_capacity()), Eigen::Vector2d::Zero());
  const std::vector<Eigen::Vector2d> fixed = boundary_positions_in_plane(side_lengths(r));
  std::size_t next = 0;
  for (const HalfEdgeId h : boundary_loop(m, r.root)) position[m.origin(h).slot()] = fixed[next++];

  std::vector<int> unknown(static_cast<std::size_t>(m.vertex_capacity()), -1);
  int count = 0;
  for (const VertexId v : m.vertices()) {
    if (!m.is_boundary(v)) unknown[v.slot()] = count++;
  }
  if (count == 0) return position;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(count, 2);
  for (const VertexId v : m.vertices()) {
    const int row = unknown[v.slot()];
    if (row < 0) continue;
    for (const VertexId w : m.neighbours(v)) {
      entries.emplace_back(row, row, 1.0);
      if (unknown[w.slot()] >= 0) {
        entries.emplace_back(row, unknown[w.slot()], -1.0);
      } else {
        right.row(row) += position[w.slot()].transpose();
      }
    }
  }
  Eigen::SparseMatrix<double> laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(laplacian);
  const Eigen::MatrixX2d solution = solver.solve(right);
  for (const VertexId v : m.vertices()) {
    if (unknown[v.slot()] >= 0) position[v.slot()] = solution.row(unknown[v.slot()]).transpose();
  }
  return position;
}

}  // namespace requad::mesh
