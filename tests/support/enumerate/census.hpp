// The census of small regions with a pair, as the theory lists them and enumerate/ glues them.
#pragma once

#include <vector>

#include "mesh/topology/region.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/theory/integer_vector.hpp"
#include "theory/configurations.hpp"

namespace requad::tests {

// One region with a pair, as the census lists it.
struct CensusEntry {
  theory::RegionShape shape;
  theory::Configuration configuration;
  mesh::Region region;
};
// Every configuration of every convex digon, hexagon and 3-5 region of perimeter up to this, each region once up to
// rotation, merged configurations included if asked for. By glue_region().
std::vector<CensusEntry> census(int perimeter, bool with_merged);

}  // namespace requad::tests
