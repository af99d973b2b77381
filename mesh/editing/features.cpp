#include "mesh/editing/features.hpp"

#include <algorithm>

namespace requad::mesh {

std::uint64_t FeatureSet::key(VertexId a, VertexId b) {
  const auto [low, high] = std::minmax({a.index(), b.index()});
  return (static_cast<std::uint64_t>(low) << 32U) | static_cast<std::uint32_t>(high);
}

void FeatureSet::insert(VertexId a, VertexId b) {
  if (!edges_.insert(key(a, b)).second) return;
  degree_.resize(std::max({degree_.size(), a.slot() + 1, b.slot() + 1}));
  ++degree_[a.slot()];
  ++degree_[b.slot()];
}

std::vector<std::array<VertexId, 2>> FeatureSet::edges() const {
  std::vector<std::uint64_t> keys(edges_.begin(), edges_.end());
  std::sort(keys.begin(), keys.end());
  std::vector<std::array<VertexId, 2>> result;
  result.reserve(keys.size());
  for (const std::uint64_t k : keys) {
    result.push_back(
        {VertexId(static_cast<std::int32_t>(k >> 32U)), VertexId(static_cast<std::int32_t>(k & 0xffffffffU))});
  }
  return result;
}

Refusal FeatureSet::why_not(const QuadMesh& mesh, const BasicOperation& op) const {
  if (empty()) return Refusal::none;
  const VertexId v = mesh.origin(op.h);
  bool breaks = false;
  switch (op.kind) {
    case BasicOperation::Kind::flip_ccw:
    case BasicOperation::Kind::flip_cw: breaks = is_edge(v, mesh.target(op.h)); break;
    case BasicOperation::Kind::collapse: breaks = is_vertex(mesh.origin(QuadMesh::opposite(op.h))); break;
    case BasicOperation::Kind::split:
      if (!is_vertex(v)) break;
      for (HalfEdgeId h = op.h; QuadMesh::previous(h) != op.last;) {
        h = mesh.ccw(h);
        breaks = breaks || is_edge(v, mesh.target(h));
      }
      break;
  }
  return breaks ? FeatureRefusal::breaks_feature : Refusal::none;
}

}  // namespace requad::mesh
