// Grid figures as graphs, in DOT and GraphML.
//
// Attributes in both formats
//   nodes   label, d1, d2, p; m and n, the point of the grid; faces and signature of the mesh; sides of the region; for
//           a copy also same_as, the name of its original
//   edges   step; direction (what the step adds to m and n); operations, the number of basic operations, and among
//           them splits, collapses and flips; faces (made minus deleted)
// The same figure gives the same bytes.
#pragma once

#include <string>

#include "figures/grid_figure.hpp"

namespace requad::figures {

// The figure as DOT, written by libcgraph. Positions are in points, so `neato -n2` draws the grid without changing it.
std::string to_dot(const GridFigure& figure);
// The figure as GraphML, with the names of the nodes. Attributes have their types; x and y are in grid units.
std::string to_graphml(const GridFigure& figure);

// One of the figure's grids by itself: a file of GraphML should have one configuration graph. No edge joins two grids.
GridFigure grid_alone(const GridFigure& figure, std::size_t grid);

}  // namespace requad::figures
