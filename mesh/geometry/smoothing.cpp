#include "mesh/geometry/smoothing.hpp"

#include <limits>

namespace requad::mesh {

using Eigen::Vector3d;

namespace {

Vector3d mean_of_neighbours(const QuadMesh& m, const Positions& positions, VertexId v, SmoothingWeights weights) {
  const Vector3d& p = positions[v.slot()];
  Vector3d sum = Vector3d::Zero();
  double total = 0;
  bool coincides = false;
  m.for_each_out(v, [&](HalfEdgeId h) {
    const Vector3d& q = positions[m.target(h).slot()];
    double weight = 1;
    if (weights == SmoothingWeights::chord) {
      const double length = (q - p).norm();
      // The vertex is at a neighbour, whose weight is infinite: it stays.
      coincides = coincides || !(length > std::numeric_limits<double>::min());
      if (coincides) return;
      weight = 1 / length;
    }
    sum += weight * q;
    total += weight;
  });
  return coincides ? p : Vector3d(sum / total);
}

class Smoother {
 public:
  Smoother(const QuadMesh& mesh, Positions& positions, const SmoothingOptions& options)
      : mesh_(mesh), positions_(positions), options_(options) {}

  void move(VertexId v) {
    const Vector3d from = positions_[v.slot()];
    const Vector3d to_target = mean_of_neighbours(mesh_, positions_, v, options_.weights) - from;
    const auto quality = [this](HalfEdgeId h) { return scaled_jacobian(mesh_, positions_, QuadMesh::face(h)); };
    before_.clear();
    if (options_.guard) mesh_.for_each_out(v, [&](HalfEdgeId h) { before_.push_back(quality(h)); });

    constexpr int kHalvings = 3;
    double step = options_.step;
    for (int attempt = 0; attempt <= kHalvings; ++attempt, step /= 2) {
      positions_[v.slot()] = constrained(from + step * to_target);
      if (!options_.guard) return;
      bool good = true;
      std::size_t i = 0;
      mesh_.for_each_out(v, [&](HalfEdgeId h) {
        const double after = quality(h);
        good = good && (after > *options_.guard || after >= before_[i]);
        ++i;
      });
      if (good) return;
    }
    positions_[v.slot()] = from;
  }

 private:
  Vector3d constrained(Vector3d p) const {
    if (options_.pull_to) {
      const Vector3d anchor = options_.pull_to->nearest(p);
      const double distance = (p - anchor).norm();
      if (distance > options_.pull_distance) p = anchor + (p - anchor) * (options_.pull_distance / distance);
    }
    return options_.project_to ? options_.project_to->nearest(p).point : p;
  }

  const QuadMesh& mesh_;
  Positions& positions_;
  const SmoothingOptions& options_;
  std::vector<double> before_;
};

}  // namespace

void smooth(const QuadMesh& m, Positions& positions, std::span<const VertexId> vertices,
            const SmoothingOptions& options) {
  Smoother smoother(m, positions, options);
  for (int i = 0; i < options.iterations; ++i) {
    for (const VertexId v : vertices) {
      if (!m.is_boundary(v) && !(options.fixed && options.fixed(v))) smoother.move(v);
    }
  }
}

}  // namespace requad::mesh
