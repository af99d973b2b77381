// The number of configurations, by the closed forms of the theorems and, beyond them, by sums. None lists a parameter
// set, so that the two can be compared.
#pragma once

#include "theory/configurations.hpp"

namespace requad::theory {

// tau as Theorem 7.2 writes it, in N = floor(L/2). It is a template, so that the proof for all L, in which N is a
// polynomial (proofs/proofs.hpp), is about the very expression that counts.
template <class Number>
Number tau_from_half(const Number& n, bool even) {
  return even ? n * (n - 1) : n * n;
}
// Theorem 7.2: with N = floor(L/2), N(N-1) for even L, N^2 for odd L. Precondition: L >= 1.
Integer tau_digon(Integer length);
// Theorem 7.3: three times that.
Integer tau_hexagon(Integer length);

// Theorem 7.4: K = M N. The sides fix d1 and d2: d1 - d2 = E1 - E3 and d1 + d2 = E4 - E2 in the labelling of Equation
// 3. So at most one labelling with d1 >= 1 fits. (A segment with d1 = 0 is one with d2 = 0, by theory-3.) If none
// does, K = 0.
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

// The exact number of configurations of a convex digon, hexagon or 3-5 region, regular or not.
//   digon     tau(min(E1, E2))
//   hexagon   Equation 2 falls into two 3 x 3 systems. Their positive solutions are summed over d1, d2 and the three
//             labellings; the degenerate ones are halved, since theory-3 counts them twice
//   3-5       K = M N
// Throws std::invalid_argument on another pair type. O(L^2) for a hexagon, else O(1).
bool has_exact_count(PairType type);
Integer exact_count(const RegionShape& shape);

// The side length of the smallest regular digon or hexagon around the region: the least L >= all E_i such that strips
// alone make all sides L. Throws std::invalid_argument on another pair type.
Integer smallest_regular(const RegionShape& shape);

}  // namespace requad::theory
