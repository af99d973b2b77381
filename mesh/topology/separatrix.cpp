#include "mesh/topology/separatrix.hpp"

#include <array>

namespace requad::mesh {

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

// The half-edge that continues h straight; none if target(h) is not regular. Starting from h, going round target(h) by
// the faces on the left (west, north) and by those on the right (back, east, north) leads to the same half-edge iff
// that vertex is interior and has four edges.
inline HalfEdgeId continuation(const QuadMesh& m, HalfEdgeId h) {
  const HalfEdgeId from_west = m.twin(QuadMesh::next(h));
  const HalfEdgeId back = m.twin(h);
  if (!from_west.valid() || !back.valid()) return {};
  const HalfEdgeId north = QuadMesh::next(from_west);
  const HalfEdgeId east = m.twin(QuadMesh::previous(back));
  if (!east.valid() || north == back || m.twin(QuadMesh::previous(east)) != north) return {};
  return north;
}

}  // namespace

void trace_ends(const QuadMesh& m, std::span<SeparatrixEnd> paths, int most) {
  constexpr std::size_t kAbreast = 8;
  for (; paths.size() > kAbreast; paths = paths.subspan(kAbreast)) trace_ends(m, paths.first(kAbreast), most);
  // The first `count` entries are the paths that are not finished.
  std::array<SeparatrixEnd*, kAbreast> unfinished{};
  std::size_t count = 0;
  for (SeparatrixEnd& path : paths) {
    path.length = 1;
    unfinished[count++] = &path;
  }
  for (int length = 2; count > 0 && length <= most; ++length) {
    for (std::size_t i = 0; i < count;) {
      const HalfEdgeId next = continuation(m, unfinished[i]->last);
      if (next.valid()) {
        unfinished[i]->last = next;
        unfinished[i]->length = length;
        ++i;
      } else {
        unfinished[i] = unfinished[--count];
      }
    }
  }
  for (SeparatrixEnd& path : paths) {
    const VertexId v = m.target(path.last);
    path.end = m.is_boundary(v)         ? Separatrix::End::boundary
               : m.face_valence(v) == 4 ? Separatrix::End::closed
                                        : Separatrix::End::irregular;
  }
}

}  // namespace requad::mesh
