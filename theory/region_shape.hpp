// The shape of a convex region with a pair: the pair's type and the side lengths. The constructor checks them.
//
// Terms
//   labelling p     the labels 1..k on the sides, so that label i lies on side i + p - 1, indices modulo k.
//   regular         all sides are equal.
#pragma once

#include <string>
#include <vector>

#include "theory/pair_system.hpp"

namespace requad::theory {

class RegionShape {
 public:
  // Throws problem() as std::invalid_argument. O(k^2).
  RegionShape(PairType type, IntegerVector sides);
  // All sides have this length. Throws like the constructor.
  static RegionShape regular(PairType type, Integer length);

  // One line that says why no convex region has these sides, or "" if the sides make sense: k entries, each in
  // 1..kMaxLength, with an even sum (the boundary of a quadrangulated disk is even).
  static std::string problem(PairType type, const IntegerVector& sides);

  const PairType& type() const { return system_.type(); }
  // theory-1 for this type.
  const PairSystem& system() const { return system_; }
  int side_count() const { return type().side_count(); }
  // E_1..E_k, in the order of the region's sides.
  const IntegerVector& sides() const { return labelled_.front(); }
  // The lengths of the sides that bear the labels 1..k of labelling p. Precondition: 1 <= p <= k.
  const IntegerVector& labelled_sides(int p) const { return labelled_[static_cast<std::size_t>(p - 1)]; }

  Integer perimeter() const { return perimeter_; }
  Integer shortest() const { return shortest_; }
  Integer longest() const { return longest_; }
  bool is_regular() const { return shortest_ == longest_; }
  // Whether E_1 + E_3 + E_5 + ... is odd. For even k the other sides have the same parity, since the perimeter is even.
  // A regular digon or hexagon of side L is odd exactly if L is.
  bool is_odd() const { return odd_; }

  friend bool operator==(const RegionShape& a, const RegionShape& b) {
    return a.type() == b.type() && a.sides() == b.sides();
  }

 private:
  PairSystem system_;
  std::vector<IntegerVector> labelled_;  // [p - 1]
  Integer perimeter_ = 0;
  Integer shortest_ = 0;
  Integer longest_ = 0;
  bool odd_ = false;
};

}  // namespace requad::theory
