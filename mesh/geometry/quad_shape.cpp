#include "mesh/geometry/quad_shape.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace requad::mesh {

using Eigen::Vector3d;

namespace {

constexpr double kFlat = 0.1;  // of the ideal area: det below this counts as small
constexpr double kAngles = 2;  // what cot^2 of an angle counts

// The positive function of det, with its slope.
struct Positive {
  double value;
  double slope;
};
Positive positive(double det, double flat) {
  const double root = std::sqrt(det * det + flat * flat);
  // Without cancellation for negative det.
  const double value = det >= 0 ? (det + root) / 2 : flat * flat / (2 * (root - det));
  return {value, value / root};
}

// One corner: its energy as a function of the lengths, of det and of the cotangent, and how these change with the corner
// itself, with the end of a and with the end of b.
struct CornerSlopes {
  std::array<std::size_t, 3> at;  // corners of the quad: itself, the end of a, the end of b
  std::array<Vector3d, 3> by_lengths, by_det, by_cot;
  double slope_lengths, slope_det, slope_cot;  // of the energy
  double curvature_det;
};

CornerSlopes slopes_at(const QuadCorners& c, std::size_t j, const IdealQuad& ideal) {
  CornerSlopes result;
  result.at = {j, (j + 1) & 3, (j + 3) & 3};
  const Vector3d a = c[result.at[1]] - c[j], b = c[result.at[2]] - c[j];
  const double lengths = a.squaredNorm() + b.squaredNorm();
  const Positive det = positive(ideal.normal.dot(a.cross(b)), kFlat * ideal.area);
  result.by_lengths = {-2 * (a + b), 2 * a, 2 * b};
  result.by_det[1] = b.cross(ideal.normal);
  result.by_det[2] = ideal.normal.cross(a);
  result.by_det[0] = -(result.by_det[1] + result.by_det[2]);
  const double squared = det.value * det.value;
  result.slope_lengths = 1 / (4 * ideal.area) + ideal.area / (4 * squared);
  result.slope_det = -lengths * ideal.area * det.slope / (2 * squared * det.value);
  result.curvature_det = 1.5 * lengths * ideal.area * det.slope * det.slope / (squared * squared);
  const double cot = a.dot(b) / det.value;
  const std::array<Vector3d, 3> by_dot{-(a + b), b, a};
  for (std::size_t i = 0; i < 3; ++i) result.by_cot[i] = (by_dot[i] - cot * det.slope * result.by_det[i]) / det.value;
  result.slope_cot = 2 * kAngles * cot;
  return result;
}

// The second derivatives of the lengths, each times the identity.
constexpr std::array<std::array<double, 3>, 3> kLengths{{{4, -2, -2}, {-2, 2, 0}, {-2, 0, 2}}};

}  // namespace

double shape_energy(const QuadCorners& c, const IdealQuad& ideal) {
  double sum = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    const Vector3d a = c[(j + 1) & 3] - c[j], b = c[(j + 3) & 3] - c[j];
    const double det = positive(ideal.normal.dot(a.cross(b)), kFlat * ideal.area).value;
    const double lengths = a.squaredNorm() + b.squaredNorm();
    const double cot = a.dot(b) / det;
    sum += lengths / (4 * ideal.area) + lengths * ideal.area / (4 * det * det) - 1 + kAngles * cot * cot;
  }
  return sum;
}

void add_shape(const QuadCorners& c, std::size_t k, const IdealQuad& ideal, double factor, CornerDerivatives& sums) {
  for (const std::size_t j : {k, (k + 1) & 3, (k + 3) & 3}) {
    const CornerSlopes e = slopes_at(c, j, ideal);
    const std::size_t i = e.at[0] == k ? 0 : e.at[1] == k ? 1 : 2;
    sums.gradient +=
        factor * (e.slope_lengths * e.by_lengths[i] + e.slope_det * e.by_det[i] + e.slope_cot * e.by_cot[i]);
    sums.hessian.diagonal().array() += factor * kLengths[i][i] * e.slope_lengths;
    sums.hessian += (factor * e.curvature_det) * e.by_det[i] * e.by_det[i].transpose();
    sums.hessian += (2 * factor * kAngles) * e.by_cot[i] * e.by_cot[i].transpose();
  }
}

void add_shape(const QuadCorners& c, const IdealQuad& ideal, double factor, QuadDerivatives& sums) {
  for (std::size_t j = 0; j < 4; ++j) {
    const CornerSlopes e = slopes_at(c, j, ideal);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = static_cast<Eigen::Index>(3 * e.at[i]);
      sums.gradient.segment<3>(row) +=
          factor * (e.slope_lengths * e.by_lengths[i] + e.slope_det * e.by_det[i] + e.slope_cot * e.by_cot[i]);
      for (std::size_t n = 0; n < 3; ++n) {
        auto block = sums.hessian.block<3, 3>(row, static_cast<Eigen::Index>(3 * e.at[n]));
        block.diagonal().array() += factor * kLengths[i][n] * e.slope_lengths;
        block += (factor * e.curvature_det) * e.by_det[i] * e.by_det[n].transpose();
        block += (2 * factor * kAngles) * e.by_cot[i] * e.by_cot[n].transpose();
      }
    }
  }
}

}  // namespace requad::mesh
