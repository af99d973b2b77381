// T1: a single irregular vertex.
#include <array>

#include "theory/joined.hpp"
#include "theory/proofs/argument.hpp"
#include "theory/proofs/polytope.hpp"

namespace requad::theory {

SingleVertexPremises single_vertex_premises() {
  SingleVertexPremises premises;
  premises.matrix = [](int valence) {
    return PairSystem(valence == 2 ? kDigon : PairType{valence + 1, 3}).strip_matrix();
  };
  const Polynomial length = Polynomial::variable(0);
  premises.sharp_count = (length - 1) * (length - 1);
  return premises;
}

namespace {

// The dimension of the circulant's kernel for l = 0, 1, 2, 3 mod 4: the degree of the gcd of its symbol and x^l - 1.
using Kernels = std::array<std::size_t, 4>;

// x^l - 1 modulo x^4 - 1, for l in 0..3.
Coefficients power_less_one(std::size_t residue) {
  if (residue == 0) return {};
  Coefficients power(residue + 1, 0);
  power[residue] = 1;
  power[0] = -1;
  return power;
}

Kernels require_kernels(Argument& argue, const Coefficients& symbol) {
  const std::string s = text(symbol, "x");
  argue.say(
      "The matrix of the e_i is a circulant: multiplication by x^{l-1} + x in Q[x]/(x^l - 1). Since x is invertible "
      "there, its kernel is that of multiplication by " +
      s + ", and the dimension of the kernel is the degree of gcd(" + s + ", x^l - 1).");
  argue.require(remainder({-1, 0, 0, 0, 1}, symbol).empty(),
                "x^4 = 1 modulo " + s + " (the remainder of x^4 - 1 is 0), so the gcd depends on l mod 4 only.");
  Kernels kernels{};
  for (std::size_t residue = 0; residue < kernels.size(); ++residue) {
    const Coefficients power = power_less_one(residue);
    const Coefficients gcd = greatest_common_divisor(symbol, power);
    kernels[residue] = gcd.size() - 1;
    argue.require(kernels[residue] == (residue == 0 ? 2U : 0U),
                  "l = " + std::to_string(residue) + " mod 4: gcd(" + s + ", " + text(power, "x") +
                      ") = " + text(gcd, "x") +
                      (residue == 0 ? ", so the kernel has dimension 2." : ", so the strips are unique."));
  }
  return kernels;
}

// The l x l matrix whose row i has the symbol's coefficients from column i - 1 on, indices modulo l.
RationalMatrix circulant(const Coefficients& symbol, std::size_t l) {
  RationalMatrix matrix(l, RationalVector(l, 0));
  for (std::size_t i = 0; i < l; ++i) {
    for (std::size_t j = 0; j < symbol.size(); ++j) matrix[i][(i + l - 1 + j) % l] += symbol[j];
  }
  return matrix;
}

void require_circulants(Argument& argue, const SingleVertexPremises& premises, const Kernels& kernels) {
  bool same = true;
  for (int l = 2; l <= 16; ++l) {
    const auto size = static_cast<std::size_t>(l);
    const RationalMatrix expected = circulant(premises.symbol, size);
    same = same && to_rational(premises.matrix(l)) == expected &&
           rank(expected) == l - static_cast<int>(kernels[size % 4]);
  }
  argue.require(
      same, "The program's matrices for l = 2..16 are these circulants, and elimination gives the ranks just derived.");
}

void require_sharp_count(Argument& argue, const SingleVertexPremises& premises) {
  argue.say(
      "If 4 divides l and all sides are L, then e_{i+2} = L - e_i, and hence e_{i+4} = e_i. So e_1, ..., e_4 with "
      "e_1 + e_3 = e_2 + e_4 = L determine all strips, as for l = 4.");
  const Polytope square{premises.matrix(4), IntegerVector::Ones(4), std::vector<bool>(4, true)};
  const auto corners = vertices(square);
  const Integer period = common_denominator(corners);
  if (!argue.require(surely_bounded(square) && !corners.empty(),
                     "Their polytope P (L = 1) is bounded and has dimension <= " +
                         std::to_string(dimension_bound(square)) + ". It has " + std::to_string(corners.size()) +
                         " vertices, and their common denominator is " + std::to_string(period) + ".")) {
    return;
  }
  const QuasiPolynomial counted = counting_quasi_polynomial(square, period);
  for (const Polynomial& count : counted.by_residue) {
    argue.require(count == premises.sharp_count, "Counted at L = " + joined(counted.samples, ", ") +
                                                     ", the number of e >= 1 is " + count.text({"L"}) + "; stated is " +
                                                     premises.sharp_count.text({"L"}) + ".");
  }
}

}  // namespace

Proof prove_single_vertex(const SingleVertexPremises& premises) {
  Proof proof{"T1",
              "all valences l >= 2 and all sides",
              "If 4 does not divide the valence of a single irregular vertex, its region has at most one system of "
              "strips, whatever the sides. If 4 divides it, a regular region of any side L has exactly (L-1)^2.",
              {"E_i = e_{i-1} + e_{i+1} describes every convex region with one irregular vertex, and each solution "
               "with all e_i >= 1 is one configuration (instances: T1, L10).",
               kEhrhartPremise},
              {}};
  Argument argue(proof);
  const Kernels kernels = require_kernels(argue, premises.symbol);
  require_circulants(argue, premises, kernels);
  require_sharp_count(argue, premises);
  return proof;
}

}  // namespace requad::theory
