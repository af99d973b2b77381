#include "theory/counts.hpp"

#include <algorithm>
#include <stdexcept>

namespace requad::theory {

Integer tau_digon(Integer length) { return tau_from_half(length / 2, length % 2 == 0); }

Integer tau_hexagon(Integer length) { return 3 * tau_digon(length); }

QuadCount quad_count(const RegionShape& shape) {
  for (int p = 1; p <= 4; ++p) {
    const auto side = [&labelled = shape.labelled_sides(p)](int i) { return labelled(i - 1); };
    const Integer sum = side(4) - side(2);
    const Integer difference = side(1) - side(3);
    if (sum <= 0 || (sum + difference) % 2 != 0) continue;
    const Integer d1 = (sum + difference) / 2;
    const Integer d2 = (sum - difference) / 2;
    if (d1 <= 0 || d2 < 0) continue;  // d1 = 0 is the other labelling of a degenerate pair
    return {p, d1, d2, std::max<Integer>(side(2) - 1, 0), std::max<Integer>(side(1) - d1 - 1, 0)};
  }
  return {};
}

namespace {

// a + b = x, b + c = y, c + a = z has a positive integer solution.
bool triangle_solvable(Integer x, Integer y, Integer z) {
  return (x + y + z) % 2 == 0 && x + y > z && y + z > x && z + x > y;
}

Integer hexagon_count(const RegionShape& shape) {
  Integer twice = 0;
  for (int p = 1; p <= 3; ++p) {
    const auto side = [&labelled = shape.labelled_sides(p)](int i) { return labelled(i - 1); };
    for (Integer d1 = 0; d1 < std::min(side(1), side(4)); ++d1) {
      for (Integer d2 = 0; d2 < std::min(side(3), side(6)); ++d2) {
        if (d1 + d2 == 0) continue;
        if (triangle_solvable(side(1) - d1, side(3) - d2, side(5)) &&
            triangle_solvable(side(2), side(4) - d1, side(6) - d2)) {
          twice += d1 == 0 || d2 == 0 ? 1 : 2;
        }
      }
    }
  }
  return twice / 2;
}

}  // namespace

bool has_exact_count(PairType type) { return type == kDigon || type == kHexagon || type == kQuad; }

Integer exact_count(const RegionShape& shape) {
  const PairType type = shape.type();
  if (type == kDigon) return tau_digon(shape.shortest());
  if (type == kHexagon) return hexagon_count(shape);
  if (type == kQuad) return quad_count(shape).k();
  throw std::invalid_argument("no closed form for a " + type.name() +
                              " pair; parameter_set() lists its configurations");
}

Integer smallest_regular(const RegionShape& shape) {
  if (shape.type() == kDigon) return shape.longest();  // E1 + 2 s2 = L = E2 + 2 s1
  if (shape.type() != kHexagon)
    throw std::invalid_argument("only digons and hexagons are regular in the sense of Theorems 7.2, 7.3");
  // s_{i-1} + s_{i+1} = L - E_i with s >= 0: within each alternating triple a, b, c, L >= a + b - c, and L has the
  // parity of a + b + c, which is the same for both triples since the boundary is even.
  Integer length = shape.longest();
  const IntegerVector& sides = shape.sides();
  for (int i = 0; i < 6; ++i) {
    length = std::max(length, sides(i) + sides((i + 2) % 6) - sides((i + 4) % 6));
  }
  return (length % 2 != 0) == shape.is_odd() ? length : length + 1;
}

}  // namespace requad::theory
