// The affected region of some edits: the vertices that they changed, and those near them.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/editing/editor.hpp"
#include "mesh/topology/distances.hpp"

namespace requad::mesh {

struct AffectedRegion {
  std::vector<VertexId> changed;  // live vertices that were made or whose valence changed, sorted
  std::vector<VertexId> removed;  // ids of vertices that were removed and not made again, sorted
  std::vector<VertexId> near;     // the changed vertices and those within some rings of them, by distance
  std::size_t inner = 0;          // how many of `near`, from the front, lie within one ring less
};

// The region of the edits after the first `mark` ones, with so many rings. `near` holds fixed vertices too. `distances`
// is working memory. O(size of the region).
AffectedRegion affected_region_since(const Editor& editor, BreadthFirstDistances& distances, std::size_t mark,
                                     int rings);

}  // namespace requad::mesh
