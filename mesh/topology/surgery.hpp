// How the basic operations change a mesh's arrays. This is the only code that writes to them after a mesh was built.
//
// Legality is decided above, in basic_operations.hpp, which also has the pictures and the laws; use its functions.
// Every function here requires that the operation is legal. The bodies stand in this header because a flip is about
// thirty instructions, of which a call would be a good part.
#pragma once

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

class MeshSurgery {
 public:
  explicit MeshSurgery(QuadMesh& mesh) : m_(mesh) {}

  void flip_counter_clockwise(HalfEdgeId h);
  void flip_clockwise(HalfEdgeId h);
  void collapse(HalfEdgeId h);
  // Returns v -> a in the new face.
  HalfEdgeId split(HalfEdgeId first, HalfEdgeId last, int corner);
  // Lets the fan of v start at `first`, a half-edge out of v, which invariant topology-3 allows.
  void restart(VertexId v, HalfEdgeId first) { m_.out_[v.slot()] = first; }

 private:
  HalfEdgeId& twin(HalfEdgeId h) { return m_.sides_[h.slot()].twin; }
  VertexId& origin(HalfEdgeId h) { return m_.sides_[h.slot()].origin; }
  // Makes h and `other` twins; if there is no other, h becomes a boundary half-edge.
  void glue(HalfEdgeId h, HalfEdgeId other) {
    twin(h) = other;
    if (other.valid()) twin(other) = h;
  }
  FaceId new_face();
  VertexId new_vertex();

  QuadMesh& m_;
};

// A flipped edge takes the neighbouring slot of each of its faces. The outer edge of that slot goes to the other face,
// into the slot that the edge left: so two outer twins change, not six.
inline void MeshSurgery::flip_counter_clockwise(HalfEdgeId h) {
  const HalfEdgeId t = twin(h);
  const VertexId u = origin(h);
  const VertexId v = origin(t);
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
}

inline void MeshSurgery::flip_clockwise(HalfEdgeId h) {
  const HalfEdgeId t = twin(h);
  const VertexId u = origin(h);
  const VertexId v = origin(t);
  const HalfEdgeId h3 = QuadMesh::previous(h);  // q -> u
  const HalfEdgeId t3 = QuadMesh::previous(t);  // s -> v
  const VertexId q = origin(h3);
  const VertexId s = origin(t3);
  const HalfEdgeId outer_h3 = twin(h3);
  const HalfEdgeId outer_t3 = twin(t3);
  if (m_.out(u) == h) restart(u, QuadMesh::next(t));
  if (m_.out(v) == t) restart(v, QuadMesh::next(h));
  // A fan that started on the boundary still starts there, in the other face.
  if (!outer_h3.valid()) restart(q, t);
  if (!outer_t3.valid()) restart(s, h);
  glue(h, outer_t3);
  glue(t, outer_h3);
  origin(h) = s;
  origin(t) = q;
  glue(h3, t3);
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
  // The edges a-b and c-b become one edge with the half-edges bc and ab; likewise a-d and c-d.
  // A fan that started in the dead face now starts beside it.
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

  // If the fan of v started in the sector, it now starts in the new face. (On the boundary that happens only if the
  // sector began there.)
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
  if (!vb.valid()) restart(b, bv);  // b -> v is on the boundary, where the fan of b starts, and now in the new face
  return va;
}

}  // namespace requad::mesh
