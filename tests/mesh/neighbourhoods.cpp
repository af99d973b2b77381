#include "tests/mesh/neighbourhoods.hpp"

#include <algorithm>

#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "tests/support/mesh/regions.hpp"

namespace requad::tests {

using namespace requad::mesh;

Region neighbourhood(int valence) { return star(std::vector<int>(static_cast<std::size_t>(valence), 4)); }

Region pair_neighbourhood() { return pair_region({3, 5, 1, 0}, {4, 4, 4, 4}); }

VertexId vertex_of(const QuadMesh& m, int valence) {
  for (const VertexId v : irregular_vertices(m)) {
    if (m.valence(v) == valence) return v;
  }
  for (const VertexId v : m.vertices()) {
    bool inside = valence == 4 && !m.is_boundary(v);
    for (const VertexId w : m.neighbours(v)) {
      for (const VertexId x : m.neighbours(w)) inside = inside && !m.is_boundary(x);
    }
    if (inside) return v;
  }
  return {};
}

std::string rel_boundary(const QuadMesh& m, const Region& region) {
  return signature(m, m.out(region.mesh.origin(region.root)));
}

std::vector<BasicOperation> exhausted(const QuadMesh& m) {
  using Kind = BasicOperation::Kind;
  std::vector<BasicOperation> all;
  const auto add = [&](const BasicOperation& op) {
    if (why_not(m, op) != Refusal::none) return;
    const auto changed = changed_vertices(m, op);
    if (std::none_of(changed.begin(), changed.end(), [&](VertexId x) { return x.valid() && m.is_boundary(x); }))
      all.push_back(op);
  };
  for (const HalfEdgeId h : m.half_edges()) {
    if (h < m.twin(h)) add({Kind::flip_ccw, h, {}, 0}), add({Kind::flip_cw, h, {}, 0});
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
  return all;
}

std::multiset<int> sorted_valences(const QuadMesh& m) {
  std::multiset<int> valences;
  for (const VertexId v : irregular_vertices(m)) valences.insert(m.valence(v));
  return valences;
}

}  // namespace requad::tests
