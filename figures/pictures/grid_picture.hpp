// Pictures of grids, with the mesh of each configuration at its node.
#pragma once

#include "figures/grid_figure.hpp"
#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

// Even grids are solid, odd ones dashed. Each node shows its region, with R_alpha, its ring and the irregular vertices,
// and a label beside it that covers no edge. A copy is drawn faint and names its original. The region of a 3-5 pair also
// has two stars. They lie where the first and the middle outward separatrix of the v5 meet the boundary, at the distances
// n and m from the corner between them. A legend is below.
Paint paint_grid(const GridFigure& figure);

// A dual_figure() as a drawing of two graphs, with levels as circles and labels at the nodes.
Paint paint_dual(const GridFigure& figure);

}  // namespace requad::figures
