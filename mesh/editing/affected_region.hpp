// What a run of edits changed: the vertices, and their surroundings.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/editing/editor.hpp"
#include "mesh/geometry/smoothing.hpp"
#include "mesh/topology/distances.hpp"

namespace requad::mesh {

struct AffectedRegion {
  std::vector<VertexId> changed;  // live vertices whose valence changed or that were made, sorted
  std::vector<VertexId> removed;  // ids of vertices that were removed and not made again, sorted
  std::vector<VertexId> near;     // the changed ones and those within some rings of them, by distance
  std::size_t inner = 0;          // so many of `near`, from the front, lie within one ring less
};

// Of the edits after the first `mark` ones, with this many rings. `near` holds fixed vertices too. O(its size).
AffectedRegion affected_region_since(const Editor& editor, BreadthFirstDistances& surroundings, std::size_t mark,
                                     int rings);

// Smooths some vertices, as one edit; those that are fixed stay. `how.fixed` is overridden.
void smooth_edit(Editor& editor, std::span<const VertexId> vertices, SmoothingOptions how);

}  // namespace requad::mesh
