// Where a configuration stands in a drawing of its graph, in grid units, y upwards.
#pragma once

#include <array>

#include "theory/configurations.hpp"

namespace requad::enumerate {

using GridPosition = std::array<double, 2>;

// The drawings of the paper: (d1 - d2, d1 + d2) for a 3-3 pair (Figure 10), the half cube for a 5-5 pair (Figure 11),
// (m, n) for two different valences (Figure 12). A segment has two labellings and stands where the given one says.
GridPosition grid_position(theory::PairType type, const theory::Configuration& c);

// Quadrant p lies between two axes that are `apart` radians from each other; the axes are numbered clockwise, and the
// first has the angle `first`. So (x,0,p) and (0,x,p+1) lie on the same axis.
GridPosition position_on_axes(const theory::Configuration& c, double first, double apart);

}  // namespace requad::enumerate
