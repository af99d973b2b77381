// Nearest points: on a surface, and among some points.
#pragma once

#include <memory>
#include <span>

#include <Eigen/Core>

#include "mesh/geometry/measures.hpp"

namespace requad::mesh {

// Finds nearest points on a surface, which consists of the triangles() of its faces, by a tree of their bounding boxes.
// Building takes O(F log F). A query near the surface takes about O(log F), a microsecond or two. Threads may query at
// the same time.
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

  // Law geometry-1. The result is exact up to rounding. If several points are nearest, it is always the same one of
  // them.
  Nearest nearest(const Eigen::Vector3d& p) const;
  // The same, sooner if the guess is on the surface and not much farther from p than the nearest point.
  Nearest nearest(const Eigen::Vector3d& p, const Eigen::Vector3d& guess) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

// The same for the nearest of some points.
class PointIndex {
 public:
  // Copies the points. Precondition: there is at least one.
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

}  // namespace requad::mesh
