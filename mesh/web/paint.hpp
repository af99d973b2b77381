// What colours tell of the quads of a mesh: one number for each quad, of which the screen makes a colour.
//
//   plain         0
//   quality       the scaled Jacobian (measures.hpp), 0 to 1
//   checkerboard  a colour, 0, 1, 2, ..., other than those of adjacent quads (Figure 19); 0 and 1 as far as that goes
//   stripes       0 or 1: whether stripes run along the quad's first edge or along its second one. Stripes of adjacent
//                 quads join where that is possible (Figures 1 and 17).
// In every paint, -1 marks an inverted quad.
#pragma once

#include <span>
#include <vector>

#include "mesh/geometry/measures.hpp"

namespace requad::web {

enum class Paint { plain, quality, checkerboard, stripes };

// Whether an edit can change the number of quads far away.
inline bool is_global(Paint paint) { return paint == Paint::checkerboard || paint == Paint::stripes; }

// The number of a quad for a paint that is not global. O(1).
float local_paint(const mesh::QuadMesh& mesh, const mesh::Positions& positions, mesh::FaceId f, Paint paint);
// The numbers of all quads, by face slot. O(F).
std::vector<float> paint_all(const mesh::QuadMesh& mesh, const mesh::Positions& positions, Paint paint);

}  // namespace requad::web
