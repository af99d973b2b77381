// Figure 2: the basic operations before and after, performed by the library on the mesh that is drawn.
#pragma once

#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

// Throws std::logic_error if a flip is not a split and a collapse.
Paint paint_basic_operations();

}  // namespace requad::figures
