// Small convex regions with one irregular vertex or a pair of them, for tests of mesh/: they know neither theory/ nor
// enumerate/. tests/enumerate/census_tests.cpp sees that they are the regions that the theory lists.
//
// Terms
//   core     what the two irregular vertices span: a grid of quads with v1 and v2 at opposite corners, d2 quads along v1's
//            first leg and d1 along the second, which is counter-clockwise of it; a segment if d1 or d2 is 0
//   strips   how many layers of quads lie between the core and each side of the region, 1 or more
#pragma once

#include <vector>

#include "mesh/topology/region.hpp"

namespace requad::tests {

// One vertex of valence strips.size() >= 2, and strips[i] quads from it to side i. Root: the start of side 0.
mesh::Region star(const std::vector<int>& strips);

// Valences of the two vertices (3 or more) and the extents of their core, not both 0.
struct PairShape {
  int l1 = 3;
  int l2 = 3;
  int d1 = 1;
  int d2 = 0;
  int side_count() const { return l1 + l2 - 4; }
};
// A region with this pair. Sides are counted from v1 counter-clockwise. Precondition: strips has side_count() entries.
// Root: the start of side 0.
mesh::Region pair_region(const PairShape& shape, const std::vector<int>& strips);

struct SmallRegion {
  mesh::Region region;
  PairShape shape;  // l2 = 0: a star of valence l1
};
// The regions with a pair 3-3, 3-5 or 5-5 and, if asked for, the stars of valence 2, 4 and 6, of at most this perimeter:
// each once up to isomorphism, or once for each corner as its root up to an isomorphism that keeps the root.
enum class Roots { one, each_corner };
std::vector<SmallRegion> small_regions(int perimeter, bool with_stars, Roots roots = Roots::one);

}  // namespace requad::tests
