#include "enumerate/space_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>

namespace requad::enumerate {

namespace {

constexpr Eigen::Index kSubspace = 8;  // more than the three that are wanted: convergence is faster
constexpr int kIterations = 100;
constexpr double kShift = 1e-3;  // keeps the Laplacian regular

Eigen::SparseMatrix<double> laplacian(const mesh::QuadMesh& mesh) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto add_edge = [&entries](int a, int b) {
    entries.insert(entries.end(), {{a, a, 1.0}, {b, b, 1.0}, {a, b, -1.0}, {b, a, -1.0}});
  };
  for (const mesh::HalfEdgeId h : mesh.half_edges()) {
    const int a = mesh.origin(h).index(), b = mesh.target(h).index();
    if (a < b || mesh.is_boundary(h)) add_edge(a, b);
  }
  const auto size = static_cast<Eigen::Index>(mesh.vertex_capacity());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

// Subspace iteration with the inverse of the shifted Laplacian, and Rayleigh-Ritz at the end.
mesh::Positions space_drawing(const mesh::QuadMesh& mesh) {
  Eigen::SparseMatrix<double> matrix = laplacian(mesh);
  const Eigen::Index size = matrix.rows(), columns = std::min(kSubspace, size);
  Eigen::SparseMatrix<double> shifted = matrix;
  for (Eigen::Index i = 0; i < size; ++i) shifted.coeffRef(i, i) += kShift;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(shifted);
  Eigen::MatrixXd vectors(size, columns);
  for (Eigen::Index i = 0; i < size; ++i) {  // any start will do that is no accident
    for (Eigen::Index k = 0; k < columns; ++k) vectors(i, k) = std::sin(1 + static_cast<double>((k + 2) * (i + 1)));
  }
  const auto orthonormal = [columns](const Eigen::MatrixXd& v) -> Eigen::MatrixXd {
    return Eigen::HouseholderQR<Eigen::MatrixXd>(v).householderQ() * Eigen::MatrixXd::Identity(v.rows(), columns);
  };
  for (int i = 0; i < kIterations; ++i) vectors = orthonormal(solver.solve(vectors));
  const Eigen::MatrixXd projected = vectors.transpose() * (matrix * vectors);
  vectors = vectors * Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(projected).eigenvectors();

  mesh::Positions positions(static_cast<std::size_t>(size), Eigen::Vector3d::Zero());
  for (Eigen::Index axis = 0; axis < 3 && axis + 1 < columns; ++axis) {
    const Eigen::VectorXd coordinates = vectors.col(axis + 1) / vectors.col(axis + 1).cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < size; ++i) positions[static_cast<std::size_t>(i)](axis) = coordinates(i);
  }
  return positions;
}

}  // namespace requad::enumerate
