// The census of small regions with a pair, as the theory lists them and enumerate/ glues them.
#pragma once

#include <vector>

#include "mesh/topology/region.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/theory/integer_vector.hpp"
#include "theory/configurations.hpp"

namespace requad::tests {

// One entry of the census: a region with a pair.
struct CensusEntry {
  theory::RegionShape shape;
  theory::Configuration configuration;
  mesh::Region region;
};
// Every configuration of every convex digon, hexagon and 3-5 region up to this perimeter, made by glue_region(). Each
// region occurs once up to rotation. Merged configurations are included if they are asked for.
std::vector<CensusEntry> census(int perimeter, bool with_merged);

}  // namespace requad::tests
