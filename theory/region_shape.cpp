#include "theory/region_shape.hpp"

#include <stdexcept>
#include <utility>

#include "theory/joined.hpp"

namespace requad::theory {

std::string RegionShape::problem(PairType type, const IntegerVector& sides) {
  const int k = type.side_count();
  if (sides.size() != k) {
    return "a convex region with a " + type.name() + " pair has " + std::to_string(k) + " sides, not " +
           std::to_string(sides.size());
  }
  for (const Integer side : sides) {
    if (side < 1 || side > kMaxLength) {
      return "side " + std::to_string(side) + " is not in 1.." + std::to_string(kMaxLength);
    }
  }
  if (sides.sum() % 2 != 0) {
    return "sides " + joined(sides, ",") + " have the odd sum " + std::to_string(sides.sum()) +
           "; the boundary of a quadrangulated disk is even";
  }
  return "";
}

RegionShape::RegionShape(PairType type, IntegerVector sides) : system_(type) {
  if (const std::string text = problem(type, sides); !text.empty()) throw std::invalid_argument(text);
  perimeter_ = sides.sum();
  shortest_ = sides.minCoeff();
  longest_ = sides.maxCoeff();
  for (Eigen::Index i = 0; i < sides.size(); i += 2) odd_ ^= sides(i) % 2 != 0;
  labelled_.push_back(std::move(sides));
  for (int p = 2; p <= type.side_count(); ++p) labelled_.push_back(rotated(labelled_.front(), p - 1));
}

RegionShape RegionShape::regular(PairType type, Integer length) {
  return {type, IntegerVector::Constant(type.side_count(), length)};
}

}  // namespace requad::theory
