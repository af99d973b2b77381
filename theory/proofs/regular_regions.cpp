// T2 and T3: tau(L) configurations in a regular region. N2: the parity of d1 + d2 there.
#include <algorithm>
#include <numeric>

#include "theory/configurations.hpp"
#include "theory/counts.hpp"
#include "theory/joined.hpp"
#include "theory/proofs/argument.hpp"
#include "theory/proofs/polytope.hpp"

namespace requad::theory {

RegularPremises regular_premises(PairType type) {
  const int factor = type.rotation_count();
  return {side_law(type), true, false,
          [factor](const Polynomial& n, bool even) { return factor * tau_from_half(n, even); }};
}

namespace {

Proof stated_regular_count(const SideLaw& law) {
  const bool digon = law.type.side_count() == 2;
  const int labellings = law.type.rotation_count();
  const bool several = labellings > 1;
  return {digon ? "T2" : "T3",
          "all L >= 1",
          std::string("A regular ") + (digon ? "digon" : "hexagon") + " of any side L with a " + law.type.name() +
              " pair has tau(L) configurations: the (m,n" +
              (several ? ",p) with p = 1.." + std::to_string(labellings) + ", " : ") with ") +
              "m >= 1, n >= 0, m+n <= L-2 and m+n = L mod 2. Here (x,0" +
              (several ? ",p) also stands for (0,x,p+1)." : ") also stands for (0,x)."),
          {kSideLawPremise, kEhrhartPremise},
          {}};
}

// Each configuration is taken once.
void require_one_labelling(Argument& argue, const RegularPremises& premises) {
  argue.say("All sides are L, so every labelling, p = 1.." + std::to_string(premises.law.type.rotation_count()) +
            ", has the same solutions.");
  require_segments_agree(argue, premises.law.type);
  argue.require(premises.d1_positive && !premises.d2_positive,
                "So d1 >= 1, d2 >= 0 takes every configuration once: (d,0) stands for itself and for (0,d).");
}

// The strips are integers >= 1 exactly if d1 + d2 = L mod 2 and d1 + d2 <= L - 2. False where they are not unique.
bool require_strips(Argument& argue, const SideLaw& law) {
  if (!argue.require(rank(to_rational(law.strips)) == law.type.side_count(),
                     "The matrix of the strips has full rank, so they are unique.")) {
    return false;
  }
  const std::vector<StripForm> forms = strip_forms(law);
  argue.say("The side law, solved for the strips, says " + text(forms) + ".");
  argue.require(parity_decides(forms),
                "Each 2 e_i is a combination of L, d1, d2 with odd coefficients. So the strips are integers exactly if "
                "d1 + d2 = L mod 2.");
  const StripForm least{Rational(1, 2), Rational(-1, 2), Rational(-1, 2)};
  bool is_least = false, none_below = true;
  for (const StripForm& f : forms) {
    is_least = is_least || f.polynomial() == least.polynomial();
    none_below = none_below && f.length >= least.length && f.d1 >= least.d1 && f.d2 >= least.d2;
  }
  argue.require(is_least && none_below, "The least of them, for L, d1, d2 >= 0, is " + least.text() +
                                            ". So all are >= 1 exactly if d1 + d2 <= L - 2.");
  return true;
}

// The solutions of the side law in the unknowns (d1, d2, e_1, ..) when all sides are 1. Those for sides L lie in its
// dilation by L.
Polytope solution_polygon(const RegularPremises& premises) {
  const SideLaw& law = premises.law;
  const int k = law.type.side_count();
  Polytope polygon{IntegerMatrix(k, k + 2), IntegerVector::Ones(k),
                   std::vector<bool>(static_cast<std::size_t>(k) + 2, true)};
  polygon.a << law.first, law.last, law.strips;
  polygon.strict[0] = premises.d1_positive;
  polygon.strict[1] = premises.d2_positive;
  return polygon;
}

// The polygon is bounded and not empty, so its points can be counted.
bool require_polygon(Argument& argue, const Polytope& polygon, const std::vector<RationalVector>& corners) {
  std::string corner_text;
  for (const RationalVector& x : corners) corner_text += (corner_text.empty() ? "" : ", ") + list(x);
  return argue.require(surely_bounded(polygon) && !corners.empty(),
                       "In the unknowns (d1, d2, e_1, ..) the solutions are the integer points of L P. P is bounded, "
                       "since no coefficient of the side law is negative and every unknown occurs. Its vertices are " +
                           corner_text + ".");
}

// The number of points is tau, in each residue class of L.
void require_tau(Argument& argue, const RegularPremises& premises, const QuasiPolynomial& counted) {
  const int labellings = premises.law.type.rotation_count();
  const auto period = static_cast<Integer>(counted.by_residue.size());
  const Polynomial length = Polynomial::variable(0);
  for (Integer residue = 0; residue < period; ++residue) {
    const Polynomial total = labellings * counted.by_residue[static_cast<std::size_t>(residue)];
    const bool even = residue % 2 == 0;
    const Polynomial stated = premises.tau((length - (even ? 0 : 1)) * Polynomial(Rational(1, 2)), even);
    std::vector<Integer> samples;
    std::copy_if(counted.samples.begin(), counted.samples.end(), std::back_inserter(samples),
                 [&](Integer sample) { return sample % period == residue; });
    argue.require(total == stated,
                  "L = " + std::to_string(residue) + " mod " + std::to_string(period) + ": counted at L = " +
                      joined(samples, ", ") + ", " + (labellings > 1 ? std::to_string(labellings) + " times " : "") +
                      "the number of points is " + total.text({"L"}) + "; tau is " + stated.text({"L"}) + ".");
  }
}

// The parameter sets, with which the instances are compared, have the sizes that were counted.
void require_parameter_set(Argument& argue, const SideLaw& law, const Polytope& polygon,
                           const std::vector<Integer>& samples) {
  bool same = true;
  for (const Integer sample : samples) {
    const auto listed = static_cast<Integer>(parameter_set(RegionShape::regular(law.type, sample)).size());
    same = same && listed == law.type.rotation_count() * count_lattice_points(polygon, sample);
  }
  argue.require(same, "At these L, parameter_set(), with which the instances are compared, has these sizes.");
}

// A digon with two different sides. E2 - 2 e1 and E1 - 2 e2 are both d1 + d2.
void require_any_digon(Argument& argue, const SideLaw& law) {
  const RationalMatrix crosswise{{0, Rational(1, 2)}, {Rational(1, 2), 0}};
  argue.require(
      inverse(to_rational(law.strips)) == crosswise && law.first == IntegerVector::Ones(2) &&
          law.last == IntegerVector::Ones(2),
      "In any digon e1 = (E2 - d1 - d2)/2 and e2 = (E1 - d1 - d2)/2. If E1 and E2 differ in parity, it has no "
      "configuration. Otherwise the shorter side alone decides, and it has tau(min(E1,E2)).");
}

}  // namespace

Proof prove_regular_count(const RegularPremises& premises) {
  const SideLaw& law = premises.law;
  Proof proof = stated_regular_count(law);
  Argument argue(proof);
  require_one_labelling(argue, premises);
  if (!require_strips(argue, law)) return proof;

  const Polytope polygon = solution_polygon(premises);
  const auto corners = vertices(polygon);
  if (!require_polygon(argue, polygon, corners)) return proof;
  const Integer period = common_denominator(corners);
  argue.say("So their number is a quasi-polynomial in L, of degree <= " + std::to_string(dimension_bound(polygon)) +
            " (unknowns minus rank) and of period " + std::to_string(period) +
            " (the common denominator). As a function of floor(L/2), tau has period 2.");
  const QuasiPolynomial counted = counting_quasi_polynomial(polygon, std::lcm(period, Integer{2}));
  require_tau(argue, premises, counted);
  require_parameter_set(argue, law, polygon, counted.samples);

  if (law.type.side_count() == 2) require_any_digon(argue, law);
  argue.say(
      "A region that grows to the regular one by s_i >= 0 strips has no more configurations than it. The side law is "
      "linear in e, so e -> e + s, with the same d1, d2 and p, maps its solutions one to one into those for L. Where a "
      "segment has two labellings, s is shifted with e.");
  return proof;
}

Proof prove_merging_parity(const std::vector<SideLaw>& laws) {
  Proof proof{
      "N2",
      "all L >= 1",
      "In a regular digon or hexagon of any side L a 3-3 or 5-5 pair has d1 + d2 = L mod 2, and the merged "
      "vertex fits exactly if L is even. So the distance is even exactly where there is room to merge.",
      {kSideLawPremise,
       "Only instances check that moves lead to the merged vertex wherever it fits, and that the distance is d1 + "
       "d2."},
      {}};
  Argument argue(proof);
  for (const SideLaw& law : laws) {
    if (!argue.require(rank(to_rational(law.strips)) == law.type.side_count(),
                       law.type.name() + ": the strips are unique.")) {
      return proof;
    }
    const std::vector<StripForm> forms = strip_forms(law);
    argue.require(parity_decides(forms),
                  law.type.name() + ": " + text(forms) + ", so they are integers only if d1 + d2 = L mod 2.");
    const bool halves =
        std::all_of(forms.begin(), forms.end(), [](const StripForm& f) { return f.length == Rational(1, 2); });
    argue.require(halves,
                  law.type.name() + ": with d1 = d2 = 0 every strip is L/2, an integer >= 1 exactly if L is even.");
  }
  return proof;
}

}  // namespace requad::theory
