// All small quadrangulated disks, for tests of mesh/.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology/region.hpp"

namespace requad::tests {

// Every disk with this many boundary edges (even, 4 or more) and at most so many quads, up to an isomorphism that keeps
// the root, which is a boundary half-edge. Vertices of any valence from 2 on occur inside, and edges between vertices of
// the boundary. Made by the basic operations from one disk: number_of_disks() tells whether all were found.
std::vector<mesh::Region> small_disks(int perimeter, int faces);

// How many disks there are with this many boundary edges and exactly so many quads: W. G. Brown, Enumeration of quadrangular
// dissections of the disk, Canadian Journal of Mathematics 17 (1965), with a root that may be any boundary edge. For
// perimeter 4 these are the numbers of rooted nonseparable planar maps, OEIS A000139.
std::int64_t number_of_disks(int perimeter, int faces);

}  // namespace requad::tests
