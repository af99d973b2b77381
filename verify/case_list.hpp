// The regions of a campaign, listed from ranges of sizes.
#pragma once

#include <set>
#include <vector>

#include "mesh/program/run/numbers.hpp"
#include "verify/studies/region_case.hpp"

namespace requad::verify {

// Sizes of regions. Ranges are inclusive; a range whose last is below its first is empty.
struct Ranges {
  program::Range digon{3, 24};    // side length of regular digons
  program::Range hexagon{3, 12};  // side length of regular hexagons
  program::Range quad_perimeter{8, 24};
  program::Range other_perimeter{4, 24};  // of non-regular digons and hexagons, and of regions without a pair
};

// Lists each region once up to rotation of its sides, ordered by family, then by perimeter, then by sides. A region is
// listed whether it has a configuration or not: the studies find out. Nothing of theory/ chooses the regions.
//   pairs            all regions of the ranges (a RegionShape has an even perimeter).
//   single vertices  regular regions of sides 2, 3, 4, 6 and 8 for the valences 2 to 12 (4 is the regular grid), and
//                    all regions of other_perimeter up to 20 for the valences 2 to 9 except 4.
//   three vertices   all regions of other_perimeter for three vertices, each a v3 or a v5, up to perimeters between 18
//                    and 22 that depend on the valences; even perimeters, as for pairs.
std::vector<RegionCase> list_cases(const Ranges& ranges, const std::set<Family>& families);

// An estimate of the work that a case is, beside that of other cases; and the sum of some.
double cost_estimate(const RegionCase& region);
double cost_estimate(const std::vector<RegionCase>& cases);

}  // namespace requad::verify
