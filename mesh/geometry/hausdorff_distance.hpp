// How far two surfaces are apart.
#pragma once

#include "mesh/geometry/measures.hpp"
#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

// A mesh with its positions, by vertex slot, neither of which is copied.
struct SurfaceView {
  const QuadMesh& mesh;
  const Positions& positions;
};

// An estimate from below of the Hausdorff distance: the largest distance of a point of either surface from the other,
// over samples. The samples of a triangle are the points with barycentric coordinates in multiples of 1 / density,
// which are its corners, density - 1 points of each side, and some points inside.
//
// Law geometry-2. The exact distance lies between the result and the result + (longest side of a triangle) /
//                 (sqrt(3) * density), because distance is 1-Lipschitz and each point of a triangle is as close as that
//                 to a sample.
// O(F density^2) queries of a SurfaceIndex. Preconditions: both meshes have a face; density >= 1.
double hausdorff_distance(SurfaceView a, SurfaceView b, int density = 4);

}  // namespace requad::mesh
