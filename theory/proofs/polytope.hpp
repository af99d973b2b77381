// Lattice points of a polytope and its dilations. A proof counts them at a few sizes, and by the lemma below these
// counts determine the count at every size.
//
// Terms
//   P          {x in Q^n : A x = b, x_j >= 0, and x_j > 0 where strict[j]}. Its dilation L P has L b for b. For
//              integers x_j > 0 is x_j >= 1, so "every e_i >= 1" needs no shift, and L may be any positive integer.
//   count(L)   the number of integer points of L P.
//
// Lemma (Ehrhart 1962; Beck and Robins, Computing the Continuous Discretely, Theorem 3.23). If P is closed and bounded,
// count(L) is a quasi-polynomial in L >= 1. Its degree is at most dim P, and its period divides the least common
// multiple of the denominators of the vertices of P.
//
// A strict x_j > 0 removes the face x_j = 0. By inclusion and exclusion the count is then a sum, with signs, of counts
// of faces of the closed P. The vertices of these faces are vertices of P, so the lemma holds with the same degree and
// period. Therefore count(L) is known for all L >= 1 once it is known at degree + 1 values of L in each residue class.
#pragma once

#include "theory/proofs/exact.hpp"

namespace requad::theory {

struct Polytope {
  IntegerMatrix a;
  IntegerVector b;
  std::vector<bool> strict;  // one for each column of a
};

// True if no entry of A is negative and each column has a positive one. Then x = 0 is the only x >= 0 with A x = 0, so
// P is bounded. The condition is sufficient, not necessary.
bool surely_bounded(const Polytope& p);

// n - rank A, an upper bound for the dimension of P.
int dimension_bound(const Polytope& p);

// The vertices of the closure of P: the x >= 0 with A x = b whose support has independent columns. O(n choose rank).
std::vector<RationalVector> vertices(const Polytope& p);

// The least common multiple of the denominators of all coordinates.
Integer common_denominator(const std::vector<RationalVector>& points);

// The number of integer points of L P. Tries every integer point of the box around the vertices. Throws
// std::domain_error if surely_bounded(p) is false. Solves O(L^(n - rank)) systems.
Integer count_lattice_points(const Polytope& p, Integer dilation);

// A polynomial in L for each residue class of L.
struct QuasiPolynomial {
  std::vector<Polynomial> by_residue;  // as many as the period
  std::vector<Integer> samples;        // the values of L that were counted, in increasing order
  // Precondition: length >= 0.
  Polynomial at_residue(Integer length) const {
    return by_residue[static_cast<std::size_t>(length) % by_residue.size()];
  }
};
// count(L), interpolated from degree + 1 values of L >= 1 in each residue class modulo `period`. It is count(L) for all
// L >= 1 if common_denominator(vertices(p)) divides `period`. Throws as count_lattice_points().
QuasiPolynomial counting_quasi_polynomial(const Polytope& p, Integer period);

}  // namespace requad::theory
