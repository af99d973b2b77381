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

}  // namespace requad::tests
