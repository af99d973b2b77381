#include "mesh/geometry/hausdorff_distance.hpp"

#include <algorithm>

#include "mesh/geometry/nearest_points.hpp"

namespace requad::mesh {

using Eigen::Vector3d;

double hausdorff_distance(SurfaceView a, SurfaceView b, int density) {
  const auto one_sided = [density](const SurfaceView& from, const SurfaceView& to) {
    const SurfaceIndex index(to.mesh, to.positions);
    double farthest = 0;
    for (const FaceId f : from.mesh.faces()) {
      for (const Triangle& t : triangles(from.mesh, from.positions, f)) {
        for (int i = 0; i <= density; ++i) {
          for (int j = 0; i + j <= density; ++j) {
            const Vector3d p = (i * t[0] + j * t[1] + (density - i - j) * t[2]) / density;
            farthest = std::max(farthest, index.nearest(p).distance);
          }
        }
      }
    }
    return farthest;
  };
  return std::max(one_sided(a, b), one_sided(b, a));
}

}  // namespace requad::mesh
