// Fewer inverted quads, by relaxing round them.
//
// A guarded step (smoothing.hpp) can not lead a fold out of itself: on the way some quad gets worse. So the vertices
// round inverted quads are relaxed without a guard, as on a membrane, then with one; what did not help is taken back
// and tried with a wider neighbourhood.
//
// Law U. The number of inverted quads never grows, and no fixed vertex moves.
#pragma once

#include "mesh/editing/affected_region.hpp"

namespace requad::mesh {

struct Untangling {
  int before = 0;  // inverted faces
  int after = 0;
};

// As edits of the editor, which has positions. Weights and surface are those of `how`. Costs a few hundred smoothing
// steps for each vertex near inverted faces, and O(F) for each round.
Untangling untangle(Editor& editor, SmoothingOptions how);

}  // namespace requad::mesh
