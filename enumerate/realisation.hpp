// The third generator: a shortest path of moves realises a configuration from another one (proof of Theorem 7.2).
#pragma once

#include <vector>

#include "enumerate/exploration.hpp"

namespace requad::enumerate {

struct Realisation {
  mesh::Region region;
  std::vector<theory::Configuration> path;       // from the start to the target, both included, canonical
  std::vector<mesh::PairMove> moves;             // between them
  std::vector<mesh::BasicOperation> operations;  // of all moves, on the mesh of the start
};

// The configuration to start from: the merged one if the region has one, else the first with the least d1 + d2. In a
// regular region of odd side that is (1,0), the paper's (0,1). Throws std::invalid_argument if the region has no
// configuration.
theory::Configuration simplest_configuration(const theory::RegionShape& shape);

// Follows a shortest path of the predicted graph, which includes the apex, by moves on the glued mesh of `from`. The
// labels read off the mesh after a move decide whether it is the right one. Throws std::invalid_argument if one of the
// two is not a configuration of the region, and std::logic_error if no move makes a predicted step. O(path * mesh).
Realisation realise(const theory::RegionShape& shape, const theory::Configuration& from,
                    const theory::Configuration& to);

}  // namespace requad::enumerate
