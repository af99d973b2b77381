// Reduces the number of inverted quads by smoothing round them.
//
// Guarded smoothing (smoothing.hpp) cannot undo a fold, because on the way some quad gets worse. So the vertices round
// inverted quads are first smoothed without a guard, like a membrane, and then with one. If this does not lower the
// number of inverted quads, the smoothing is rolled back and tried again in a wider neighbourhood.
//
// Law editing-21. The number of inverted quads never grows, and no fixed vertex moves.
#pragma once

#include "mesh/editing/affected_region.hpp"

namespace requad::mesh {

struct Untangling {
  int before = 0;  // number of inverted faces
  int after = 0;
};

// Makes edits of the editor, which must have positions. `how` has the weights, the guard of the second smoothing, and
// the constraints. Costs a few hundred smoothing steps for each vertex near inverted faces, and O(F) for each attempt.
Untangling untangle(Editor& editor, SmoothingOptions how);

}  // namespace requad::mesh
