// The grids of Figures 10, 11 and 12 as drawings: configurations found by moves, at the places the paper gives them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "enumerate/exploration.hpp"

namespace requad::figures {

struct GridNode {
  std::string name;         // unique in the figure
  std::string label;        // "(m,n)" or "(m,n,p)"
  std::array<double, 2> at; // in grid units, y upwards
  std::string colour;       // a Graphviz colour
  int same_as = -1;         // the node of which this is a second copy, or -1
  theory::Configuration configuration;
  int faces = 0;
  std::string signature;
};

struct GridEdge {
  int from = -1;
  int to = -1;
  std::string step;    // the pair move from `from` to `to`
  int operations = 0;  // basic operations of that move
  int faces = 0;       // faces made minus faces deleted by it
  std::string colour;
};

struct GridFigure {
  std::string title;
  std::vector<GridNode> nodes;
  std::vector<GridEdge> edges;
};

// Figure 10: the grids of the regular digons of side L (even: red, odd: blue) and L - 1 on one rotated grid, (m,n) at
// (m - n, m + n). (x,0) and (0,x) are one configuration: the second is drawn too, as a copy that names the first.
GridFigure figure_10(int length);
// Figure 11: the grids of the regular hexagons of side L and L - 1 as half cubes in projection, side by side.
GridFigure figure_11(int length);
// Figure 12: the grid of a region with a 3-5 pair, d1 x d2 = R_alpha, M x N configurations.
GridFigure figure_12(int d1, int d2, int m, int n);
// All throw std::invalid_argument where there is no such region.

}  // namespace requad::figures
