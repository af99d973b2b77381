// Regions in which atomic operations are tested: regular quads round one vertex or one pair.
#pragma once

#include <string>

#include "mesh/topology/region.hpp"

namespace requad::tests {

// A vertex of this valence in the middle of a region, four quads from every side. All other vertices are regular.
mesh::Region neighbourhood(int valence);
// An adjacent 3-5 pair in the middle of a region. All other vertices are regular.
mesh::Region pair_neighbourhood();

// The irregular vertex of this valence. For valence 4, a vertex whose neighbours have no neighbour on the boundary.
mesh::VertexId vertex_of(const mesh::QuadMesh& mesh, int valence);
// The signature of the mesh, rooted at the boundary vertex where the region has its root. Precondition: the mesh has
// the region's boundary.
std::string rel_boundary(const mesh::QuadMesh& mesh, const mesh::Region& region);

}  // namespace requad::tests
