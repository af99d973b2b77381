// The linear system that ties a pair of irregular vertices to the side lengths of its convex region.
//
// Terms (paper, section 7; used by every header of this folder)
//   pair            two irregular vertices v1, v2 of valences l1 >= l2 >= 3 inside a convex region R.
//   R_alpha         the d1 x d2 grid between v1 and v2, which are opposite corners of it (Lemma 7.8). If d1 or d2 is
//                   0, it is a segment.
//   leg             a separatrix of v1 or v2 that runs along R_alpha. Each vertex has two.
//                   Counter-clockwise, the first leg comes before the second, with R_alpha between them, and the
//                   outward ones follow.
//   d1, d2          the extents of R_alpha: d1 along the second leg of v1, d2 along its first leg.
//   outward         any other separatrix. v1 has l1 - 2 of them and v2 has l2 - 2. They are numbered 1..k
//                   counter-clockwise round R, those of v1 first. k = l1 + l2 - 4 = 4 - G(R) is also the number of
//                   sides of R (Lemma 7.9).
//   side i          the side of R that crosses outward separatrix i at a right angle. Its length is E_i >= 1 edges.
//   strips e_i      the number of quad strips between R_alpha and side i (Lemmas 7.12-7.14). e_i >= 1 unless an
//                   irregular vertex lies on the boundary.
//
// theory-1  E_i = e_{i-1} + e_{i+1} + (d1 if i is the first outward separatrix of v1 or v2)
//                                   + (d2 if i is the last outward separatrix of v1 or v2),   indices modulo k.
// In words: side i runs from side i-1 to side i+1. Its length is the sum of the distances from separatrix i to these
// two sides. Where a neighbouring side belongs to the other vertex, the distance grows by the displacement of the
// vertices. For (l1,l2) = (3,3), (5,5), (5,3) this is the digon's system, Equation 2 and Equation 3 of the paper. It
// holds for any two valences >= 3, and with d1 = d2 = 0 for one vertex of valence k.
//
// theory-2  the matrix of the e_i is a circulant. It is singular exactly if 4 divides k. Theorem 7.1 is about the single
//           vertices of the other valences k.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace requad::theory {

using Integer = std::int64_t;
using IntegerVector = Eigen::Matrix<Integer, Eigen::Dynamic, 1>;
using IntegerMatrix = Eigen::Matrix<Integer, Eigen::Dynamic, Eigen::Dynamic>;

// The values as a vector. O(n).
inline IntegerVector to_vector(const std::vector<Integer>& values) {
  return IntegerVector::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}
// The vector v' with v'_i = v_{i + by}, indices modulo k: label i reads v'_i when label 1 lies on entry `by` (0-based).
// O(k).
IntegerVector rotated(const IntegerVector& v, Eigen::Index by);

// The greatest length that parameters may have. Products of two lengths, and sums of a few of these, fit in 64 bits.
inline constexpr Integer kMaxLength = 1'000'000;

// The valences of a pair, the greater first. The paper has three: 3-3 in a digon, 5-5 in a hexagon, 3-5 in a
// quadrilateral.
struct PairType {
  int l1 = 3;
  int l2 = 3;

  int side_count() const { return l1 + l2 - 4; }
  bool symmetric() const { return l1 == l2; }
  // The number of ways to lay the labels 1..k on the sides. Labellings that only swap two equal vertices count once.
  int rotation_count() const { return symmetric() ? side_count() / 2 : side_count(); }
  // Whether the configurations of one region can differ in p alone, so that their labels have it as a third index, as in
  // Theorem 7.3. A digon has one labelling. The sides of a region with a 3-5 pair fix p (Theorem 7.4), but for a segment,
  // which has a second labelling by theory-3.
  bool has_third_index() const { return rotation_count() > 1 && side_count() != 4; }
  // "3-3", "5-5", "3-5": the smaller valence first, as the paper writes it.
  std::string name() const;

  friend bool operator==(const PairType&, const PairType&) = default;
};

inline constexpr PairType kDigon{3, 3};
inline constexpr PairType kHexagon{5, 5};
inline constexpr PairType kQuad{5, 3};
// The pair type with this name: two valences with "-" between them, in any order, each in 3..100 and none of them 4.
// Returns nothing for any other text.
std::optional<PairType> pair_type(std::string_view name);

// (d1, d2, e_1..e_k): the separatrix-strip parameters.
struct StripParameters {
  Integer d1 = 0;
  Integer d2 = 0;
  IntegerVector e;
};

// theory-1 as matrices: E = strip_matrix() * e + d1 * first_offset() + d2 * last_offset().
class PairSystem {
 public:
  // Precondition: type.l1 >= type.l2 >= 3.
  explicit PairSystem(PairType type);

  const PairType& type() const { return type_; }
  const IntegerMatrix& strip_matrix() const { return strips_; }
  const IntegerVector& first_offset() const { return first_; }
  const IntegerVector& last_offset() const { return last_; }

  // Side lengths E_1..E_k. Precondition: parameters.e has k entries.
  IntegerVector side_lengths(const StripParameters& parameters) const;

  // All e with every e_i >= 1 that give the sides E with these d1, d2, in lexicographic order. There is at most one
  // unless 4 divides k. Exact, in integers. O(k) for each solution.
  std::vector<IntegerVector> solve_strips(const IntegerVector& sides, Integer d1, Integer d2) const;

  // The number of quads: d1 d2 + sum e_i e_{i+1} + d1 (e of the two firsts) + d2 (e of the two lasts). Each term counts
  // one kind of rectangle: R_alpha, those between consecutive outward separatrices, and those along the legs.
  Integer face_count(const StripParameters& parameters) const;
  // The same for any kind of number, polynomials included (proofs.hpp). Precondition: e has k entries.
  template <class Number>
  Number face_formula(const Number& d1, const Number& d2, const std::vector<Number>& e) const {
    Number faces = d1 * d2;
    for (std::size_t i = 0; i < e.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      faces = faces + e[i] * e[(i + 1) % e.size()] + Number(first_(at)) * d1 * e[i] + Number(last_(at)) * d2 * e[i];
    }
    return faces;
  }

 private:
  PairType type_;
  IntegerMatrix strips_;
  IntegerVector first_;
  IntegerVector last_;
};

// All positive solutions of e_{i-1} + e_{i+1} = c_i (indices modulo k = c.size() >= 1), in lexicographic order. This is
// the system of a single vertex (Theorem 7.1), and theory-1 becomes this system when d1 and d2 are given. There is at
// most one solution unless 4 divides k.
std::vector<IntegerVector> solve_circulant(const IntegerVector& c);

// The exact determinant, by fraction-free elimination (Bareiss). Precondition: the matrix is square, and its minors fit
// in 64 bits.
Integer determinant(IntegerMatrix matrix);

}  // namespace requad::theory
