#include "verify/check/region.hpp"

#include <algorithm>
#include <numeric>

#include "verify/check/reading.hpp"

namespace check {

int Region::perimeter() const { return std::accumulate(sides.begin(), sides.end(), 0); }

bool Region::regular() const {
  return std::all_of(sides.begin(), sides.end(), [this](int side) { return side == sides.front(); });
}

std::string Region::name() const {
  std::string text = std::to_string(l2) + "-" + std::to_string(l1);
  for (const int side : sides) text += "-" + std::to_string(side);
  return text;
}

Region region_of(std::string_view pair, std::vector<int> sides) {
  Region region;
  if (pair == "3-5") {
    region.l1 = 5;
  } else if (pair == "5-5") {
    region.l1 = region.l2 = 5;
  } else {
    require(pair == "3-3", "the pair is none of 3-3, 5-5, 3-5");
  }
  require(sides.size() == static_cast<std::size_t>(region.side_count()), "the pair needs another number of sides");
  int left = kLongestPerimeter;
  for (const int side : sides) {
    require(side > 0, "a side is 0");
    if (side > left)
      throw Undecided("the sides add up to more than " + std::to_string(kLongestPerimeter) + ", which is not checked");
    left -= side;
  }
  region.sides = std::move(sides);
  return region;
}

long long tau(int length) {
  const long long n = length / 2;
  return length % 2 == 0 ? n * (n - 1) : n * n;
}

namespace {

// The sides, so that side(1) bears label 1 of labelling p.
class Labelled {
 public:
  Labelled(const Region& region, int p) : region_(region), p_(p) {}
  int operator()(int label) const {
    return region_.sides[static_cast<std::size_t>(label + p_ - 2) % region_.sides.size()];
  }

 private:
  const Region& region_;
  int p_;
};

// Whether a + b = x, b + c = y, c + a = z for positive integers.
bool positive(int x, int y, int z) { return (x + y + z) % 2 == 0 && x < y + z && y < z + x && z < x + y; }

long long hexagon(const Region& region) {
  long long count = 0;
  for (int p = 1; p <= 3; ++p) {
    const Labelled side(region, p);
    for (int d1 = 1; d1 < std::min(side(1), side(4)); ++d1) {
      for (int d2 = 0; d2 < std::min(side(3), side(6)); ++d2) {
        const bool even = positive(side(1) - d1, side(3) - d2, side(5));  // e6 + e2, e2 + e4, e4 + e6
        const bool odd = positive(side(2), side(4) - d1, side(6) - d2);   // e1 + e3, e3 + e5, e5 + e1
        if (even && odd) ++count;
      }
    }
  }
  return count;
}

// The sides fix d1 and d2 by d1 + d2 = E4 - E2 and d1 - d2 = E1 - E3. Then M = E2 - 1 and N = E1 - d1 - 1.
long long quadrilateral(const Region& region) {
  for (int p = 1; p <= 4; ++p) {
    const Labelled side(region, p);
    const int sum = side(4) - side(2), difference = side(1) - side(3);
    if ((sum + difference) % 2 != 0) continue;
    const int d1 = (sum + difference) / 2, d2 = (sum - difference) / 2;
    if (d1 >= 1 && d2 >= 0) return static_cast<long long>(side(2) - 1) * std::max(side(1) - d1 - 1, 0);
  }
  return 0;
}

}  // namespace

long long closed_form(const Region& region) {
  if (!region.symmetric()) return quadrilateral(region);
  if (region.l1 == 3) {
    const auto [least, most] = std::minmax(region.sides[0], region.sides[1]);
    return (most - least) % 2 == 0 ? tau(least) : 0;
  }
  return region.regular() ? 3 * tau(region.sides[0]) : hexagon(region);
}

const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"regular-digons", "sides", 3, 3, true, false, 100},     {"regular-hexagons", "sides", 5, 5, true, false, 40},
      {"3-5-regions", "perimeters", 5, 3, true, true, 100},    {"other-digons", "perimeters", 3, 3, false, true, 40},
      {"other-hexagons", "perimeters", 5, 5, false, true, 40},
  };
  return all;
}

namespace {

bool first_of_rotations(const std::vector<int>& sides) {
  std::vector<int> rotated = sides;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
    if (rotated < sides) return false;
  }
  return true;
}

}  // namespace

void for_each_region(const Family& family, int first, int last, const std::function<void(const Region&)>& visit) {
  Region region{family.l1, family.l2, {}};
  const auto k = static_cast<std::size_t>(region.side_count());
  region.sides.assign(k, 0);
  // Side `at` and those after it, which add up to `left`. None is less than the first one.
  const std::function<void(std::size_t, int)> choose = [&](std::size_t at, int left) {
    const int least = at == 0 ? 1 : region.sides[0];
    const int after = static_cast<int>(k - at) - 1;
    if (after == 0) {
      region.sides[at] = left;
      if (left >= least && (family.with_regular || !region.regular()) && first_of_rotations(region.sides))
        visit(region);
      return;
    }
    for (int side = least; left - side >= after * (at == 0 ? side : least); ++side) {
      region.sides[at] = side;
      choose(at + 1, left - side);
    }
  };
  for (int size = first; size <= last; ++size) {
    if (!family.with_others) {
      region.sides.assign(k, size);
      visit(region);
    } else if (size % 2 == 0) {
      choose(0, size);
    }
  }
}

}  // namespace check
