// The nearest point of a surface or of some points, and how far two surfaces are apart.
#pragma once

#include <memory>
#include <span>

#include <Eigen/Core>

#include "mesh/geometry/measures.hpp"

namespace requad::mesh {

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
