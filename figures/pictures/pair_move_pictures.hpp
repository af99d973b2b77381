// Figures 6-8: pairs before and after moves, which the library makes on the mesh that is drawn.
#pragma once

#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

Paint paint_pair_moves();        // Figure 6
Paint paint_detour();            // Figure 7
Paint paint_equal_pair_moves();  // Figure 8

}  // namespace requad::figures
