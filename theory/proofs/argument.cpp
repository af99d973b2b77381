#include "theory/proofs/argument.hpp"

#include <algorithm>

#include "theory/configurations.hpp"

namespace requad::theory {

const char* const kSideLawPremise =
    "The side law, E_i = e_{i-1} + e_{i+1} + (d1 at the firsts) + (d2 at the lasts), describes every convex region "
    "with "
    "the pair, and each solution with all e_i >= 1 is one configuration (Lemmas 7.8-7.14; instances: L8, L10, S1).";
const char* const kEhrhartPremise =
    "Ehrhart: for a rational polytope P, the number of integer points of L P is a quasi-polynomial in L >= 1. Its "
    "degree "
    "is at most dim P, and its period divides the common denominator of the vertices of P. The same holds for P "
    "without "
    "some of its faces, by inclusion and exclusion. Beck and Robins, Computing the Continuous Discretely, Theorem "
    "3.23.";

RationalVector rational_vector(const IntegerVector& v) { return {v.begin(), v.end()}; }

Rational dot(const RationalVector& a, const IntegerVector& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b(static_cast<Eigen::Index>(i));
  return sum;
}

std::string list(const RationalVector& v) {
  std::string out;
  for (const Rational& x : v) out += (out.empty() ? "" : ",") + x.text();
  return "(" + out + ")";
}

Polynomial StripForm::polynomial() const {
  return Polynomial(length) * Polynomial::variable(0) + Polynomial(d1) * Polynomial::variable(1) +
         Polynomial(d2) * Polynomial::variable(2);
}

std::vector<StripForm> strip_forms(const SideLaw& law) {
  const RationalMatrix solve = inverse(to_rational(law.strips));
  const RationalVector length = solve * RationalVector(solve.size(), 1);
  const RationalVector first = solve * rational_vector(law.first);
  const RationalVector last = solve * rational_vector(law.last);
  std::vector<StripForm> forms;
  for (std::size_t i = 0; i < solve.size(); ++i) forms.push_back({length[i], -first[i], -last[i]});
  return forms;
}

std::string text(const std::vector<StripForm>& forms) {
  std::string out;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    out += (i == 0 ? "e" : ", e") + std::to_string(i + 1) + " = " + forms[i].text();
  }
  return out;
}

bool parity_decides(const std::vector<StripForm>& forms) {
  return std::all_of(forms.begin(), forms.end(), [](const StripForm& f) {
    return f.length.is_odd_half() && f.d1.is_odd_half() && f.d2.is_odd_half();
  });
}

namespace {

// Both labellings of a segment have the same sides and lead to each other. Sides and labellings are linear in d and e,
// so it is enough to try the unit vectors.
bool segments_agree(PairType type) {
  const int k = type.side_count();
  for (int p = 1; p <= type.rotation_count(); ++p) {
    for (int unit = 0; unit <= k; ++unit) {
      Configuration c{{1, 0, IntegerVector::Zero(k)}, p};
      if (unit > 0) c.parameters.e(unit - 1) = 1;
      const Configuration other = other_labelling(type, c);
      if (other.d1() != 0 || other.d2() != 1 || region_sides(type, c) != region_sides(type, other) ||
          !(other_labelling(type, other) == c)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

void require_segments_agree(Argument& argue, PairType type) {
  argue.require(segments_agree(type),
                "A segment has two labellings: (d,0), and (0,d) with the strips shifted by one label. Their sides "
                "agree as linear "
                "forms in d and all e_i, and each leads back to the other.");
}

}  // namespace requad::theory
