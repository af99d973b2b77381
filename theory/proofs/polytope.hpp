// Lattice points of a polytope as it is dilated: what makes a count at a few sizes a count at all of them.
//
// Terms
//   P          {x in Q^n : A x = b, x_j >= 0, and x_j > 0 where strict[j]}; its dilation L P has L b for b. For
//   integers
//              x_j > 0 is x_j >= 1, so "every e_i >= 1" needs no shift and L may be any positive integer.
//   count(L)   the number of integer points of L P.
//
// Lemma (Ehrhart 1962; Beck and Robins, Computing the Continuous Discretely, Theorem 3.23). If P is closed and bounded,
// count(L) is a quasi-polynomial in L >= 1: of degree at most dim P, with a period that divides the least common
// multiple of the denominators of the vertices of P. A strict x_j > 0 takes the face x_j = 0 away; by inclusion and
// exclusion the count is then a sum, with signs, of counts of faces of the closed P, whose vertices are vertices of it:
// the lemma holds with the same degree and period. So count(L) is known for all L >= 1 once it is known at degree + 1
// values of L in each residue class.
#pragma once

#include "theory/proofs/exact.hpp"

namespace requad::theory {

struct Polytope {
  IntegerMatrix a;
  IntegerVector b;
  std::vector<bool> strict;  // one for each column of a
};

// True only if P is bounded: no entry of A is negative and each column has a positive one, so A x = 0 with x >= 0
// leaves x = 0 alone. (Sufficient, not necessary.)
bool surely_bounded(const Polytope& p);

// n - rank A, which bounds the dimension.
int dimension_bound(const Polytope& p);

// The vertices of the closure of P: the x >= 0 with A x = b whose support has independent columns. O(n choose rank).
std::vector<RationalVector> vertices(const Polytope& p);

// Least common multiple of the denominators of all coordinates.
Integer common_denominator(const std::vector<RationalVector>& points);

// Number of integer points of L P, by trying all in the box that the vertices span. Throws std::domain_error if P is
// not surely bounded. O(L^(n - rank)) solves.
Integer count_lattice_points(const Polytope& p, Integer dilation);

// count(L) as a polynomial in L for each residue class of L modulo `period`, interpolated at degree + 1 values of L >=
// 1 in each. Equal to count(L) for all L >= 1 if common_denominator(vertices(p)) divides `period` (the lemma above).
struct QuasiPolynomial {
  std::vector<Polynomial> by_residue;
  std::vector<Integer> samples;  // the values of L that were counted
  Polynomial at_residue(Integer length) const {
    return by_residue[static_cast<std::size_t>(length) % by_residue.size()];
  }
};
QuasiPolynomial counting_quasi_polynomial(const Polytope& p, Integer period);

}  // namespace requad::theory
