// Signatures: printable strings that are equal iff the meshes are isomorphic, and from which a mesh can be rebuilt.
//
// A rooted signature walks the mesh breadth-first from one half-edge. Faces are numbered as they are met; in each face
// the half-edges are taken in order from the one it was entered by. Each edge writes one number when it is first taken:
//   0       a boundary edge
//   1       a face not met before
//   g + 1   the half-edge that is g >= 1 places further in the order, in a face already met
// in base 32, low digit first, with a 64-letter alphabet whose upper half says "more follows". So the string fixes the
// mesh with its root and orientation, up to names: two rooted meshes have one string iff they are isomorphic by a map
// that takes root to root. Rel boundary means: root both at the boundary half-edge that must correspond.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/topology/region.hpp"

namespace requad::mesh {

enum class Orientation { kept, mirrored };

// The rooted signature of root's component. Mirrored: the signature of the reflected mesh, in which the reflection of
// root's edge is the root. O(F), any genus, open or closed.
std::string signature(const QuadMesh& mesh, HalfEdgeId root, Orientation orientation = Orientation::kept);
inline std::string signature(const Region& region) { return signature(region.mesh, region.root); }

// The least rooted signature of a connected mesh: equal iff the meshes are isomorphic (by an orientation-preserving map,
// or, mirrored, to the reflected mesh). Roots are cut to the half-edges out of the vertices of one kind, the rarest of
// (boundary or interior, valence), the least such kind among equals; a root is left as soon as its text is greater than
// another's, and not tried if a symmetry that two equal texts have shown takes one to it that was. O(F) for each root at
// worst; O(F log F) in all where every root has the same text, as on a regular torus.
std::string canonical_signature(const QuadMesh& mesh, Orientation orientation = Orientation::kept);

// The mesh of a signature, rooted at half-edge 0. Throws MeshError if the text is no signature of a valid mesh. O(F log F).
Region from_signature(std::string_view text);

// The signatures of a region under the symmetries of its boundary: as read from every boundary half-edge from which the
// sides read the same as from the root (rotations), and mirrored ones from which they read the same clockwise
// (reflections). The least of a set names the orbit. O(F) for each symmetry.
std::vector<std::string> rotated_signatures(const Region& region);
std::vector<std::string> reflected_signatures(const Region& region);

}  // namespace requad::mesh
