// The graph that an exploration found, as the paper draws it: labellings at their positions, and lines between them.
//
// Terms
//   spot    A position in the drawing with the labelling that it shows. A segment of equal valences has two labellings.
//           If these have two positions, as (x,0) and (0,x) in Figure 10, the configuration has two spots. The second
//           one is a copy.
//   line    An edge between the spots of the labellings before and after a move. A move and its inverse are one line.
//           If labellings share a spot, two lines may join the same spots, or a line may join a spot to itself.
#pragma once

#include <functional>
#include <vector>

#include "enumerate/exploration.hpp"
#include "enumerate/graphs/grid_position.hpp"

namespace requad::enumerate {

struct GridSpot {
  int node = -1;     // index in Exploration::nodes
  int same_as = -1;  // for a copy: the spot of its original
  theory::Configuration labelling;
  GridPosition at;
};

struct GridLine {
  int from = -1;  // indices of spots
  int to = -1;
  const FoundMove* move = nullptr;  // leads from `from` to `to`
};

struct GridDrawing {
  std::vector<GridSpot> spots;  // in the order of nodes; a copy follows its original
  std::vector<GridLine> lines;
};

// `position` says where a labelling lies. The moves of the result are those of `found`, which must outlive it. Throws
// std::logic_error if a move leads to a labelling that has no spot. O((nodes + moves) log nodes).
GridDrawing grid_drawing(const Exploration& found,
                         const std::function<GridPosition(const theory::Configuration&)>& position);
// With the positions of the paper's figures (grid_position()).
GridDrawing grid_drawing(const Exploration& found);

}  // namespace requad::enumerate
