#include "mesh/geometry/hausdorff_distance.hpp"

#include <algorithm>

#include "mesh/geometry/nearest_points.hpp"

namespace requad::mesh {

double hausdorff_distance(SurfaceView a, SurfaceView b, int density) {
  const auto one_sided = [density](const SurfaceView& from, const SurfaceView& to) {
    const SurfaceIndex index(to.mesh, to.positions);
    double farthest = 0;
    for (const FaceId f : from.mesh.faces()) {
      for_each_sample(from.mesh, from.positions, f, density,
                      [&](const Eigen::Vector3d& p) { farthest = std::max(farthest, index.nearest(p).distance); });
    }
    return farthest;
  };
  return std::max(one_sided(a, b), one_sided(b, a));
}

}  // namespace requad::mesh
