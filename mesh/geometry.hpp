// Geometry of a quad mesh in space: measures of faces, edges and vertices, the nearest point of a surface, and how far
// two surfaces are apart.
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
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "mesh/quad_mesh.hpp"

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

// The nearest point of a surface's triangles, from a tree of their boxes. Building O(F log F); a query close to the
// surface about O(log F), a microsecond or two. Queries may run in parallel.
class SurfaceIndex {
 public:
  struct Nearest {
    Eigen::Vector3d point;
    double distance;
    FaceId face;
  };
  // Copies what it needs. Precondition: the mesh has a face.
  SurfaceIndex(const QuadMesh& mesh, const Positions& positions);
  ~SurfaceIndex();
  SurfaceIndex(SurfaceIndex&&) noexcept;
  SurfaceIndex& operator=(SurfaceIndex&&) noexcept;

  // Law: exact up to rounding. Of several nearest points, one; always the same.
  Nearest nearest(const Eigen::Vector3d& p) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

// The nearest of some points, likewise.
class PointIndex {
 public:
  // Precondition: there is a point.
  explicit PointIndex(std::span<const Eigen::Vector3d> points);
  ~PointIndex();
  PointIndex(PointIndex&&) noexcept;
  PointIndex& operator=(PointIndex&&) noexcept;

  Eigen::Vector3d nearest(const Eigen::Vector3d& p) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

// The nearest point of a triangle, which may be degenerate (C. Ericson, Real-Time Collision Detection, 2005, 5.1.5).
Eigen::Vector3d nearest_on_triangle(const Triangle& triangle, const Eigen::Vector3d& p);

// The largest distance of a point of either surface to the other, over samples: each triangle's points with barycentric
// coordinates in multiples of 1 / density, so its corners, density - 1 points of each side and some inside.
// Law: the exact distance lies between the result and the result + (longest side of a triangle) / (sqrt(3) * density),
// since distance is 1-Lipschitz and no point of a triangle is farther from a corner of its cell.
// O(F density^2) queries. Precondition: both have a face; density >= 1.
struct Sampled {
  const QuadMesh& mesh;
  const Positions& positions;
};
double hausdorff_distance(Sampled a, Sampled b, int density = 4);

}  // namespace requad::mesh
