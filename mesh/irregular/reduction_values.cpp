#include "mesh/irregular/reduction_values.hpp"

#include <cmath>

#include "mesh/geometry/measures.hpp"

namespace requad::mesh {

ReductionValue& ReductionValue::operator+=(const ReductionValue& o) {
  curvature += o.curvature, quality += o.quality;
  inverted += o.inverted, irregular += o.irregular, inside += o.inside;
  return *this;
}

ReductionValue& ReductionValue::operator-=(const ReductionValue& o) {
  curvature -= o.curvature, quality -= o.quality;
  inverted -= o.inverted, irregular -= o.irregular, inside -= o.inside;
  return *this;
}

ReductionValue ReductionValues::value(VertexId v) const {
  const QuadMesh& m = editor_.mesh();
  const Positions& positions = *editor_.positions();
  ReductionValue result;
  result.irregular = editor_.sectors().is_irregular(v) ? 1 : 0;
  result.inside = editor_.is_fixed(v) ? 0 : result.irregular;
  m.for_each_out(v, [&](HalfEdgeId h) {
    const double quality = scaled_jacobian(m, positions, QuadMesh::face(h));
    result.inverted += is_inverted(quality) ? 1 : 0;
    result.quality += quality / 4;
  });
  if (curvature_) result.curvature = std::abs(mean_curvature(m, positions, v));
  return result;
}

void ReductionValues::remember(VertexId v) {
  if (v.slot() >= values_.size()) values_.resize(v.slot() + 1);
  const ReductionValue now = editor_.mesh().is_live(v) ? value(v) : ReductionValue{};
  ReductionValue difference = now;
  difference -= values_[v.slot()];
  sum_ += difference;
  values_[v.slot()] = now;
}

void ReductionValues::remember_all() {
  values_.assign(static_cast<std::size_t>(editor_.mesh().vertex_capacity()), {});
  sum_ = {};
  for (const VertexId v : editor_.mesh().vertices()) remember(v);
  faces_ = editor_.mesh().face_count();
}

void ReductionValues::remember(const AffectedRegion& region) {
  for (const VertexId v : region.removed) remember(v);
  for (const VertexId v : region.near) remember(v);
  faces_ = editor_.mesh().face_count();
}

double ReductionValues::mean_quality_after(const ReductionValue& change) const {
  return (sum_.quality + change.quality) / editor_.mesh().face_count();
}

ReductionValue ReductionValues::change(const AffectedRegion& region) const {
  ReductionValue sum;
  const auto subtract = [&](VertexId v) {
    // A vertex that was made has no value yet. Another one that had its id counts as removed.
    if (v.slot() < values_.size()) sum -= values_[v.slot()];
  };
  for (const VertexId v : region.near) {
    sum += value(v);
    subtract(v);
  }
  for (const VertexId v : region.removed) subtract(v);
  return sum;
}

}  // namespace requad::mesh
