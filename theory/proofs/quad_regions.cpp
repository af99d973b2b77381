// T4: M N configurations in a region with a 3-5 pair. N1: such a region is never a regular grid.
#include <array>
#include <tuple>

#include "theory/joined.hpp"
#include "theory/proofs/argument.hpp"
#include "theory/proofs/polytope.hpp"

namespace requad::theory {

QuadPremises quad_premises() {
  const auto x = [](std::size_t i) { return Polynomial::variable(i); };
  return {side_law(kQuad), x(1) - 1, x(0) - x(4) - 1};  // M = E2 - 1, N = E1 - d1 - 1
}

namespace {

// A polynomial in (E1, E2, E3, E4, d1, d2).
std::string quad_text(const Polynomial& p) { return p.text({"E1", "E2", "E3", "E4", "d1", "d2"}); }

// E1 - E3 and E2 - E4 by the side law. Where the strips cancel, they are the rows of `matrix` times (d1, d2).
struct OppositeSides {
  bool strips_cancel = true;
  RationalMatrix matrix;

  // Of row 0 or 1: "d1 - d2".
  std::string text(std::size_t row) const {
    return (Polynomial(matrix[row][0]) * Polynomial::variable(0) + Polynomial(matrix[row][1]) * Polynomial::variable(1))
        .text({"d1", "d2"});
  }
  bool independent() const { return rank(matrix) == 2; }
};

OppositeSides opposite_sides(const SideLaw& law) {
  OppositeSides result;
  for (const RationalVector& difference : {RationalVector{1, 0, -1, 0}, RationalVector{0, 1, 0, -1}}) {
    for (Eigen::Index c = 0; c < law.strips.cols(); ++c) {
      result.strips_cancel = result.strips_cancel && dot(difference, law.strips.col(c)) == 0;
    }
    result.matrix.push_back({dot(difference, law.first), dot(difference, law.last)});
  }
  return result;
}

// What (d1, d2) becomes, as a matrix, when the labels move one side further: (E1 - E3, E2 - E4) becomes
// (E2 - E4, E3 - E1). Precondition: the opposite sides are independent.
RationalMatrix label_rotation(const RationalMatrix& differences) {
  const RationalMatrix back = inverse(differences);
  RationalMatrix rotation(2, RationalVector(2));
  for (std::size_t c = 0; c < 2; ++c) {
    const RationalVector moved = back * RationalVector{differences[1][c], -differences[0][c]};
    for (std::size_t r = 0; r < 2; ++r) rotation[r][c] = moved[r];
  }
  return rotation;
}

bool is_quarter_turn(const RationalMatrix& m) {
  return m[0][0] == 0 && m[1][1] == 0 && (m[0][1] == 1 || m[0][1] == -1) && m[0][1] == -m[1][0];
}

// True if, from every pattern of signs of (d1, d2) but (0, 0), exactly one of `count` rotations has d1 > 0 and d2 >= 0.
bool one_in_quadrant(const RationalMatrix& rotation, int count) {
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      if (x == 0 && y == 0) continue;
      RationalVector sign{x, y};
      int inside = 0;
      for (int p = 0; p < count; ++p) {
        inside += sign[0] > 0 && sign[1] >= 0 ? 1 : 0;
        sign = rotation * sign;
      }
      if (inside != 1) return false;
    }
  }
  return true;
}

// d1 and d2 follow from the sides, and one labelling has d1 > 0, d2 >= 0. False if d1 and d2 do not follow.
bool require_one_labelling(Argument& argue, const SideLaw& law) {
  const OppositeSides differences = opposite_sides(law);
  if (!argue.require(differences.strips_cancel && differences.independent(),
                     "The strips cancel in E1 - E3 = " + differences.text(0) + " and E2 - E4 = " + differences.text(1) +
                         ". These determine d1 and d2, so no remeshing changes them.")) {
    return false;
  }
  const RationalMatrix rotation = label_rotation(differences.matrix);
  argue.require(is_quarter_turn(rotation) && one_in_quadrant(rotation, law.type.rotation_count()),
                "When the labels move one side further, (d1,d2) is multiplied by the rows " + list(rotation[0]) + ", " +
                    list(rotation[1]) +
                    ", a quarter turn. So exactly one of the four labellings has d1 > 0 and d2 >= 0, unless both "
                    "pairs of opposite sides are equal. (All eight patterns of signs were tried.)");
  return true;
}

// E_{row + 1} minus what d1 and d2 add to it: the sum that two opposite strips must have.
Polynomial strip_sum(const SideLaw& law, Eigen::Index row) {
  return Polynomial::variable(static_cast<std::size_t>(row)) - law.first(row) * Polynomial::variable(4) -
         law.last(row) * Polynomial::variable(5);
}

// Two of the four rows are left: one in e1 and e3, one in e2 and e4.
bool require_two_rows(Argument& argue, const SideLaw& law) {
  const RationalMatrix rows{{0, 1, 0, 1}, {1, 0, 1, 0}, {0, 1, 0, 1}, {1, 0, 1, 0}};
  return argue.require(to_rational(law.strips) == rows,
                       "The rows left are e1 + e3 = " + quad_text(strip_sum(law, 1)) +
                           " and e2 + e4 = " + quad_text(strip_sum(law, 0)) +
                           ". They are independent of each other, and the other two say the same.");
}

// The number of a, b >= 1 with a + b = s, as a polynomial in s.
Polynomial require_splits(Argument& argue) {
  const Polytope segment{IntegerMatrix::Ones(1, 2), IntegerVector::Ones(1), {true, true}};
  const Integer period = common_denominator(vertices(segment));
  const QuasiPolynomial counted = counting_quasi_polynomial(segment, period);
  Polynomial splits = counted.by_residue.front();
  argue.require(surely_bounded(segment) && period == 1,
                "The solutions of a + b = s with a, b >= 1 are the points of s times the segment from (1,0) to (0,1), "
                "without its ends. Counted at s = " +
                    joined(counted.samples, ", ") + ", their number is " + splits.text({"s"}) +
                    " for all s >= 1 (none for s < 1).");
  return splits;
}

}  // namespace

Proof prove_quad_count(const QuadPremises& premises) {
  Proof proof{"T4",
              "all sides E1..E4",
              "Every region with a 3-5 pair has exactly M N configurations, M = E2 - 1 and N = E1 - d1 - 1 in the one "
              "labelling with d1 >= 1, d2 >= 0; (e1, e2) runs over 1..M, 1..N.",
              {kSideLawPremise, kEhrhartPremise},
              {}};
  Argument argue(proof);
  const SideLaw& law = premises.law;
  require_segments_agree(argue, law.type);
  if (!require_one_labelling(argue, law)) return proof;
  if (!require_two_rows(argue, law)) return proof;

  const Polynomial splits = require_splits(argue);
  for (const auto& [stated, row, letter] :
       {std::tuple{premises.m, Eigen::Index{1}, "M"}, std::tuple{premises.n, Eigen::Index{0}, "N"}}) {
    const Polynomial found = Polynomial(splits.coefficient({1})) * strip_sum(law, row) + splits.coefficient({});
    argue.require(found == stated,
                  std::string(letter) + " is " + quad_text(found) + "; stated is " + quad_text(stated) + ".");
  }
  argue.say(
      "Each solution of one row goes with each of the other, so K = M N. If d1 and d2 are not integers, or N is "
      "negative, "
      "the region has no configuration.");
  return proof;
}

Proof prove_no_cancelling(const SideLaw& law) {
  Proof proof{"N1",
              "all sides, d1, d2, e_i",
              "A region with a 3-5 pair has two opposite sides of different length. So it has no filling without "
              "irregular vertices.",
              {kSideLawPremise,
               "A convex region without irregular vertices is a rectangular grid, so its opposite sides are equal (the "
               "side law for valence 4; instances: N1, T1)."},
              {}};
  Argument argue(proof);
  const OppositeSides differences = opposite_sides(law);
  argue.require(differences.strips_cancel, "In E1 - E3 and E2 - E4 every e_i cancels, so with d1 = d2 = 0 both are 0.");
  argue.require(differences.independent(), "With the pair, E1 - E3 = " + differences.text(0) +
                                               " and E2 - E4 = " + differences.text(1) +
                                               ". The two forms are independent, so both are 0 only for d1 = d2 = 0.");
  argue.say(
      "d1 and d2 are not both 0, since v1 and v2 are two vertices. A shift of the labels exchanges the two "
      "differences, "
      "up to sign.");
  return proof;
}

}  // namespace requad::theory
