#include "mesh/geometry/hausdorff_distance.hpp"

#include <algorithm>

namespace requad::mesh {

double NearSurface::distance(const Eigen::Vector3d& p) {
  const SurfaceIndex::Nearest nearest = surface_.nearest(p, last_);
  last_ = nearest.point;
  return nearest.distance;
}

bool NearSurface::is_within(double bound, const Eigen::Vector3d& p) {
  return (last_ - p).norm() <= bound || distance(p) <= bound;
}

double hausdorff_distance(SurfaceView a, SurfaceView b, int density) {
  const auto one_sided = [density](const SurfaceView& from, const SurfaceView& to) {
    const SurfaceIndex index(to.mesh, to.positions);
    NearSurface near(index);
    double farthest = 0;
    for (const FaceId f : from.mesh.faces()) {
      for_each_sample(from.mesh, from.positions, f, density,
                      [&](const Eigen::Vector3d& p) { farthest = std::max(farthest, near.distance(p)); });
    }
    return farthest;
  };
  return std::max(one_sided(a, b), one_sided(b, a));
}

bool is_within(SurfaceView view, const SurfaceIndex& surface, double bound, int density) {
  NearSurface near(surface);
  const std::vector<FaceId> faces = view.mesh.faces();
  return std::all_of(faces.begin(), faces.end(), [&](FaceId f) {
    bool all = true;
    for_each_sample(view.mesh, view.positions, f, density,
                    [&](const Eigen::Vector3d& p) { all = all && near.is_within(bound, p); });
    return all;
  });
}

}  // namespace requad::mesh
