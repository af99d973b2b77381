// All small quadrangulated disks, for tests of mesh/.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology/region.hpp"

namespace requad::tests {

// All disks with this many boundary edges (even, 4 or more) and at most this many quads, up to isomorphisms that keep
// the root, a boundary half-edge. Interior vertices have any valence of 2 or more, and an edge may join two boundary
// vertices. The basic operations make all disks from one of them; number_of_disks() shows whether one is missing.
std::vector<mesh::Region> small_disks(int perimeter, int faces);

// The number of disks with this many boundary edges and exactly this many quads. The root may be any boundary edge.
// Source: W. G. Brown, Enumeration of quadrangular dissections of the disk, Canadian Journal of Mathematics 17 (1965).
// For perimeter 4 these are the numbers of rooted nonseparable planar maps, OEIS A000139.
std::int64_t number_of_disks(int perimeter, int faces);

}  // namespace requad::tests
