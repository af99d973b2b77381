// Figure 2: meshes before and after basic operations, which the library performs on the mesh that is drawn.
#pragma once

#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

// Throws std::logic_error if the flip does not give the same mesh as the split and the collapse.
Paint paint_basic_operations();

}  // namespace requad::figures
