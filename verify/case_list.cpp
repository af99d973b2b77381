#include "verify/case_list.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace requad::verify {

namespace {

using theory::Integer;
using theory::RegionShape;

// Calls visit(sides) for every sequence of k positive integers with this sum that is the least of its rotations.
template <class Visit>
void for_each_necklace(int k, Integer sum, Visit&& visit) {
  std::vector<Integer> sides(static_cast<std::size_t>(k), 1);
  const auto least_rotation = [&] {
    for (int shift = 1; shift < k; ++shift) {
      std::vector<Integer> rotated(sides.begin() + shift, sides.end());
      rotated.insert(rotated.end(), sides.begin(), sides.begin() + shift);
      if (rotated < sides) return false;
    }
    return true;
  };
  const auto fill = [&](auto&& self, std::size_t at, Integer left) -> void {
    if (at + 1 == sides.size()) {
      sides[at] = left;
      if (least_rotation()) visit(sides);
      return;
    }
    for (Integer x = sides.front(); left - x >= static_cast<Integer>(sides.size() - at) - 1; ++x) {
      sides[at] = x;
      self(self, at + 1, left - x);
    }
  };
  // The first entry is the least one, so the others start from it.
  for (Integer first = 1; first * k <= sum; ++first) {
    sides[0] = first;
    if (k == 1) {
      if (first == sum) visit(sides);
    } else {
      fill(fill, 1, sum - first);
    }
  }
}

using Cases = std::vector<RegionCase>;

void add_regular(Cases& cases, theory::PairType type, program::Range lengths) {
  for (Integer length = lengths.first; length <= lengths.last; ++length)
    cases.push_back(PairCase{RegionShape::regular(type, length)});
}

void add_by_perimeter(Cases& cases, theory::PairType type, program::Range perimeters, bool with_regular) {
  const int k = type.side_count();
  for (Integer perimeter = std::max<Integer>(perimeters.first, k); perimeter <= perimeters.last; ++perimeter) {
    if (perimeter % 2 != 0) continue;
    for_each_necklace(k, perimeter, [&](const std::vector<Integer>& sides) {
      RegionShape shape(type, theory::to_vector(sides));
      if (with_regular || !shape.is_regular()) cases.push_back(PairCase{std::move(shape)});
    });
  }
}

void add_single_vertices(Cases& cases, program::Range perimeters) {
  for (int valence = 2; valence <= 12; ++valence) {
    for (const Integer length : {2, 3, 4, 6, 8})
      cases.push_back(VertexCase{theory::IntegerVector::Constant(valence, length)});
    if (valence == 4 || valence > 9) continue;
    for (Integer perimeter = perimeters.first; perimeter <= std::min<Integer>(perimeters.last, 20); ++perimeter) {
      if (perimeter < valence) continue;
      for_each_necklace(valence, perimeter, [&](const std::vector<Integer>& sides) {
        cases.push_back(VertexCase{theory::to_vector(sides)});
      });
    }
  }
}

void add_three_vertices(Cases& cases, program::Range perimeters) {
  // Valences and the largest perimeter. The number of fillings grows at least with the fourth power of the perimeter.
  const std::vector<std::pair<std::vector<int>, Integer>> kinds{
      {{3, 3, 3}, 20}, {{3, 3, 5}, 20}, {{3, 5, 5}, 18}, {{5, 5, 5}, 22}};
  for (const auto& [valences, largest] : kinds) {
    const int k = valences[0] + valences[1] + valences[2] - 8;
    for (Integer perimeter = perimeters.first; perimeter <= std::min(perimeters.last, largest); ++perimeter) {
      if (perimeter < k || perimeter % 2 != 0) continue;
      for_each_necklace(k, perimeter, [&, valences = valences](const std::vector<Integer>& sides) {
        cases.push_back(TripleCase{valences, theory::to_vector(sides)});
      });
    }
  }
}

}  // namespace

namespace {

struct Cost {
  double operator()(const PairCase& pair) const {
    return std::pow(static_cast<double>(pair.shape.perimeter()), 4) * pair.shape.type().rotation_count();
  }
  double operator()(const VertexCase& vertex) const { return std::pow(static_cast<double>(vertex.sides.sum()), 2); }
  double operator()(const TripleCase& triple) const {
    return 10 * std::pow(static_cast<double>(triple.sides.sum()), 5);
  }
};

}  // namespace

double cost_estimate(const RegionCase& region) { return std::visit(Cost{}, region); }

double cost_estimate(const std::vector<RegionCase>& cases) {
  double sum = 0;
  for (const RegionCase& region : cases) sum += cost_estimate(region);
  return sum;
}

std::vector<RegionCase> list_cases(const Ranges& ranges, const std::set<Family>& families) {
  Cases cases;
  const auto asked = [&families](Family family) { return families.count(family) > 0; };
  if (asked(Family::regular_digon)) add_regular(cases, theory::kDigon, ranges.digon);
  if (asked(Family::regular_hexagon)) add_regular(cases, theory::kHexagon, ranges.hexagon);
  if (asked(Family::quad)) add_by_perimeter(cases, theory::kQuad, ranges.quad_perimeter, true);
  if (asked(Family::other_digon)) add_by_perimeter(cases, theory::kDigon, ranges.other_perimeter, false);
  if (asked(Family::other_hexagon)) add_by_perimeter(cases, theory::kHexagon, ranges.other_perimeter, false);
  if (asked(Family::single_vertex)) add_single_vertices(cases, ranges.other_perimeter);
  if (asked(Family::three_vertices)) add_three_vertices(cases, ranges.other_perimeter);
  return cases;
}

}  // namespace requad::verify
