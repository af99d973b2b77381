// Figures 2-8: operations before and after, each made by the library on the mesh that is drawn.
#pragma once

#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

Paint paint_basic_operations();     // Figure 2
Paint paint_adjacent_pair_moves();  // Figure 3
Paint paint_vertex_moves();         // Figure 4
Paint paint_type_changes();         // Figure 5
Paint paint_pair_moves();           // Figure 6
Paint paint_detour();               // Figure 7
Paint paint_equal_pair_moves();     // Figure 8

}  // namespace requad::figures
