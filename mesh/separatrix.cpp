#include "mesh/separatrix.hpp"

namespace requad::mesh {

bool is_irregular(const QuadMesh& m, VertexId v) { return !m.is_boundary(v) && m.face_valence(v) != 4; }

std::vector<VertexId> irregular_vertices(const QuadMesh& m) {
  std::vector<VertexId> found;
  for (const VertexId v : m.vertices()) {
    if (is_irregular(m, v)) found.push_back(v);
  }
  return found;
}

Separatrix trace(const QuadMesh& m, HalfEdgeId h) {
  Separatrix result;
  const HalfEdgeId start = h;
  for (;;) {
    result.path.push_back(h);
    const VertexId v = m.target(h);
    if (m.is_boundary(v)) {
      result.end = Separatrix::End::boundary;
      return result;
    }
    if (m.face_valence(v) != 4) {
      result.end = Separatrix::End::irregular;
      return result;
    }
    h = m.straight(h);
    if (h == start) {
      result.end = Separatrix::End::closed;
      return result;
    }
  }
}

}  // namespace requad::mesh
