// The bodies of the basic operations, to be inlined where they are called: a flip is some thirty instructions, so that a
// call would be a good part of it. Internal to basic_operations.hpp, which includes this file and has the contracts.
//
// What costs time is memory, so a query reads the faces that the operation touches anyway and as few others as it can:
// valences of 2 are seen from the two faces at the edge, and one walk both ways round a vertex (QuadMesh::joined) tells
// whether an edge is there already.
#pragma once

#include "mesh/topology/basic_operations.hpp"

namespace requad::mesh {

// The only code that writes to a mesh's arrays after it was built.
class MeshSurgery {
 public:
  explicit MeshSurgery(QuadMesh& mesh) : m_(mesh) {}

  void flip(HalfEdgeId h, Turn turn);
  void collapse(HalfEdgeId h);
  HalfEdgeId split(HalfEdgeId first, HalfEdgeId last, int corner);

 private:
  HalfEdgeId& twin(HalfEdgeId h) { return m_.sides_[h.slot()].twin; }
  VertexId& origin(HalfEdgeId h) { return m_.sides_[h.slot()].origin; }
  // `other` may be none; h is not.
  void glue(HalfEdgeId h, HalfEdgeId other) {
    twin(h) = other;
    if (other.valid()) twin(other) = h;
  }
  // v may have lost the half-edge it started from; `candidate` is one it has, the first of the fan if that is known.
  void restart(VertexId v, HalfEdgeId candidate) { m_.out_[v.slot()] = candidate; }
  FaceId new_face();
  VertexId new_vertex();

  QuadMesh& m_;
};

// Whether origin(h) is an interior vertex of valence 2, which can not lose an edge.
inline bool has_two_edges(const QuadMesh& m, HalfEdgeId h) {
  const HalfEdgeId left = m.ccw(h);
  return left.valid() && left == m.cw(h);
}

// --- flip ------------------------------------------------------------------------------------------------------------

inline Refusal why_not_flip(const QuadMesh& m, HalfEdgeId h, Turn turn) {
  if (!m.is_live(h)) return Refusal::dead_element;
  const HalfEdgeId t = m.twin(h);
  if (!t.valid()) return Refusal::boundary_edge;
  // Ends on the boundary keep a face: the edge is not on it, so each has two.
  if (has_two_edges(m, h) || has_two_edges(m, t)) return Refusal::valence_too_low;
  // The edge's ends move along the hexagon, to the origins of x and y.
  const bool ccw = turn == Turn::counter_clockwise;
  const HalfEdgeId x = ccw ? QuadMesh::opposite(t) : QuadMesh::previous(h);
  const HalfEdgeId y = ccw ? QuadMesh::opposite(h) : QuadMesh::previous(t);
  if (m.origin(x) == m.origin(y) || m.joined(x, m.origin(y))) return Refusal::edge_exists;
  return Refusal::none;
}

inline void MeshSurgery::flip(HalfEdgeId h, Turn turn) {
  const HalfEdgeId t = twin(h);
  const VertexId u = origin(h);
  const VertexId v = origin(t);
  // The edge takes the neighbouring slot of each face, and that slot's outer edge goes to the other face, into the slot
  // that the edge left: two outer twins change, not six.
  if (turn == Turn::counter_clockwise) {
    const HalfEdgeId h1 = QuadMesh::next(h);  // v -> p
    const HalfEdgeId t1 = QuadMesh::next(t);  // u -> r
    const HalfEdgeId outer_h1 = twin(h1);
    const HalfEdgeId outer_t1 = twin(t1);
    if (m_.out(v) == h1) restart(v, t);
    if (m_.out(u) == t1) restart(u, h);
    glue(h, outer_t1);
    glue(t, outer_h1);
    origin(h1) = origin(QuadMesh::next(t1));  // r
    origin(t1) = origin(QuadMesh::next(h1));  // p
    glue(h1, t1);
  } else {
    const HalfEdgeId h3 = QuadMesh::previous(h);  // q -> u
    const HalfEdgeId t3 = QuadMesh::previous(t);  // s -> v
    const VertexId q = origin(h3);
    const VertexId s = origin(t3);
    const HalfEdgeId outer_h3 = twin(h3);
    const HalfEdgeId outer_t3 = twin(t3);
    if (m_.out(u) == h) restart(u, QuadMesh::next(t));
    if (m_.out(v) == t) restart(v, QuadMesh::next(h));
    // A fan that started on the boundary starts there still, in the other face.
    if (!outer_h3.valid()) restart(q, t);
    if (!outer_t3.valid()) restart(s, h);
    glue(h, outer_t3);
    glue(t, outer_h3);
    origin(h) = s;
    origin(t) = q;
    glue(h3, t3);
  }
}

inline void flip_unchecked(QuadMesh& mesh, HalfEdgeId h, Turn turn) { MeshSurgery(mesh).flip(h, turn); }

inline Refusal flip(QuadMesh& mesh, HalfEdgeId h, Turn turn) {
  const Refusal refusal = why_not_flip(mesh, h, turn);
  if (refusal == Refusal::none) flip_unchecked(mesh, h, turn);
  return refusal;
}

// --- collapse --------------------------------------------------------------------------------------------------------

inline Refusal why_not_collapse(const QuadMesh& m, HalfEdgeId h) {
  if (!m.is_live(h)) return Refusal::dead_element;
  const HalfEdgeId h2 = QuadMesh::opposite(h);  // c -> d
  if (m.is_boundary(m.origin(h2))) return Refusal::boundary_corner;
  // The edges at c are not on the boundary, so b and d keep a face.
  if (has_two_edges(m, QuadMesh::next(h)) || has_two_edges(m, QuadMesh::previous(h))) return Refusal::valence_too_low;
  // No neighbour of c but b and d is a or a neighbour of a.
  const VertexId a = m.origin(h);
  for (HalfEdgeId x = m.ccw(m.ccw(h2)); x != h2; x = m.ccw(x)) {
    if (m.target(x) == a || m.joined(h, m.target(x))) return Refusal::edge_exists;
  }
  return Refusal::none;
}

inline void MeshSurgery::collapse(HalfEdgeId h) {
  const HalfEdgeId h1 = QuadMesh::next(h);
  const HalfEdgeId h2 = QuadMesh::opposite(h);
  const HalfEdgeId h3 = QuadMesh::previous(h);
  const VertexId a = origin(h);
  const VertexId b = origin(h1);
  const VertexId c = origin(h2);
  const VertexId d = origin(h3);
  const HalfEdgeId ab = twin(h);   // b -> a, or none
  const HalfEdgeId bc = twin(h1);  // c -> b
  const HalfEdgeId cd = twin(h2);  // d -> c
  const HalfEdgeId da = twin(h3);  // a -> d, or none

  for (HalfEdgeId x = bc; x != h2; x = m_.ccw(x)) origin(x) = a;
  // The edges a-b, c-b become one, of bc and ab; likewise a-d, c-d. Fans that started in the dead face start beside it.
  if (m_.out(a) == h) restart(a, bc);
  if (m_.out(b) == h1) restart(b, ab);
  if (m_.out(d) == h3) restart(d, cd);
  glue(bc, ab);
  glue(cd, da);

  const FaceId f = QuadMesh::face(h);
  for (int k = 0; k < 4; ++k) m_.sides_[QuadMesh::half_edge(f, k).slot()] = {};
  restart(c, HalfEdgeId());
  m_.free_faces_.push_back(f);
  m_.free_vertices_.push_back(c);
}

inline void collapse_unchecked(QuadMesh& mesh, HalfEdgeId h) { MeshSurgery(mesh).collapse(h); }

inline Refusal collapse(QuadMesh& mesh, HalfEdgeId h) {
  const Refusal refusal = why_not_collapse(mesh, h);
  if (refusal == Refusal::none) collapse_unchecked(mesh, h);
  return refusal;
}

// --- split -----------------------------------------------------------------------------------------------------------

inline Refusal why_not_split(const QuadMesh& m, HalfEdgeId first, HalfEdgeId last) {
  if (!m.is_live(first) || !m.is_live(last)) return Refusal::dead_element;
  if (m.target(last) != m.origin(first)) return Refusal::not_one_fan;
  if (m.twin(first) == last) return Refusal::same_edge;
  for (HalfEdgeId h = first; m.previous(h) != last;) {
    h = m.ccw(h);
    if (!h.valid() || h == first) return Refusal::not_one_fan;
  }
  return Refusal::none;
}

inline FaceId MeshSurgery::new_face() {
  if (!m_.free_faces_.empty()) {
    const FaceId f = m_.free_faces_.back();
    m_.free_faces_.pop_back();
    return f;
  }
  m_.sides_.resize(m_.sides_.size() + 4);
  return FaceId(m_.face_capacity() - 1);
}

inline VertexId MeshSurgery::new_vertex() {
  if (!m_.free_vertices_.empty()) {
    const VertexId v = m_.free_vertices_.back();
    m_.free_vertices_.pop_back();
    return v;
  }
  m_.out_.emplace_back();
  return VertexId(m_.vertex_capacity() - 1);
}

inline HalfEdgeId MeshSurgery::split(HalfEdgeId first, HalfEdgeId last, int corner) {
  const VertexId v = origin(first);
  const VertexId a = m_.target(first);
  const VertexId b = origin(last);
  const FaceId f = new_face();
  const VertexId w = new_vertex();
  const HalfEdgeId va = QuadMesh::half_edge(f, corner & 3);
  const HalfEdgeId aw = QuadMesh::next(va);
  const HalfEdgeId wb = QuadMesh::opposite(va);
  const HalfEdgeId bv = QuadMesh::previous(va);

  // The fan of v starts in the new face if it started in the sector: on the boundary only if the sector began there.
  const HalfEdgeId start = m_.out(v);
  for (HalfEdgeId h = first;; h = m_.ccw(h)) {
    origin(h) = w;
    if (h == start) restart(v, va);
    if (QuadMesh::previous(h) == last) break;
  }
  origin(va) = v;
  origin(aw) = a;
  origin(wb) = w;
  origin(bv) = b;
  const HalfEdgeId vb = twin(last);  // v -> b, or none
  glue(va, twin(first));
  glue(bv, vb);
  glue(first, aw);
  glue(last, wb);
  restart(w, first);
  if (!vb.valid()) restart(b, bv);  // b -> v on the boundary, the start of b's fan, is now in the new face
  return va;
}

inline HalfEdgeId split_unchecked(QuadMesh& mesh, HalfEdgeId first, HalfEdgeId last, int corner) {
  return MeshSurgery(mesh).split(first, last, corner);
}

inline SplitResult split(QuadMesh& mesh, HalfEdgeId first, HalfEdgeId last, int corner) {
  const Refusal refusal = why_not_split(mesh, first, last);
  if (refusal != Refusal::none) return {refusal, HalfEdgeId()};
  return {refusal, split_unchecked(mesh, first, last, corner)};
}

}  // namespace requad::mesh
