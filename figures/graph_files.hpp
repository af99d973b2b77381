// Grid figures as graphs: DOT by libcgraph, GraphML by Boost.
#pragma once

#include <string>

#include "figures/grid_figure.hpp"

namespace requad::figures {

// Both hold the same attributes.
//   nodes   label, d1, d2, p, m, n (of the grid), faces and signature of the mesh, sides of the region; a copy also
//           same_as, the name of its original
//   edges   step, direction (what the step adds to m and n), operations (basic ones; splits, collapses and flips apart)
//           and faces (made minus deleted)
// The same figure gives the same bytes.

// With positions in points, so that `neato -n2` draws the grid as it is.
std::string to_dot(const GridFigure& figure);
// With x and y in grid units.
std::string to_graphml(const GridFigure& figure);

}  // namespace requad::figures
