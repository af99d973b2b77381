// The regions of certificates, their families, and the closed forms of Theorems 7.2, 7.3 and 7.4.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace check {

// A convex region with a pair of irregular vertices: 3-3 in a digon, 5-5 in a hexagon, 3-5 in a quadrilateral.
struct Region {
  int l1 = 3;  // the valences, the greater first
  int l2 = 3;
  std::vector<int> sides;  // counter-clockwise, l1 + l2 - 4 of them

  bool symmetric() const { return l1 == l2; }
  int side_count() const { return l1 + l2 - 4; }
  // The number of ways to lay the labels 1..k on the sides, short of swapping two equal vertices.
  int labellings() const { return symmetric() ? side_count() / 2 : side_count(); }
  int perimeter() const;
  bool regular() const;
  std::string name() const;  // "3-3-6-6": the lesser valence, the greater, the sides
  friend bool operator==(const Region&, const Region&) = default;
};

// The longest perimeter that is checked. It bounds the time that a closed form takes.
inline constexpr int kLongestPerimeter = 400;

// The region with this pair, "3-3", "5-5" or "3-5", and these sides. Throws Rejected if there is no such region, and
// Undecided if its perimeter is beyond kLongestPerimeter.
Region region_of(std::string_view pair, std::vector<int> sides);

// Theorem 7.2: with N = floor(L / 2), N (N - 1) for even L and N^2 for odd L.
long long tau(int length);

// The number of configurations by the closed form of the region's family.
//   regular digon     tau(L), Theorem 7.2
//   regular hexagon   3 tau(L), Theorem 7.3
//   3-5               K = M N, Theorem 7.4
//   other digons      tau(min(E1, E2)) if the sides have the same parity, 0 otherwise
//   other hexagons    the positive solutions of Equation 2, summed over d1 >= 1, d2 >= 0 and the three ways to lay
//                     labels on the sides; d1 = 0 repeats d2 = 0
// O(1), and O(L^2) for other hexagons.
long long closed_form(const Region& region);

// All regions of one kind in a range of sizes.
struct Family {
  const char* name;  // as in the MANIFEST
  const char* size;  // what the range is of: "sides" or "perimeters"
  int l1;
  int l2;
  bool with_regular;
  bool with_others;
  int most;  // the largest size that is checked
};
// "regular-digons", "regular-hexagons", "3-5-regions", "other-digons", "other-hexagons", in the order of the MANIFEST.
const std::vector<Family>& families();

// Calls visit(region) for each region of the family with a size in first..last that has an even boundary, once up to
// rotation of its sides: by size, then in lexicographic order of the sides, which start so that they come first among
// their rotations.
void for_each_region(const Family& family, int first, int last, const std::function<void(const Region&)>& visit);

}  // namespace check
