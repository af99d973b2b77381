// Measures of the faces, edges and vertices of a quad mesh in space.
//
// Terms
//   positions     one for each vertex slot; those of deleted vertices mean nothing.
//   area vector   of a quad a b c d: (c - a) x (d - b) / 2, the integral of the normal over any surface that the quad
//                 bounds. Its direction is the face's mean normal, its length the area of the quad's shadow along that
//                 normal (the area, if the quad is plane).
//   triangles     of a face: the two sides of a diagonal, the shorter one of those that lie inside the quad. They are
//                 what "the surface" means.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

using Positions = std::vector<Eigen::Vector3d>;
using Triangle = std::array<Eigen::Vector3d, 3>;

// Whether two positions are the same to the last bit. (0 == -0, but a file tells them apart.)
inline bool same_bits(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

// Measures. Each is O(1), those of a vertex O(valence). Preconditions: the element is live, positions are by slot.

Eigen::Vector3d area_vector(const QuadMesh& mesh, const Positions& positions, FaceId f);
double area(const QuadMesh& mesh, const Positions& positions, FaceId f);
// Unit, or zero where the area vector is.
Eigen::Vector3d face_normal(const QuadMesh& mesh, const Positions& positions, FaceId f);
Eigen::Vector3d face_centre(const QuadMesh& mesh, const Positions& positions, FaceId f);
std::array<Triangle, 2> triangles(const QuadMesh& mesh, const Positions& positions, FaceId f);

// The least sine of a corner's angle, seen along the face's normal: 1 for rectangles, 0 or less if a corner is flat,
// folded or reflex: such a face is inverted. 0 if a side or the area is zero. In -1..1.
double scaled_jacobian(const QuadMesh& mesh, const Positions& positions, FaceId f);
inline bool is_inverted(double scaled_jacobian) { return scaled_jacobian <= 0; }
// Longest side times perimeter / (4 area): 1 for squares, infinite if the area is zero (C. J. Stimpson et al., The
// Verdict Library Reference Manual, 2007, "quadrilateral aspect ratio").
double aspect_ratio(const QuadMesh& mesh, const Positions& positions, FaceId f);

double edge_length(const QuadMesh& mesh, const Positions& positions, HalfEdgeId h);
// The angle between the normals on either side, in radians: positive over a ridge, negative in a valley, 0 on the
// boundary or beside a face without a normal. In -pi..pi.
double dihedral_angle(const QuadMesh& mesh, const Positions& positions, HalfEdgeId h);
// Mean curvature integrated over the half of each edge that is nearer v: the sum of length * dihedral angle / 4
// (D. Cohen-Steiner, J.-M. Morvan, Restricted Delaunay triangulations and normal cycle, SoCG 2003, where an edge
// contributes half of length * angle). A length: it scales with the mesh.
double mean_curvature(const QuadMesh& mesh, const Positions& positions, VertexId v);

// Of the live vertices; 0 if there are none. O(V).
double bounding_box_diagonal(const QuadMesh& mesh, const Positions& positions);

}  // namespace requad::mesh
