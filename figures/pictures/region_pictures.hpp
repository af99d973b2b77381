// Figures 13 and 14, and the configurations of a single vertex: regions, their boundaries and separatrices.
#pragma once

#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

// Figure 13: the turns of an open path and of a loop, and the smallest regions.
Paint paint_turns_and_smallest();
// Figure 14: a region of each kind with separatrices, strips and side lengths.
Paint paint_separatrices();
// The (L-1)^2 configurations of a single v8 in the regular octagon of side L, which show that Theorem 7.1 is sharp.
// Precondition: length >= 2.
Paint paint_lone_v8(int length);

}  // namespace requad::figures
