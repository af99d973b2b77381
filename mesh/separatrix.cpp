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

// A step looks at the two faces beside the edge and the two beyond its end: the way on by the left, h, west, north, and
// by the right, back, east, north, is the same iff the end is interior and has four edges.
Arrival follow(const QuadMesh& m, HalfEdgeId h, int most) {
  int length = 1;
  for (; length < most; ++length) {
    const HalfEdgeId back = m.twin(h);
    const HalfEdgeId from_west = m.twin(QuadMesh::next(h));
    if (!back.valid() || !from_west.valid()) break;
    const HalfEdgeId north = QuadMesh::next(from_west);
    const HalfEdgeId east = m.twin(QuadMesh::previous(back));
    if (!east.valid() || north == back || m.twin(QuadMesh::previous(east)) != north) break;
    h = north;
  }
  const VertexId v = m.target(h);
  if (m.is_boundary(v)) return {h, length, Separatrix::End::boundary};
  return {h, length, m.face_valence(v) == 4 ? Separatrix::End::closed : Separatrix::End::irregular};
}

}  // namespace requad::mesh
