// How far two surfaces are apart.
#pragma once

#include <limits>

#include <Eigen/Core>

#include "mesh/geometry/measures.hpp"
#include "mesh/geometry/nearest_points.hpp"
#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

// A mesh with its positions, by vertex slot, neither of which is copied.
struct SurfaceView {
  const QuadMesh& mesh;
  const Positions& positions;
};

constexpr int kUsualDensity = 4;

// Calls visit(point) for each sample of a face: the points of its triangles with barycentric coordinates in multiples of
// 1 / density, which are their corners, density - 1 points of each side, and some points inside.
template <class Visit>
void for_each_sample(const QuadMesh& mesh, const Positions& positions, FaceId f, int density, Visit&& visit) {
  for (const Triangle& t : triangles(mesh, positions, f)) {
    for (int i = 0; i <= density; ++i) {
      for (int j = 0; i + j <= density; ++j)
        visit(Eigen::Vector3d((i * t[0] + j * t[1] + (density - i - j) * t[2]) / density));
    }
  }
}

// An estimate from below of the Hausdorff distance: the largest distance of a point of either surface from the other,
// over the samples of all faces.
//
// Law geometry-2. The exact distance lies between the result and the result + (longest side of a triangle) /
//                 (sqrt(3) * density), because distance is 1-Lipschitz and each point of a triangle is as close as that
//                 to a sample.
// O(F density^2) queries of a SurfaceIndex. Preconditions: both meshes have a face; density >= 1.
double hausdorff_distance(SurfaceView a, SurfaceView b, int density = kUsualDensity);

// Follows points that are near one another and knows a point of a surface near the last one. So it answers most questions
// without a query.
class NearSurface {
 public:
  // The index must outlive it.
  explicit NearSurface(const SurfaceIndex& surface) : surface_(surface) {}

  double distance(const Eigen::Vector3d& p);
  // Whether the distance of p is at most the bound.
  bool is_within(double bound, const Eigen::Vector3d& p);

 private:
  const SurfaceIndex& surface_;
  Eigen::Vector3d last_ = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
};

// Whether all samples of the mesh are within the bound of the surface.
bool is_within(SurfaceView mesh, const SurfaceIndex& surface, double bound, int density = kUsualDensity);

}  // namespace requad::mesh
