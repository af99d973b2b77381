#include "enumerate/graphs/grid_position.hpp"

#include <cmath>
#include <numbers>

namespace requad::enumerate {

using std::numbers::pi;

GridPosition position_on_axes(const theory::Configuration& c, double first, double apart) {
  const double u = first - apart * (c.p - 1), v = u + apart;
  const auto m = static_cast<double>(c.d1()), n = static_cast<double>(c.d2());
  return {m * std::cos(u) + n * std::cos(v), m * std::sin(u) + n * std::sin(v)};
}

GridPosition grid_position(theory::PairType type, const theory::Configuration& c) {
  if (!type.symmetric()) {
    const theory::GridPoint at = theory::grid_point(type, c);
    return {static_cast<double>(at.m), static_cast<double>(at.n)};
  }
  if (type.has_third_index()) return position_on_axes(c, pi / 2, pi * 2 / type.rotation_count());
  return {static_cast<double>(c.d1() - c.d2()), static_cast<double>(c.d1() + c.d2())};
}

}  // namespace requad::enumerate
