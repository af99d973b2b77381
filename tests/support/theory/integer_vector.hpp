// Vectors of integers from lists.
#pragma once

#include <algorithm>
#include <initializer_list>

#include "theory/pair_system.hpp"

namespace requad::tests {

inline theory::IntegerVector sides(std::initializer_list<theory::Integer> values) {
  theory::IntegerVector v(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), v.begin());
  return v;
}

}  // namespace requad::tests
