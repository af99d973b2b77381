// Signatures: printable strings by which meshes are compared up to isomorphism, and from which they can be rebuilt.
//
// A rooted signature describes a breadth-first traversal of the faces from one half-edge, the root. Faces are numbered
// in the order in which they are reached. The half-edges of a face are numbered counter-clockwise, from the one by
// which the face was entered. When an edge is reached for the first time, one number is written:
//   0       it is on the boundary
//   1       the face beyond it was not reached before
//   g + 1   its twin, in a face that was reached before, has a number that is greater by g >= 1
// The numbers are written in base 32, the lowest digit first, in an alphabet of 64 letters of which the upper half
// means that more digits follow.
//
// Laws
//   topology-11  Two meshes with roots have the same rooted signature iff an isomorphism that preserves the orientation
//                takes root to root. (So "rel boundary" is: take as roots two boundary half-edges that correspond.)
//   topology-12  from_signature() of a rooted signature gives an isomorphic mesh, with its root.
//   topology-13  Two connected meshes have the same canonical signature iff they are isomorphic.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/topology/region.hpp"

namespace requad::mesh {

enum class Orientation { kept, mirrored };

// The rooted signature of the component of the root, of any genus, with or without boundary. Mirrored: the signature of
// the reflected mesh, whose root is the reflection of the root's edge. O(F).
std::string signature(const QuadMesh& mesh, HalfEdgeId root, Orientation orientation = Orientation::kept);
inline std::string signature(const Region& region) { return signature(region.mesh, region.root); }

// The least rooted signature of a connected mesh, over certain roots; mirrored: of the reflected mesh. It is "" for a
// mesh without faces. The roots are the half-edges out of the vertices of one kind, which is (boundary or interior,
// valence): the rarest kind, and the least of those that are equally rare. A root is given up as soon as its text is
// greater than the least so far. Two equal texts reveal a symmetry, and roots that known symmetries map to an earlier
// root are skipped. At worst O(F) for each root. O(F log F) in all if every root has the same text, as on a regular
// torus.
std::string canonical_signature(const QuadMesh& mesh, Orientation orientation = Orientation::kept);

// The mesh of a rooted signature; its root is half-edge 0. Throws MeshError if the text is not the signature of a valid
// mesh. O(F log F).
Region from_signature(std::string_view text);

// The signatures of a region under the symmetries of its boundary: the rooted signatures from each boundary half-edge
// from which the turns read the same as from the root (rotations), and the mirrored ones from each from which they read
// the same clockwise (reflections). The least signature of a set names the orbit. O(F) for each symmetry.
std::vector<std::string> rotated_signatures(const Region& region);
std::vector<std::string> reflected_signatures(const Region& region);

}  // namespace requad::mesh
