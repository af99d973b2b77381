// The energy of a quad's shape, with its derivatives.
//
// A corner of a quad has the edges a and b that leave it, counterclockwise, and det = N . (a x b). N and A are the normal
// and the area that the quad should have: those of the surface where it lies.
//
//   shape(c) = (|a|^2 + |b|^2) / 4A + A (|a|^2 + |b|^2) / 4 det^2 - 1 + 2 (a . b)^2 / det^2
//
// The last term is 2 cot^2 of the corner's angle, so that rectangles are better than other parallelograms. The rest is the
// symmetric Dirichlet energy of the map from a square of area A to the parallelogram of a and b: 0 for that square, and
// without bound for corners that grow or vanish. In place of det stands a smooth function of it that is positive
// everywhere, about det where det is not small, and falls with det. So a folded corner has a large energy that falls as
// the corner unfolds (V. Garanzha et al., Foldover-free maps in 50 lines of code, 2021).
//
// Second derivatives are replaced by a positive semidefinite part of them.
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

namespace requad::mesh {

using QuadCorners = std::array<Eigen::Vector3d, 4>;

struct IdealQuad {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // of length 1
  double area = 0;                                   // positive
};

// The sum of shape(c) over the corners.
double shape_energy(const QuadCorners& corners, const IdealQuad& ideal);

// Derivatives of shape_energy() by the position of one corner, and by those of all four, x, y, z of each in turn.
struct CornerDerivatives {
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};
struct QuadDerivatives {
  Eigen::Matrix<double, 12, 1> gradient = Eigen::Matrix<double, 12, 1>::Zero();
  Eigen::Matrix<double, 12, 12> hessian = Eigen::Matrix<double, 12, 12>::Zero();
};
// Adds factor times the derivatives. k: the corner, in 0..3.
void add_shape(const QuadCorners& corners, std::size_t k, const IdealQuad& ideal, double factor,
               CornerDerivatives& sums);
void add_shape(const QuadCorners& corners, const IdealQuad& ideal, double factor, QuadDerivatives& sums);

}  // namespace requad::mesh
