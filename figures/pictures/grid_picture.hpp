// Pictures of grids: the mesh of each configuration at its node.
#pragma once

#include "figures/grid_figure.hpp"
#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

// Even grids red and solid, odd ones blue and dashed. At each node the region, R_alpha blue, its ring grey, the
// irregular vertices in their colours, the label below; a copy is drawn faint and names its original. A 3-5 pair's
// region also has two stars, where the v5's first and middle outward separatrices meet the boundary: their distances
// from the corner between them are n and m.
Paint paint_grid(const GridFigure& figure);

// A dual_figure() as graphs: levels as circles, nodes as their labels.
Paint paint_dual(const GridFigure& figure);

}  // namespace requad::figures
