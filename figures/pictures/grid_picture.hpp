// Pictures of grids, with the mesh of each configuration at its node.
#pragma once

#include "figures/grid_figure.hpp"
#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

// Even grids are red and solid, odd ones blue and dashed. Each node shows its region, with R_alpha in blue, the ring in
// grey, the irregular vertices in their colours, and the label below. A copy is drawn faint and names its original. The
// region of a 3-5 pair also has two stars. They lie where the first and the middle outward separatrix of the v5 meet
// the boundary, at the distances n and m from the corner between them.
Paint paint_grid(const GridFigure& figure);

// A dual_figure() as a drawing of two graphs, with levels as circles and labels at the nodes.
Paint paint_dual(const GridFigure& figure);

}  // namespace requad::figures
