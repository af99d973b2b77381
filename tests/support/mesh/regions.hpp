// Small convex regions with one irregular vertex or a pair of them, for tests of mesh/. This file includes neither
// theory/ nor enumerate/; tests/enumerate/census_tests.cpp checks that these are the regions that the theory lists.
//
// Terms
//   core     the grid of quads that two irregular vertices v1, v2 span, as opposite corners. The core has d2 quads
//            along v1's first leg, and d1 quads along the second leg, which comes next counter-clockwise. It is a
//            segment if d1 or d2 is 0.
//   strips   the numbers of strips of quads between the core and each side of the region, 1 or more.
#pragma once

#include <vector>

#include "mesh/topology/region.hpp"

namespace requad::tests {

// A region with one vertex of valence strips.size() >= 2, which lies strips[i] quads from side i. The root is the start
// of side 0.
mesh::Region star(const std::vector<int>& strips);

// The valences of the two vertices, 3 or more, and the extents of their core, not both 0.
struct PairShape {
  int l1 = 3;
  int l2 = 3;
  int d1 = 1;
  int d2 = 0;
  int side_count() const { return l1 + l2 - 4; }
};
// A region with this pair. Sides are counted from v1 counter-clockwise. The root is the start of side 0. Precondition:
// `strips` has side_count() entries.
mesh::Region pair_region(const PairShape& shape, const std::vector<int>& strips);

struct SmallRegion {
  mesh::Region region;
  PairShape shape;  // l2 = 0: a star of valence l1
};
// The regions up to this perimeter with a 3-3, 3-5 or 5-5 pair and, if asked for, the stars of valence 2, 4 and 6. With
// Roots::one each region occurs once up to isomorphism. With Roots::each_corner every corner of it is the root once, up
// to isomorphisms that keep the root.
enum class Roots { one, each_corner };
std::vector<SmallRegion> small_regions(int perimeter, bool with_stars, Roots roots = Roots::one);

}  // namespace requad::tests
