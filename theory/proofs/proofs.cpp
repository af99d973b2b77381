#include "theory/proofs/proofs.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "theory/configuration_graph.hpp"
#include "theory/counts.hpp"
#include "theory/proofs/polytope.hpp"

namespace requad::theory {

bool Proof::proved() const {
  return failure().empty() && std::any_of(steps.begin(), steps.end(), [](const ProofStep& s) { return s.computed; });
}

std::string Proof::failure() const {
  const auto it = std::find_if(steps.begin(), steps.end(), [](const ProofStep& s) { return s.computed && !s.holds; });
  return it == steps.end() ? "" : it->text;
}

SideLaw side_law(PairType type) {
  const PairSystem system(type);
  return {type, system.strip_matrix(), system.first_offset(), system.last_offset()};
}

namespace {

const char* const kLaw1 =
    "Law 1, E_i = e_{i-1} + e_{i+1} + (d1 at the firsts) + (d2 at the lasts), describes every convex region with "
    "the pair, and each solution with all e_i >= 1 is one configuration (Lemmas 7.8-7.14; instances: L8, L10, T11).";
const char* const kEhrhart =
    "Ehrhart: the integer points of L P, P a rational polytope, are a quasi-polynomial in L >= 1 of degree <= dim P, "
    "its period dividing the denominators of P's vertices; also without some of its faces (inclusion and exclusion). "
    "Beck and Robins, Computing the Continuous Discretely, Theorem 3.23.";

// Collects the steps of a proof.
class Argument {
 public:
  explicit Argument(Proof& proof) : proof_(proof) {}
  void say(std::string text) { proof_.steps.push_back({std::move(text), false, true}); }
  bool require(bool holds, std::string text) {
    proof_.steps.push_back({std::move(text), true, holds});
    return holds;
  }

 private:
  Proof& proof_;
};

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

template <class Number>
std::string numbers(const std::vector<Number>& v) {
  std::string out;
  for (const Number& x : v) out += (out.empty() ? "" : ", ") + std::to_string(x);
  return out;
}

// An affine form's value is a L + b d1 + c d2.
struct Form {
  Rational length, d1, d2;
  Polynomial polynomial() const {
    return Polynomial(length) * Polynomial::variable(0) + Polynomial(d1) * Polynomial::variable(1) +
           Polynomial(d2) * Polynomial::variable(2);
  }
  std::string text() const { return polynomial().text({"L", "d1", "d2"}); }
};

// The strips of a regular region as forms in (L, d1, d2). Throws std::domain_error where they are not unique.
std::vector<Form> strip_forms(const SideLaw& law) {
  const RationalMatrix solve = inverse(to_rational(law.strips));
  const RationalVector length = solve * RationalVector(solve.size(), 1);
  const RationalVector first = solve * rational_vector(law.first);
  const RationalVector last = solve * rational_vector(law.last);
  std::vector<Form> forms;
  for (std::size_t i = 0; i < solve.size(); ++i) forms.push_back({length[i], -first[i], -last[i]});
  return forms;
}

std::string forms_text(const std::vector<Form>& forms) {
  std::string out;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    out += (i == 0 ? "e" : ", e") + std::to_string(i + 1) + " = " + forms[i].text();
  }
  return out;
}

// 2 e_i is an odd combination of L, d1 and d2, for every i: all e_i are integers exactly if L + d1 + d2 is even.
bool parity_decides(const std::vector<Form>& forms) {
  return std::all_of(forms.begin(), forms.end(),
                     [](const Form& f) { return f.length.is_odd_half() && f.d1.is_odd_half() && f.d2.is_odd_half(); });
}

// Law 3 for all d and e: both labellings of a segment have the same sides, and lead to each other. All is linear in d
// and e, and shifts of entries, so the unit vectors decide.
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

void say_segments(Argument& argue, PairType type) {
  argue.require(
      segments_agree(type),
      "A segment has two labellings, (d,0) and (0,d) with the strips shifted by one label (Law 3): their sides "
      "agree as linear forms in d and all e_i, and each leads back to the other.");
}

}  // namespace

SingleVertexPremises single_vertex_premises() {
  SingleVertexPremises premises;
  premises.matrix = [](int valence) {
    return PairSystem(valence == 2 ? kDigon : PairType{valence + 1, 3}).strip_matrix();
  };
  const Polynomial length = Polynomial::variable(0);
  premises.sharp_count = (length - 1) * (length - 1);
  return premises;
}

Proof prove_single_vertex(const SingleVertexPremises& premises) {
  Proof proof{"T1",
              "all valences l >= 2 and all sides",
              "A single irregular vertex whose valence 4 does not divide has at most one system of strips, whatever "
              "the sides; a regular region "
              "of any side L has exactly (L-1)^2 where 4 divides the valence.",
              {"E_i = e_{i-1} + e_{i+1} describes every convex region with one irregular vertex, and each solution "
               "with all e_i >= 1 is one "
               "configuration (instances: T1, L10).",
               kEhrhart},
              {}};
  Argument argue(proof);
  const Coefficients& s = premises.symbol;
  argue.say(
      "The matrix of the e_i is a circulant: multiplication by x^{l-1} + x in Q[x]/(x^l - 1). Times x, which is "
      "invertible there, it is "
      "multiplication by " +
      text(s, "x") + ", so the dimension of its kernel is the degree of gcd(" + text(s, "x") + ", x^l - 1).");
  Coefficients fourth(5, 0);
  fourth[0] = -1, fourth[4] = 1;
  argue.require(
      remainder(fourth, s).empty(),
      "x^4 = 1 modulo " + text(s, "x") + " (the remainder of x^4 - 1 is 0), so the gcd depends on l mod 4 only.");
  std::array<std::size_t, 4> kernel{};
  for (std::size_t residue = 0; residue < 4; ++residue) {
    Coefficients power(residue + 1, 0);
    power[residue] += 1;
    power[0] -= 1;
    if (residue == 0) power.clear();
    const Coefficients gcd = greatest_common_divisor(s, power);
    kernel[residue] = gcd.size() - 1;
    argue.require(kernel[residue] == (residue == 0 ? 2U : 0U),
                  "l = " + std::to_string(residue) + " mod 4: gcd(" + text(s, "x") + ", " + text(power, "x") +
                      ") = " + text(gcd, "x") +
                      (residue == 0 ? ", so the kernel has dimension 2." : ", so the strips are unique."));
  }
  bool same = true;
  for (int l = 2; l <= 16; ++l) {
    const IntegerMatrix m = premises.matrix(l);
    RationalMatrix circulant(static_cast<std::size_t>(l), RationalVector(static_cast<std::size_t>(l), 0));
    for (int i = 0; i < l; ++i) {
      for (std::size_t j = 0; j < s.size(); ++j) {
        circulant[static_cast<std::size_t>(i)]
                 [(static_cast<std::size_t>(i + l - 1) + j) % static_cast<std::size_t>(l)] += s[j];
      }
    }
    same = same && to_rational(m) == circulant &&
           rank(circulant) == l - static_cast<int>(kernel[static_cast<std::size_t>(l % 4)]);
  }
  argue.require(
      same, "The program's matrices for l = 2..16 are these circulants, and elimination gives the ranks just derived.");
  argue.say(
      "4 | l, all sides L: e_{i+2} = L - e_i, hence e_{i+4} = e_i. So e_1, ..., e_4 with e_1 + e_3 = e_2 + e_4 = L "
      "determine all, as for l = 4.");
  const Polytope square{premises.matrix(4), IntegerVector::Ones(4), std::vector<bool>(4, true)};
  const auto corners = vertices(square);
  const Integer period = common_denominator(corners);
  if (argue.require(surely_bounded(square) && !corners.empty(),
                    "Their polytope P (L = 1) is bounded, with " + std::to_string(corners.size()) +
                        " vertices whose denominators have the common multiple " + std::to_string(period) +
                        ", of dimension <= " + std::to_string(dimension_bound(square)) + ".")) {
    const QuasiPolynomial counted = counting_quasi_polynomial(square, period);
    for (const Polynomial& count : counted.by_residue) {
      argue.require(count == premises.sharp_count, "Counted at L = " + numbers(counted.samples) +
                                                       ", the number of e >= 1 is " + count.text({"L"}) +
                                                       "; stated is " + premises.sharp_count.text({"L"}) + ".");
    }
  }
  return proof;
}

Proof prove_strips_determined(const std::vector<SideLaw>& laws) {
  Proof proof{
      "T11",
      "all sides, d1, d2",
      "The linear system has a unique solution: sides and (d1,d2) determine all strips of a 3-3 or 5-5 pair; sides "
      "alone determine (d1,d2) "
      "of a 3-5 pair, and with (e1,e2) the other strips.",
      {kLaw1, "The intersection points (S_ij, u_ij) determine the labelling p and d1, d2, e1, e2 (instances: T11)."},
      {}};
  Argument argue(proof);
  for (const SideLaw& law : laws) {
    const int k = law.type.side_count();
    const RationalMatrix strips = to_rational(law.strips);
    if (k % 4 != 0) {
      argue.require(rank(strips) == k, law.type.name() + ": the matrix of the strips has rank " +
                                           std::to_string(rank(strips)) + " of k = " + std::to_string(k) +
                                           ", so E - d1 (firsts) - d2 (lasts) has one preimage, whatever the sizes.");
      continue;
    }
    // All unknowns at once: (d1, d2, e), with the rows of Law 1; then e1 and e2 given as well.
    RationalMatrix all = strips;
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].insert(all[i].begin(), {Rational(law.first(static_cast<Eigen::Index>(i))),
                                     Rational(law.last(static_cast<Eigen::Index>(i)))});
    }
    const int without = rank(all) - rank(strips);
    argue.require(without == 2,
                  law.type.name() + ": the columns of d1 and d2 raise the rank of the system from " +
                      std::to_string(rank(strips)) + " by " + std::to_string(without) +
                      ": none of their combinations is made by strips, so equal sides have equal d1 and d2.");
    RationalMatrix with_two = strips;
    for (std::size_t given = 0; given < 2; ++given) {
      with_two.emplace_back(strips.size(), 0);
      with_two.back()[given] = 1;
    }
    argue.require(rank(with_two) == k, law.type.name() + ": with e1 and e2 given the rank is " +
                                           std::to_string(rank(with_two)) + " of k = " + std::to_string(k) +
                                           ", so the other strips follow.");
  }
  return proof;
}

RegularPremises regular_premises(PairType type) {
  const int factor = type.rotation_count();
  return {side_law(type), true, false,
          [factor](const Polynomial& n, bool even) { return factor * tau_from_half(n, even); }};
}

Proof prove_regular_count(const RegularPremises& premises) {
  const SideLaw& law = premises.law;
  const int k = law.type.side_count();
  const int labellings = law.type.rotation_count();
  const bool digon = k == 2;
  Proof proof{digon ? "T2" : "T3",
              "all L >= 1",
              std::string("A regular ") + (digon ? "digon" : "hexagon") + " of any side L with a " + law.type.name() +
                  " pair has tau(L) configurations: the (m,n" +
                  (labellings > 1 ? ",p) with p = 1.." + std::to_string(labellings) + ", " : ") with ") +
                  "m >= 1, n >= 0, m+n <= L-2 and m+n = L mod 2, where (x,0" +
                  (labellings > 1 ? ",p) stands for (0,x,p+1) too." : ") stands for (0,x) too."),
              {kLaw1, kEhrhart},
              {}};
  Argument argue(proof);
  argue.say("All sides are L, so every labelling, p = 1.." + std::to_string(labellings) + ", has the same solutions.");
  say_segments(argue, law.type);
  argue.require(premises.d1_positive && !premises.d2_positive,
                "So d1 >= 1, d2 >= 0 takes every configuration once: (d,0) for itself and for (0,d).");

  if (!argue.require(rank(to_rational(law.strips)) == k,
                     "The matrix of the strips has full rank, so they are unique.")) {
    return proof;
  }
  const std::vector<Form> forms = strip_forms(law);
  argue.say("Law 1 solved for the strips: " + forms_text(forms) + ".");
  argue.require(parity_decides(forms),
                "Each 2 e_i is a combination of L, d1, d2 with odd coefficients: the strips are integers exactly if d1 "
                "+ d2 = L mod 2.");
  const Form least{Rational(1, 2), Rational(-1, 2), Rational(-1, 2)};
  bool is_least = false, none_below = true;
  for (const Form& f : forms) {
    is_least = is_least || f.polynomial() == least.polynomial();
    none_below = none_below && f.length >= least.length && f.d1 >= least.d1 && f.d2 >= least.d2;
  }
  argue.require(is_least && none_below, "The least of them, for L, d1, d2 >= 0, is " + least.text() +
                                            ": all are >= 1 exactly if d1 + d2 <= L - 2.");

  Polytope polygon{IntegerMatrix(k, k + 2), IntegerVector::Ones(k),
                   std::vector<bool>(static_cast<std::size_t>(k) + 2, true)};
  polygon.a << law.first, law.last, law.strips;
  polygon.strict[0] = premises.d1_positive;
  polygon.strict[1] = premises.d2_positive;
  const auto corners = vertices(polygon);
  std::string corner_text;
  for (const RationalVector& x : corners) corner_text += (corner_text.empty() ? "" : ", ") + list(x);
  if (!argue.require(surely_bounded(polygon) && !corners.empty(),
                     "In the unknowns (d1, d2, e_1, ..) these are the integer points of L P. P is bounded: no "
                     "coefficient of Law 1 is negative, and every "
                     "unknown occurs. Its vertices are " +
                         corner_text + ".")) {
    return proof;
  }
  const int degree = dimension_bound(polygon);
  const Integer period = std::lcm(common_denominator(corners), Integer{2});
  argue.say("So their number is a quasi-polynomial in L of degree <= " + std::to_string(degree) +
            " (unknowns less rank) and of period " + std::to_string(common_denominator(corners)) +
            " (denominators); tau, by floor(L/2), has period 2.");
  const QuasiPolynomial counted = counting_quasi_polynomial(polygon, period);
  const Polynomial length = Polynomial::variable(0);
  for (Integer residue = 0; residue < period; ++residue) {
    const Polynomial total = labellings * counted.by_residue[static_cast<std::size_t>(residue)];
    const bool even = residue % 2 == 0;
    const Polynomial stated = premises.tau((length - (even ? 0 : 1)) * Polynomial(Rational(1, 2)), even);
    std::vector<Integer> samples;
    for (const Integer sample : counted.samples) {
      if (sample % period == residue) samples.push_back(sample);
    }
    argue.require(total == stated,
                  "L = " + std::to_string(residue) + " mod " + std::to_string(period) + ": counted at L = " +
                      numbers(samples) + ", " + (labellings > 1 ? std::to_string(labellings) + " times " : "") +
                      "the number of points is " + total.text({"L"}) + "; tau is " + stated.text({"L"}) + ".");
  }
  bool same_set = true;
  for (const Integer sample : counted.samples) {
    const Integer listed = static_cast<Integer>(parameter_set(law.type, IntegerVector::Constant(k, sample)).size());
    same_set = same_set && Polynomial(listed) == Polynomial(labellings * count_lattice_points(polygon, sample));
  }
  argue.require(same_set, "parameter_set(), with which the instances are compared, has these sizes there.");
  if (digon) {
    // e1 and e2 in terms of their own sides: E2 - 2 e1 and E1 - 2 e2 are both d1 + d2.
    const RationalMatrix solve = inverse(to_rational(law.strips));
    const bool crosswise = solve == RationalMatrix{{0, Rational(1, 2)}, {Rational(1, 2), 0}} &&
                           law.first == IntegerVector::Ones(2) && law.last == IntegerVector::Ones(2);
    argue.require(crosswise,
                  "Any digon: e1 = (E2 - d1 - d2)/2 and e2 = (E1 - d1 - d2)/2. If E1 and E2 differ in parity there is "
                  "none; else the shorter side alone "
                  "decides, and there are tau(min(E1,E2)).");
  }
  argue.say(
      "A region that grows to the regular one by s_i >= 0 strips has no more: Law 1 is linear in e, so e -> e + s, "
      "with d1, d2 and p kept, takes its "
      "solutions one to one into those for L, and s shifts along where a segment has two labellings.");
  return proof;
}

QuadPremises quad_premises() {
  const auto x = [](std::size_t i) { return Polynomial::variable(i); };
  return {side_law(kQuad), x(1) - 1, x(0) - x(4) - 1};  // M = E2 - 1, N = E1 - d1 - 1
}

Proof prove_quad_count(const QuadPremises& premises) {
  Proof proof{"T4",
              "all sides E1..E4",
              "Every region with a 3-5 pair has exactly M N configurations, M = E2 - 1 and N = E1 - d1 - 1 in the one "
              "labelling with d1 >= 1, d2 >= 0; "
              "(e1, e2) runs over 1..M, 1..N.",
              {kLaw1, kEhrhart},
              {}};
  Argument argue(proof);
  const SideLaw& law = premises.law;
  const std::vector<std::string> names{"E1", "E2", "E3", "E4", "d1", "d2"};
  say_segments(argue, law.type);

  // Law 1 with w = (E1 - E3, E2 - E4) = D (d1, d2), the strips gone.
  const std::array<RationalVector, 2> differences{RationalVector{1, 0, -1, 0}, RationalVector{0, 1, 0, -1}};
  bool strips_cancel = true;
  RationalMatrix d(2);
  for (std::size_t r = 0; r < 2; ++r) {
    for (Eigen::Index c = 0; c < 4; ++c) strips_cancel = strips_cancel && dot(differences[r], law.strips.col(c)) == 0;
    d[r] = {dot(differences[r], law.first), dot(differences[r], law.last)};
  }
  const auto pair_text = [](const RationalVector& row) {
    return (Polynomial(row[0]) * Polynomial::variable(0) + Polynomial(row[1]) * Polynomial::variable(1))
        .text({"d1", "d2"});
  };
  if (!argue.require(strips_cancel && rank(d) == 2, "The strips cancel in E1 - E3 = " + pair_text(d[0]) +
                                                        " and E2 - E4 = " + pair_text(d[1]) +
                                                        ", which determine d1 and d2: no remeshing changes them.")) {
    return proof;
  }

  // Labels one further: (E1 - E3, E2 - E4) becomes (E2 - E4, E3 - E1).
  const RationalMatrix back = inverse(d);
  RationalMatrix turn(2, RationalVector(2));
  for (std::size_t c = 0; c < 2; ++c) {
    const RationalVector moved = back * RationalVector{d[1][c], -d[0][c]};
    for (std::size_t r = 0; r < 2; ++r) turn[r][c] = moved[r];
  }
  bool once = turn[0][0] == 0 && turn[1][1] == 0 && (turn[0][1] == 1 || turn[0][1] == -1) && turn[0][1] == -turn[1][0];
  for (int sx = -1; sx <= 1; ++sx) {
    for (int sy = -1; sy <= 1; ++sy) {
      if (sx == 0 && sy == 0) continue;
      RationalVector sign{sx, sy};
      int inside = 0;
      for (int p = 1; p <= law.type.rotation_count(); ++p) {
        inside += sign[0] > 0 && sign[1] >= 0 ? 1 : 0;
        sign = turn * sign;
      }
      once = once && inside == 1;
    }
  }
  argue.require(
      once,
      "Labels one side further turn (d1,d2) into " + list(turn[0]) + ", " + list(turn[1]) +
          " times it, a quarter turn, so of the four labellings of any sides, "
          "opposite ones not both equal, exactly one has d1 > 0 and d2 >= 0. (Eight patterns of signs, all tried.)");

  // Two of the four rows are left: one in e1, e3, one in e2, e4.
  const bool blocks = to_rational(law.strips) == RationalMatrix{{0, 1, 0, 1}, {1, 0, 1, 0}, {0, 1, 0, 1}, {1, 0, 1, 0}};
  const auto right_side = [&](Eigen::Index row) {
    return Polynomial::variable(static_cast<std::size_t>(row)) - law.first(row) * Polynomial::variable(4) -
           law.last(row) * Polynomial::variable(5);
  };
  if (!argue.require(blocks, "The rows left are e1 + e3 = " + right_side(1).text(names) +
                                 " and e2 + e4 = " + right_side(0).text(names) +
                                 ", independent of each other; "
                                 "the other two say the same.")) {
    return proof;
  }
  const Polytope segment{IntegerMatrix::Ones(1, 2), IntegerVector::Ones(1), {true, true}};
  const Integer period = common_denominator(vertices(segment));
  const QuasiPolynomial counted = counting_quasi_polynomial(segment, period);
  const Polynomial& split = counted.by_residue.front();
  argue.require(surely_bounded(segment) && period == 1,
                "a + b = s with a, b >= 1 are the points of s times a segment with vertices (1,0), (0,1), without its "
                "ends: counted at s = " +
                    numbers(counted.samples) + ", their number is " + split.text({"s"}) +
                    " for all s >= 1 (none for s < 1).");
  const auto solutions = [&](const Polynomial& s) {
    return Polynomial(split.coefficient({1})) * s + split.coefficient({});
  };
  for (const auto& [stated, row, letter] :
       {std::tuple{premises.m, Eigen::Index{1}, "M"}, std::tuple{premises.n, Eigen::Index{0}, "N"}}) {
    const Polynomial found = solutions(right_side(row));
    argue.require(found == stated,
                  std::string(letter) + " is " + found.text(names) + "; stated is " + stated.text(names) + ".");
  }
  argue.say(
      "Each solution of one row goes with each of the other: K = M N. Sides for which d1 and d2 are not integers, or N "
      "is negative, have no configuration.");
  return proof;
}

FacePremises face_premises(PairType type) {
  FacePremises premises{side_law(type),
                        [type](const Polynomial& d1, const Polynomial& d2, const std::vector<Polynomial>& e) {
                          return PairSystem(type).face_formula(d1, d2, e);
                        },
                        {}};
  if (type.symmetric()) {
    // Half the growth of d1^2 + d2^2, which a 5-5 region gains with the distance of its pair and a 3-3 region loses.
    const int sign = type == kDigon ? -1 : 1;
    premises.stated = [sign](const Polynomial& d1, const Polynomial& d2, Integer m, Integer n) {
      return sign * (m * d1 + n * d2 + 1);
    };
  } else {
    premises.stated = [](const Polynomial& d1, const Polynomial& d2, Integer m, Integer n) {
      return m * (d1 - d2) - n * (d1 + d2);
    };
  }
  return premises;
}

Proof prove_face_change(const std::vector<FacePremises>& premises) {
  Proof proof{"P3",
              "all d1, d2, e_i",
              "A step (m,n) changes the number of quads by m d1 + n d2 + 1 for a 5-5 pair, by minus that for a 3-3 "
              "pair, and by m (d1 - d2) - n (d1 + d2) for a "
              "3-5 pair: by the length d1 + d2 of the connecting path, or the difference of its legs.",
              {kLaw1,
               "The number of quads is d1 d2 + the sum of e_i e_{i+1} + d1 (e of the firsts) + d2 (e of the lasts) "
               "(instances: P3)."},
              {}};
  Argument argue(proof);
  const Polynomial d1 = Polynomial::variable(0);
  const Polynomial d2 = Polynomial::variable(1);
  for (const FacePremises& about : premises) {
    const SideLaw& law = about.law;
    const auto k = static_cast<std::size_t>(law.type.side_count());
    std::vector<std::string> names{"d1", "d2"};
    std::vector<Polynomial> e;
    for (std::size_t i = 0; i < k; ++i) {
      names.push_back("e" + std::to_string(i + 1));
      e.push_back(Polynomial::variable(i + 2));
    }
    const Polynomial before = about.faces(d1, d2, e);
    for (int step = 0; step < kStepCount; ++step) {
      const GridPoint delta = step_offset(law.type, step);
      // The sides stay, so Law 1 fixes the change of the strips; a 3-5 step is in its kernel.
      RationalVector change(k, 0);
      bool keeps_sides = true;
      std::string what;
      if (law.type.symmetric()) {
        const IntegerVector rest = -delta.m * law.first - delta.n * law.last;
        change = inverse(to_rational(law.strips)) * rational_vector(rest);
        what = "(d1,d2) + (" + std::to_string(delta.m) + "," + std::to_string(delta.n) + ")";
      } else {
        change[0] = delta.m, change[2] = -delta.m, change[1] = delta.n, change[3] = -delta.n;
        what = "(e1,e2) + (" + std::to_string(delta.m) + "," + std::to_string(delta.n) + ")";
        for (const Rational& side : to_rational(law.strips) * change) keeps_sides = keeps_sides && side == 0;
      }
      std::vector<Polynomial> moved;
      bool integral = true;
      for (std::size_t i = 0; i < k; ++i) {
        integral = integral && change[i].is_integer();
        moved.push_back(e[i] + change[i]);
      }
      const Polynomial after =
          law.type.symmetric() ? about.faces(d1 + delta.m, d2 + delta.n, moved) : about.faces(d1, d2, moved);
      const Polynomial grown = after - before;
      const Polynomial stated = about.stated(d1, d2, delta.m, delta.n);
      argue.require(keeps_sides && integral && grown == stated,
                    law.type.name() + ", " + what + ": the strips change by " + list(change) +
                        ", the number of quads by " + grown.text(names) + "; stated is " + stated.text(names) + ".");
    }
  }
  return proof;
}

Proof prove_no_cancelling(const SideLaw& law) {
  Proof proof{"N1",
              "all sides, d1, d2, e_i",
              "A region with a 3-5 pair has two opposite sides of different length; so it has no filling without "
              "irregular vertices.",
              {kLaw1,
               "A convex region without irregular vertices is a rectangular grid, so its opposite sides are equal (Law "
               "1 for valence 4; instances: N1, T1)."},
              {}};
  Argument argue(proof);
  RationalMatrix differences;
  bool strips_cancel = true;
  for (const RationalVector& y : {RationalVector{1, 0, -1, 0}, RationalVector{0, 1, 0, -1}}) {
    for (Eigen::Index c = 0; c < law.strips.cols(); ++c) {
      strips_cancel = strips_cancel && dot(y, law.strips.col(c)) == 0;
    }
    differences.push_back({dot(y, law.first), dot(y, law.last)});
  }
  const auto side = [&](std::size_t r) {
    return (Polynomial(differences[r][0]) * Polynomial::variable(0) +
            Polynomial(differences[r][1]) * Polynomial::variable(1))
        .text({"d1", "d2"});
  };
  argue.require(strips_cancel, "In E1 - E3 and E2 - E4 every e_i cancels, so with d1 = d2 = 0 both are 0.");
  argue.require(rank(differences) == 2, "With the pair E1 - E3 = " + side(0) + " and E2 - E4 = " + side(1) +
                                            ", two independent forms: both are 0 only for d1 = d2 = 0.");
  argue.say(
      "d1 and d2 are not both 0, as v1 and v2 are two vertices. A shift of the labels exchanges the two differences up "
      "to sign.");
  return proof;
}

Proof prove_merging_parity(const std::vector<SideLaw>& laws) {
  Proof proof{"N2",
              "all L >= 1",
              "In a regular digon or hexagon of any side L a 3-3 or 5-5 pair has d1 + d2 = L mod 2, and the merged "
              "vertex fits exactly if L is even: so the "
              "distance is even exactly where there is room to merge.",
              {kLaw1,
               "That moves lead to the merged vertex wherever it fits, and the distance is d1 + d2, is checked on "
               "instances only."},
              {}};
  Argument argue(proof);
  for (const SideLaw& law : laws) {
    if (!argue.require(rank(to_rational(law.strips)) == law.type.side_count(),
                       law.type.name() + ": the strips are unique.")) {
      return proof;
    }
    const std::vector<Form> forms = strip_forms(law);
    argue.require(parity_decides(forms),
                  law.type.name() + ": " + forms_text(forms) + ", so they are integers only if d1 + d2 = L mod 2.");
    const bool halves =
        std::all_of(forms.begin(), forms.end(), [](const Form& f) { return f.length == Rational(1, 2); });
    argue.require(halves,
                  law.type.name() + ": with d1 = d2 = 0 every strip is L/2, an integer >= 1 exactly if L is even.");
  }
  return proof;
}

std::optional<Proof> proof_of(const std::string& claim) {
  if (claim == "T1") return prove_single_vertex();
  if (claim == "T2") return prove_regular_count(regular_premises(kDigon));
  if (claim == "T3") return prove_regular_count(regular_premises(kHexagon));
  if (claim == "T4") return prove_quad_count();
  if (claim == "T11") return prove_strips_determined();
  if (claim == "P3") return prove_face_change();
  if (claim == "N1") return prove_no_cancelling();
  if (claim == "N2") return prove_merging_parity();
  return std::nullopt;
}

}  // namespace requad::theory
