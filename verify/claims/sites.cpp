#include "verify/claims/sites.hpp"

#include <algorithm>

#include "mesh/topology/separatrix.hpp"

namespace requad::verify {

using mesh::BasicOperation;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;

Performed performed(const QuadMesh& m, const BasicOperation& op) {
  Performed r{op, m, {}, {}};
  mesh::apply(r.mesh, op);
  r.irregular = mesh::irregular_vertices(r.mesh);
  r.valences = mesh::sorted_irregular_valences(r.mesh);
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
