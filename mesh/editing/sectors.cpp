#include "mesh/editing/sectors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

namespace requad::mesh {

std::uint64_t SectorPlan::key(VertexId v, VertexId first) {
  return (static_cast<std::uint64_t>(v.index()) << 32U) | static_cast<std::uint32_t>(first.index());
}

void SectorPlan::set(VertexId v, VertexId first, int size) { sizes_[key(v, first)] = size; }

std::optional<int> SectorPlan::get(VertexId v, VertexId first) const {
  const auto found = sizes_.find(key(v, first));
  return found == sizes_.end() ? std::nullopt : std::optional(found->second);
}

bool Sectors::is_cut(HalfEdgeId h) const {
  return mesh_.is_boundary(h) || (features_ != nullptr && features_->is_edge(mesh_.origin(h), mesh_.target(h)));
}

HalfEdgeId Sectors::start(HalfEdgeId h) const {
  if (!is_fixed(mesh_.origin(h))) return h;
  while (!is_cut(h)) h = mesh_.cw(h);
  return h;
}

int Sectors::size(HalfEdgeId h) const {
  const VertexId v = mesh_.origin(h);
  if (!is_fixed(v)) return mesh_.face_valence(v);
  int faces = 0;
  h = start(h);
  do {
    ++faces;
    h = mesh_.ccw(h);
  } while (h.valid() && !is_cut(h));
  return faces;
}

int Sectors::excess(HalfEdgeId h) const {
  const VertexId v = mesh_.origin(h);
  if (!is_fixed(v)) return mesh_.face_valence(v) - 4;
  if (plan_ == nullptr) return 0;
  const std::optional<int> intended = plan_->get(v, mesh_.target(start(h)));
  return intended ? size(h) - *intended : 0;
}

bool Sectors::is_minimal() const {
  enum : unsigned { kLacks = 1, kExceeds = 2, kSeen = 4 };
  std::vector<unsigned> marks(static_cast<std::size_t>(mesh_.face_capacity()), 0);
  std::vector<FaceId> patch;
  for (const FaceId first : mesh_.faces()) {
    if (marks[first.slot()] != 0) continue;
    unsigned found = 0;
    patch.assign(1, first);
    marks[first.slot()] = kSeen;
    while (!patch.empty()) {
      const FaceId f = patch.back();
      patch.pop_back();
      for (int corner = 0; corner < 4; ++corner) {
        const HalfEdgeId h = QuadMesh::half_edge(f, corner);
        const int e = excess(h);
        found |= e < 0 ? kLacks : e > 0 ? kExceeds : 0U;
        if (is_cut(h)) continue;
        const FaceId beyond = QuadMesh::face(mesh_.twin(h));
        if (marks[beyond.slot()] != 0) continue;
        marks[beyond.slot()] = kSeen;
        patch.push_back(beyond);
      }
    }
    if (found == (kLacks | kExceeds)) return false;
  }
  return true;
}

SectorPlan plan_by_angles(const QuadMesh& m, const FeatureSet& features, const Positions& positions,
                          BoundaryPlan boundary) {
  const Sectors sectors(m, &features);
  SectorPlan plan;
  for (const VertexId v : m.vertices()) {
    if (!sectors.is_fixed(v) || (m.is_boundary(v) && boundary == BoundaryPlan::free)) continue;
    sectors.for_each_sector(v, [&](HalfEdgeId first) {
      if (m.is_boundary(v) && boundary == BoundaryPlan::fixed) return plan.set(v, m.target(first), sectors.size(first));
      double angle = 0;
      HalfEdgeId h = first;
      do {
        const Eigen::Vector3d& at = positions[v.slot()];
        const Eigen::Vector3d along = positions[m.target(h).slot()] - at;
        const Eigen::Vector3d back = positions[m.origin(QuadMesh::previous(h)).slot()] - at;
        angle += std::atan2(along.cross(back).norm(), along.dot(back));
        h = m.ccw(h);
      } while (h.valid() && !sectors.is_cut(h));
      plan.set(v, m.target(first), std::max(1, static_cast<int>(std::lround(angle / (std::numbers::pi / 2)))));
    });
  }
  return plan;
}

}  // namespace requad::mesh
