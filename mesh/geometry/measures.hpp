// Measures of the faces, edges and vertices of a quad mesh in space.
//
// Terms, for everything in this room
//   positions     One position for each vertex slot. Those of deleted vertices mean nothing.
//   area vector   Of a quad a b c d: (c - a) x (d - b) / 2, the integral of the normal over any surface that the quad
//                 bounds. Its direction is the mean normal of the face. Its length is the area of the face projected
//                 along that normal; if the quad is plane, its area.
//   triangles     The two triangles into which the shorter diagonal cuts a face; or the other diagonal, if only that
//                 one lies inside the quad. "The surface" is the union of these triangles.
//   inverted      A face with a corner that is flat, folded or reflex as seen along the normal: scaled_jacobian() <= 0.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include <Eigen/Core>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

using Positions = std::vector<Eigen::Vector3d>;
using Triangle = std::array<Eigen::Vector3d, 3>;

// Coordinates are at most this large, so that products of four lengths are finite.
constexpr double kLargestCoordinate = 1e70;

// The bits of a number. (Like std::bit_cast, which the library of Emscripten 3.1.6 lacks.)
inline std::uint64_t bits_of(double x) {
  std::uint64_t bits = 0;
  static_assert(sizeof bits == sizeof x);
  std::memcpy(&bits, &x, sizeof x);
  return bits;
}
// Whether two positions are the same to the last bit. (A file distinguishes 0 and -0, which are equal.)
inline bool same_bits(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return bits_of(x) == bits_of(y); });
}

// The unit vector along v; zero if v is zero or not finite.
Eigen::Vector3d unit_or_zero(const Eigen::Vector3d& v);

// Measures. O(1), but O(valence) for a vertex. Precondition: the element is live.

Eigen::Vector3d area_vector(const QuadMesh& mesh, const Positions& positions, FaceId f);
double area(const QuadMesh& mesh, const Positions& positions, FaceId f);
// The unit vector along the area vector; zero if that is zero.
Eigen::Vector3d face_normal(const QuadMesh& mesh, const Positions& positions, FaceId f);
Eigen::Vector3d face_centre(const QuadMesh& mesh, const Positions& positions, FaceId f);
std::array<Triangle, 2> triangles(const QuadMesh& mesh, const Positions& positions, FaceId f);
// The same with the corners of the face, 0..3, that each triangle has.
struct FaceTriangles {
  std::array<Triangle, 2> triangles;
  std::array<std::array<int, 3>, 2> corners;
};
FaceTriangles triangles_of(const QuadMesh& mesh, const Positions& positions, FaceId f);

// The least sine of the angle at a corner, as seen along the normal: 1 for rectangles, 0 or less for inverted faces,
// and 0 if a side or the area is zero. In -1..1.
double scaled_jacobian(const QuadMesh& mesh, const Positions& positions, FaceId f);
inline bool is_inverted(double scaled_jacobian) { return scaled_jacobian <= 0; }
inline bool is_inverted(const QuadMesh& mesh, const Positions& positions, FaceId f) {
  return is_inverted(scaled_jacobian(mesh, positions, f));
}
// How many faces are inverted. O(F).
int count_inverted(const QuadMesh& mesh, const Positions& positions);
// Longest side * perimeter / (4 * area): 1 for squares, infinite if the area is zero (C. J. Stimpson et al., The
// Verdict Library Reference Manual, 2007, "quadrilateral aspect ratio").
double aspect_ratio(const QuadMesh& mesh, const Positions& positions, FaceId f);

double edge_length(const QuadMesh& mesh, const Positions& positions, HalfEdgeId h);
// The angle between the normals of the two faces, in radians: positive at a ridge, negative in a valley, 0 on the
// boundary or if a face has no normal. In -pi..pi.
double dihedral_angle(const QuadMesh& mesh, const Positions& positions, HalfEdgeId h);
// The mean curvature, integrated over those halves of the edges that are nearer v: the sum of length * dihedral angle /
// 4. It is a length, so it scales with the mesh. (D. Cohen-Steiner, J.-M. Morvan, Restricted Delaunay triangulations
// and normal cycle, SoCG 2003, where a whole edge contributes length * angle / 2.)
double mean_curvature(const QuadMesh& mesh, const Positions& positions, VertexId v);

// The diagonal of the bounding box of the live vertices; 0 if there are none. O(V).
double bounding_box_diagonal(const QuadMesh& mesh, const Positions& positions);

}  // namespace requad::mesh
