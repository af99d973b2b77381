#include "verify/claims/sites.hpp"

#include <algorithm>

#include "mesh/topology/separatrix.hpp"

namespace requad::verify {

using mesh::BasicOperation;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Refusal;
using mesh::Region;
using mesh::VertexId;
using Kind = mesh::BasicOperation::Kind;

std::vector<BasicOperation> all_operations(const QuadMesh& m) {
  std::vector<BasicOperation> operations;
  const auto add = [&](const BasicOperation& op) {
    if (mesh::why_not(m, op) != Refusal::none) return;
    for (const VertexId v : mesh::changed_vertices(m, op)) {
      if (v.valid() && m.is_boundary(v)) return;
    }
    operations.push_back(op);
  };
  for (const HalfEdgeId h : m.half_edges()) {
    if (h < m.twin(h)) {
      add({Kind::flip_ccw, h, {}, 0});
      add({Kind::flip_cw, h, {}, 0});
    }
    if (h.index() % 4 < 2) add({Kind::collapse, h, {}, 0});
  }
  for (const VertexId v : m.vertices()) {
    if (m.is_boundary(v)) continue;
    std::vector<HalfEdgeId> out;
    m.for_each_out(v, [&out](HalfEdgeId h) { out.push_back(h); });
    for (std::size_t i = 0; i < out.size(); ++i) {
      for (std::size_t k = i + 1; k < out.size(); ++k) add({Kind::split, out[i], m.twin(out[k]), 0});
    }
  }
  return operations;
}

Performed performed(const QuadMesh& m, const BasicOperation& op) {
  Performed r{op, m, {}, {}};
  mesh::apply(r.mesh, op);
  r.irregular = mesh::irregular_vertices(r.mesh);
  for (const VertexId v : r.irregular) r.valences.insert(r.mesh.valence(v));
  return r;
}

namespace {

// Whether no vertex on the faces of v, or on their neighbours' faces, lies on the boundary.
bool is_deep(const QuadMesh& m, VertexId v) {
  std::set<VertexId> reached{v};
  for (int ring = 0; ring < 2; ++ring) {
    std::set<VertexId> wider = reached;
    for (const VertexId w : reached) {
      if (m.is_boundary(w)) continue;
      m.for_each_out(w, [&](HalfEdgeId h) {
        for (const VertexId x : m.corners(QuadMesh::face(h))) wider.insert(x);
      });
    }
    reached = std::move(wider);
  }
  return std::none_of(reached.begin(), reached.end(), [&](VertexId w) { return m.is_boundary(w); });
}

}  // namespace

const Region* neighbourhood(const VertexStudy& s) {
  for (const Region& region : s.glued) {
    const auto irregular = mesh::irregular_vertices(region.mesh);
    if (irregular.size() > 1) continue;
    if (irregular.empty() || is_deep(region.mesh, irregular[0])) return &region;
  }
  return nullptr;
}

VertexId deep_vertex(const Region& region) {
  for (const VertexId v : region.mesh.vertices()) {
    if (is_deep(region.mesh, v)) return v;
  }
  return {};
}

}  // namespace requad::verify
