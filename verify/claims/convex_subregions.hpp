// All convex regions inside a mesh, by exhaustion. Private to this folder.
//
// A convex region is a set of faces, a disk, without a concave vertex on its boundary (Definition 7.5). The enumeration
// decides face by face whether it is in the set, and uses nothing but this definition: no strip, no rectangle and no
// closed form. So it can judge what the lemmas say of convex regions.
#pragma once

#include <vector>

#include <boost/dynamic_bitset.hpp>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::verify {

using FaceSet = boost::dynamic_bitset<>;  // by index in QuadMesh::faces()

// Which irregular vertices a region may have on its boundary.
enum class BoundaryIrregular {
  none,    // as sections 7.2 to 7.4 assume
  convex,  // those with at least two quads outside: straight, or convex, or sharp
};

// The irregular vertices of the mesh that a region has in its interior, and on its boundary.
struct ConvexSubregion {
  FaceSet faces;
  std::vector<mesh::VertexId> inside;
  std::vector<mesh::VertexId> on_boundary;
};
// Every convex region of the mesh, once, in no certain order. The time grows with the number of connected sets of faces
// that are convex as far as they are decided: milliseconds for 25 faces. Precondition: ids without gaps.
std::vector<ConvexSubregion> convex_subregions(const mesh::QuadMesh& mesh, BoundaryIrregular on_boundary);

// The boundary of a convex region, counter-clockwise: half-edges with the region on their left. Precondition: the set is
// a disk.
std::vector<mesh::HalfEdgeId> boundary_of(const mesh::QuadMesh& mesh, const FaceSet& faces);

// The sides of a convex region: the half-edges between one corner and the next, counter-clockwise. A vertex with m quads
// outside is m - 2 corners; a sharp convex turn point is two, with a side of no edges between. A vertex on the boundary
// of the mesh counts as if it were regular. Precondition: the set is a convex region of the mesh with a corner.
std::vector<std::vector<mesh::HalfEdgeId>> sides_of(const mesh::QuadMesh& mesh, const FaceSet& faces);

}  // namespace requad::verify
