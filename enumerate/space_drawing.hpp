// A place in space for each vertex of any connected mesh, closed or not, of any genus: so that a mesh that is known by its
// connectivity alone can be written to a file.
//
// Spectral drawing: the coordinates are the three smoothest eigenvectors of the graph's Laplacian after the constant
// one, scaled to one size. A sphere comes out round and a torus as a ring; quads are neither planar nor of equal size.
// The same mesh gives the same bits.
#pragma once

#include "mesh/geometry/measures.hpp"
#include "mesh/topology/quad_mesh.hpp"

namespace requad::enumerate {

// By vertex slot. Precondition: the mesh is connected. A sparse factorisation, then O(V) for each of some hundred
// iterations.
mesh::Positions space_drawing(const mesh::QuadMesh& mesh);

}  // namespace requad::enumerate
