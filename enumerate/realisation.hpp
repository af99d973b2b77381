// The third generator: a configuration realised by a shortest path of moves from a simple one (proof of Theorem 7.2).
#pragma once

#include <vector>

#include "enumerate/exploration.hpp"

namespace requad::enumerate {

struct Realisation {
  mesh::Region region;
  std::vector<theory::Configuration> path;  // from the start to the target, canonical
  std::vector<mesh::PairMove> moves;
  std::vector<mesh::BasicOperation> operations;  // of all moves, on the start's mesh
};

// The configuration where realise() starts: the merged one if the region has one, else the first of the lowest level,
// (1,0) in a regular region of odd side (the paper's (0,1)). Throws std::invalid_argument if the region has no
// configuration at all.
theory::Configuration simplest_configuration(const theory::RegionShape& shape);

// A shortest path in the predicted graph (with apex), made move by move on the mesh of `from`; each move is chosen by the
// labels read off the mesh. Throws std::invalid_argument if one of the two is no configuration of the region, and
// std::logic_error if a predicted step is refused. O(path * mesh).
Realisation realise(const theory::RegionShape& shape, const theory::Configuration& from,
                    const theory::Configuration& to);

}  // namespace requad::enumerate
