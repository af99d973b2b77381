// Closed forms for the number of configurations. Each is written down from the theorem, not by listing parameter sets,
// so that the two can be compared.
#pragma once

#include "theory/configurations.hpp"

namespace requad::theory {

// tau as Theorem 7.2 writes it, in N = floor(L/2). A template, so that the expression that counts is also the one that
// proofs.hpp proves for all L, with a polynomial for N.
template <class Number>
Number tau_from_half(const Number& n, bool even) {
  return even ? n * (n - 1) : n * n;
}
// Theorem 7.2: with N = floor(L/2), N(N-1) for even L, N^2 for odd L. Precondition: L >= 1.
Integer tau_digon(Integer length);
// Theorem 7.3: three times that.
Integer tau_hexagon(Integer length);

// Theorem 7.4: K = M N. Sides fix d1 and d2 (d1 - d2 = E1 - E3, d1 + d2 = E4 - E2 in the labelling of
// Equation 3), so at most one labelling fits; none gives K = 0.
struct QuadCount {
  int p = 0;  // the labelling, 0 if none
  Integer d1 = 0;
  Integer d2 = 0;
  Integer m = 0;  // M = E2 - 1
  Integer n = 0;  // N = E1 - d1 - 1
  Integer k() const { return m * n; }
};
// Precondition: the shape is that of a 3-5 pair.
QuadCount quad_count(const RegionShape& shape);

// Exact number of configurations of any convex digon, hexagon or 3-5 region, regular or not.
//   digon     tau(min(E1, E2))
//   hexagon   Equation 2 split into its two 3 x 3 systems; positive solutions summed over d1, d2 and the three
//             orientations, degenerate ones halved since Law 3 counts them twice
//   3-5       K = M N
// Throws std::invalid_argument on another pair type. O(L^2) for a hexagon, else O(1).
Integer exact_count(const RegionShape& shape);

// Side length of the smallest regular digon or hexagon that holds a region with these sides: the least L >= all E_i for
// which the region can be grown to L, L, ... by strips alone. Throws std::invalid_argument on another pair type.
Integer smallest_regular(const RegionShape& shape);

}  // namespace requad::theory
