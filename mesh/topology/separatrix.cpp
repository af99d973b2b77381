#include "mesh/topology/separatrix.hpp"

#include <array>

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

namespace {

// The half-edge straight on from h, if there is one. The two ways there, by the left, h, west, north, and by the right,
// back, east, north, are the same iff the end of h is interior and has four edges.
inline HalfEdgeId straight_on(const QuadMesh& m, HalfEdgeId h) {
  const HalfEdgeId from_west = m.twin(QuadMesh::next(h));
  const HalfEdgeId back = m.twin(h);
  if (!from_west.valid() || !back.valid()) return {};
  const HalfEdgeId north = QuadMesh::next(from_west);
  const HalfEdgeId east = m.twin(QuadMesh::previous(back));
  if (!east.valid() || north == back || m.twin(QuadMesh::previous(east)) != north) return {};
  return north;
}

}  // namespace

void follow(const QuadMesh& m, std::span<Arrival> paths, int most) {
  constexpr std::size_t kAbreast = 8;
  for (; paths.size() > kAbreast; paths = paths.subspan(kAbreast)) follow(m, paths.first(kAbreast), most);
  // Those that go on, in front.
  std::array<Arrival*, kAbreast> walking{};
  std::size_t count = 0;
  for (Arrival& path : paths) {
    path.length = 1;
    walking[count++] = &path;
  }
  for (int length = 2; count > 0 && length <= most; ++length) {
    for (std::size_t i = 0; i < count;) {
      const HalfEdgeId on = straight_on(m, walking[i]->last);
      if (on.valid()) {
        walking[i]->last = on;
        walking[i]->length = length;
        ++i;
      } else {
        walking[i] = walking[--count];
      }
    }
  }
  for (Arrival& path : paths) {
    const VertexId v = m.target(path.last);
    path.end = m.is_boundary(v)         ? Separatrix::End::boundary
               : m.face_valence(v) == 4 ? Separatrix::End::closed
                                        : Separatrix::End::irregular;
  }
}

}  // namespace requad::mesh
