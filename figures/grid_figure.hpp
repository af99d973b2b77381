// Configuration graphs as figures: the configurations found by moves, at their positions in a picture.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "enumerate/exploration.hpp"
#include "mesh/irregular/pair_frame.hpp"
#include "mesh/pictures/style.hpp"

namespace requad::figures {

using namespace pictures;

struct GridNode {
  std::string name;                     // unique in the figure
  std::string label;                    // "(m,n)" or "(m,n,p)"
  std::array<double, 2> at;             // in grid units, y upwards
  int grid = 0;                         // which of the figure's grids
  int same_as = -1;                     // for a copy, the index of its original; otherwise -1
  theory::Configuration configuration;  // the labelling drawn here; a copy and its original have different ones
  mesh::Region region;
  mesh::PairFrame frame;  // of this labelling
  std::string signature;

  int faces() const { return region.mesh.face_count(); }
};

struct GridEdge {
  int from = -1;
  int to = -1;
  std::string step;              // the pair move from `from` to `to`, as mesh::name() says
  std::string direction;         // what the step adds to the label: "(+1,-1)"
  theory::Configuration before;  // the labellings before and after the step
  theory::Configuration after;
  int splits = 0;  // basic operations of that move; a split makes a face, a collapse deletes one
  int collapses = 0;
  int flips = 0;

  int operations() const { return splits + collapses + flips; }
  int faces() const { return splits - collapses; }  // made minus deleted
};

// The parity of d1 + d2, which the moves of a 3-3 or 5-5 pair keep. A 3-5 pair has none.
enum class Parity { even, odd, none };

// One grid of a figure: all configurations of a pair in one region.
struct Grid {
  theory::RegionShape shape;
  Parity parity;

  bool upside_down = false;  // turned by half a turn, with the meshes at its nodes

  Colour colour(const Palette& palette) const {
    return parity == Parity::even ? palette.even : parity == Parity::odd ? palette.odd : palette.single;
  }
};

struct GridFigure {
  std::string title;
  std::vector<Grid> grids;
  std::vector<GridNode> nodes;
  std::vector<GridEdge> edges;
};

// Figure 10: the grids of the regular digons of side L and L - 1 on one rotated grid, with (m,n) at (m - n, m + n).
// (x,0) and (0,x) are one configuration; the second is drawn as a copy that names the first.
GridFigure figure_10(int length);
// Figure 11: the grids of the regular hexagons of side L and L - 1 as half cubes in projection, side by side. The second
// is upside down, so that the two triangles fit together.
GridFigure figure_11(int length);
// Figure 12: the grid of the M x N configurations of a region whose 3-5 pair spans d1 x d2 quads, with (m,n) at (m,n).
// If d1 = 0, the segment of length d2 is taken as (d2, 0), its canonical labelling.
GridFigure figure_12(int d1, int d2, int m, int n);

// The grid of any hexagon, as a part of a half cube.
GridFigure hexagon_figure(const std::vector<theory::Integer>& sides);
// The half cube of the regular hexagon, cut open along one edge and laid flat: three quadrants, with the cut drawn
// twice.
GridFigure unfolded_figure(int length);
// The grids of side L and L - 1 on top of each other, with each cone opened to a disk: level s = m + n is the circle of
// radius s. Each edge of one grid crosses an edge of the other, its dual.
GridFigure dual_figure(theory::PairType type, int length);
// All six functions throw std::invalid_argument if there is no such region.

}  // namespace requad::figures
