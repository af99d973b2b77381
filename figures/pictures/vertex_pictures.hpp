// Figures 3-5: meshes before and after atomic operations, which the library performs on the mesh that is drawn.
#pragma once

#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

Paint paint_adjacent_pair_moves();  // Figure 3
Paint paint_vertex_moves();         // Figure 4
Paint paint_type_changes();         // Figure 5

}  // namespace requad::figures
