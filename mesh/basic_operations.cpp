#include "mesh/basic_operations.hpp"

#include <cassert>

namespace requad::mesh {

// The only code that writes to a mesh's arrays after it was built.
class MeshSurgery {
 public:
  explicit MeshSurgery(QuadMesh& mesh) : m_(mesh) {}

  void flip(HalfEdgeId h, Turn turn);
  void collapse(HalfEdgeId h);
  HalfEdgeId split(HalfEdgeId first, HalfEdgeId last, int corner);

 private:
  void glue(HalfEdgeId a, HalfEdgeId b) {
    if (a.valid()) m_.twin_[a.slot()] = b;
    if (b.valid()) m_.twin_[b.slot()] = a;
  }
  // v may have lost the half-edge it started from; `candidate` is one it has, the first of the fan if that is known.
  void restart(VertexId v, HalfEdgeId candidate) { m_.out_[v.slot()] = candidate; }
  FaceId new_face();
  VertexId new_vertex();

  QuadMesh& m_;
};

std::string_view explain(Refusal refusal) {
  switch (refusal) {
    case Refusal::none: return "legal";
    case Refusal::dead_element: return "no such element";
    case Refusal::boundary_edge: return "a boundary edge can not be flipped";
    case Refusal::valence_too_low: return "a vertex would be left with too few edges";
    case Refusal::edge_exists: return "two edges would join the same vertices";
    case Refusal::boundary_corner: return "the vertex to remove lies on the boundary";
    case Refusal::same_edge: return "both edges of the path are the same";
    case Refusal::not_one_fan: return "the two edges do not bound a sector of one vertex";
    case Refusal::touches_boundary: return "a boundary vertex would change its valence";
    case Refusal::no_such_step: return "the pair has no configuration in this direction";
    case Refusal::irregular_in_the_way: return "another irregular vertex is in the way";
    case Refusal::breaks_feature: return "a feature edge would go";
    case Refusal::moves_feature: return "a vertex on a feature would move";
    case Refusal::no_way: return "no path leads the 3-5 pair to a vertex that can take it";
    case Refusal::wrong_valences: return "the vertices do not have the valences that this needs";
    case Refusal::no_rectangle: return "the separatrices of the two span no rectangle (Lemma 7.8), which this needs";
    case Refusal::odd_distance: return "the pair is an odd number of edges apart, and parity never changes (Theorems 7.2, 7.3)";
    case Refusal::lone_pair: return "a 3-5 pair can not be cancelled without a third irregular vertex (Theorem 7.4)";
    case Refusal::lone_vertex: return "a single irregular vertex can not be moved (Theorem 7.1)";
    case Refusal::index: return "the sum of 4 - l(v) is fixed by the surface (discrete Gauss-Bonnet)";
  }
  return "";
}

namespace {

bool interior(const QuadMesh& m, VertexId v) { return !m.is_boundary(v); }

// v can lose one edge that is not on the boundary.
bool can_lose_edge(const QuadMesh& m, VertexId v) { return m.face_valence(v) >= (interior(m, v) ? 3 : 2); }

}  // namespace

// --- flip ------------------------------------------------------------------------------------------------------------

Refusal why_not_flip(const QuadMesh& m, HalfEdgeId h, Turn turn) {
  if (!m.is_live(h)) return Refusal::dead_element;
  const HalfEdgeId t = m.twin(h);
  if (!t.valid()) return Refusal::boundary_edge;
  const bool ccw = turn == Turn::counter_clockwise;
  // The edge's ends move along the hexagon: u to x, v to y.
  const VertexId x = ccw ? m.target(m.next(t)) : m.origin(m.previous(h));
  const VertexId y = ccw ? m.target(m.next(h)) : m.origin(m.previous(t));
  if (!can_lose_edge(m, m.origin(h)) || !can_lose_edge(m, m.target(h))) return Refusal::valence_too_low;
  if (x == y || m.adjacent(x, y)) return Refusal::edge_exists;
  return Refusal::none;
}

void MeshSurgery::flip(HalfEdgeId h, Turn turn) {
  const HalfEdgeId t = m_.twin(h);
  const VertexId u = m_.origin(h);
  const VertexId v = m_.origin(t);
  // The edge takes the neighbouring slot of each face, and that slot's outer edge goes to the other face, into the slot
  // that the edge left: two outer twins change, not six.
  if (turn == Turn::counter_clockwise) {
    const HalfEdgeId h1 = QuadMesh::next(h);  // v -> p
    const HalfEdgeId t1 = QuadMesh::next(t);  // u -> r
    const HalfEdgeId outer_h1 = m_.twin(h1);
    const HalfEdgeId outer_t1 = m_.twin(t1);
    if (m_.out(v) == h1) restart(v, t);
    if (m_.out(u) == t1) restart(u, h);
    m_.twin_[h.slot()] = outer_t1, glue(outer_t1, h);
    m_.twin_[t.slot()] = outer_h1, glue(outer_h1, t);
    m_.origin_[h1.slot()] = m_.origin(QuadMesh::next(t1));  // r
    m_.origin_[t1.slot()] = m_.origin(QuadMesh::next(h1));  // p
    glue(h1, t1);
  } else {
    const HalfEdgeId h3 = QuadMesh::previous(h);  // q -> u
    const HalfEdgeId t3 = QuadMesh::previous(t);  // s -> v
    const VertexId q = m_.origin(h3);
    const VertexId s = m_.origin(t3);
    const HalfEdgeId outer_h3 = m_.twin(h3);
    const HalfEdgeId outer_t3 = m_.twin(t3);
    if (m_.out(u) == h) restart(u, QuadMesh::next(t));
    if (m_.out(v) == t) restart(v, QuadMesh::next(h));
    if (m_.out(q) == h3) restart(q, t);
    if (m_.out(s) == t3) restart(s, h);
    m_.twin_[h.slot()] = outer_t3, glue(outer_t3, h);
    m_.twin_[t.slot()] = outer_h3, glue(outer_h3, t);
    m_.origin_[h.slot()] = s;
    m_.origin_[t.slot()] = q;
    glue(h3, t3);
  }
}

void flip_unchecked(QuadMesh& mesh, HalfEdgeId h, Turn turn) { MeshSurgery(mesh).flip(h, turn); }

Refusal flip(QuadMesh& mesh, HalfEdgeId h, Turn turn) {
  const Refusal refusal = why_not_flip(mesh, h, turn);
  if (refusal == Refusal::none) flip_unchecked(mesh, h, turn);
  return refusal;
}

// --- collapse --------------------------------------------------------------------------------------------------------

Refusal why_not_collapse(const QuadMesh& m, HalfEdgeId h) {
  if (!m.is_live(h)) return Refusal::dead_element;
  const VertexId a = m.origin(h);
  const VertexId b = m.target(h);
  const VertexId c = m.target(m.next(h));
  const VertexId d = m.origin(m.previous(h));
  if (m.is_boundary(c)) return Refusal::boundary_corner;
  if (!can_lose_edge(m, b) || !can_lose_edge(m, d)) return Refusal::valence_too_low;
  if (m.adjacent(a, c)) return Refusal::edge_exists;
  bool doubles = false;
  m.for_each_out(c, [&](HalfEdgeId x) {
    const VertexId y = m.target(x);
    doubles = doubles || (y != b && y != d && m.adjacent(a, y));
  });
  return doubles ? Refusal::edge_exists : Refusal::none;
}

void MeshSurgery::collapse(HalfEdgeId h) {
  const HalfEdgeId h1 = QuadMesh::next(h);
  const HalfEdgeId h2 = QuadMesh::opposite(h);
  const HalfEdgeId h3 = QuadMesh::previous(h);
  const VertexId a = m_.origin(h);
  const VertexId b = m_.origin(h1);
  const VertexId c = m_.origin(h2);
  const VertexId d = m_.origin(h3);
  const HalfEdgeId ab = m_.twin(h);   // b -> a, or none
  const HalfEdgeId bc = m_.twin(h1);  // c -> b
  const HalfEdgeId cd = m_.twin(h2);  // d -> c
  const HalfEdgeId da = m_.twin(h3);  // a -> d, or none

  m_.for_each_out(c, [&](HalfEdgeId x) { m_.origin_[x.slot()] = a; });
  // The edges a-b, c-b become one, of bc and ab; likewise a-d, c-d. Fans that started in the dead face start beside it.
  if (m_.out(a) == h) restart(a, bc);
  if (m_.out(b) == h1) restart(b, ab);
  if (m_.out(d) == h3) restart(d, cd);
  m_.twin_[bc.slot()] = ab, glue(ab, bc);
  m_.twin_[cd.slot()] = da, glue(da, cd);

  const FaceId f = QuadMesh::face(h);
  for (int k = 0; k < 4; ++k) {
    const HalfEdgeId dead = QuadMesh::half_edge(f, k);
    m_.origin_[dead.slot()] = VertexId();
    m_.twin_[dead.slot()] = HalfEdgeId();
  }
  m_.out_[c.slot()] = HalfEdgeId();
  m_.free_faces_.push_back(f);
  m_.free_vertices_.push_back(c);
}

void collapse_unchecked(QuadMesh& mesh, HalfEdgeId h) { MeshSurgery(mesh).collapse(h); }

Refusal collapse(QuadMesh& mesh, HalfEdgeId h) {
  const Refusal refusal = why_not_collapse(mesh, h);
  if (refusal == Refusal::none) collapse_unchecked(mesh, h);
  return refusal;
}

// --- split -----------------------------------------------------------------------------------------------------------

Refusal why_not_split(const QuadMesh& m, HalfEdgeId first, HalfEdgeId last) {
  if (!m.is_live(first) || !m.is_live(last)) return Refusal::dead_element;
  if (m.target(last) != m.origin(first)) return Refusal::not_one_fan;
  if (m.twin(first) == last) return Refusal::same_edge;
  for (HalfEdgeId h = first; m.previous(h) != last;) {
    h = m.ccw(h);
    if (!h.valid() || h == first) return Refusal::not_one_fan;
  }
  return Refusal::none;
}

FaceId MeshSurgery::new_face() {
  if (!m_.free_faces_.empty()) {
    const FaceId f = m_.free_faces_.back();
    m_.free_faces_.pop_back();
    return f;
  }
  m_.twin_.resize(m_.twin_.size() + 4);
  m_.origin_.resize(m_.origin_.size() + 4);
  return FaceId(m_.face_capacity() - 1);
}

VertexId MeshSurgery::new_vertex() {
  if (!m_.free_vertices_.empty()) {
    const VertexId v = m_.free_vertices_.back();
    m_.free_vertices_.pop_back();
    return v;
  }
  m_.out_.emplace_back();
  return VertexId(m_.vertex_capacity() - 1);
}

HalfEdgeId MeshSurgery::split(HalfEdgeId first, HalfEdgeId last, int corner) {
  const VertexId v = m_.origin(first);
  const VertexId a = m_.target(first);
  const VertexId b = m_.origin(last);
  const bool on_boundary = m_.is_boundary(v);
  const FaceId f = new_face();
  const VertexId w = new_vertex();

  for (HalfEdgeId h = first;; h = m_.ccw(h)) {
    m_.origin_[h.slot()] = w;
    if (QuadMesh::previous(h) == last) break;
  }
  const HalfEdgeId va = QuadMesh::half_edge(f, corner & 3);
  const HalfEdgeId aw = QuadMesh::next(va);
  const HalfEdgeId wb = QuadMesh::opposite(va);
  const HalfEdgeId bv = QuadMesh::previous(va);
  m_.origin_[va.slot()] = v;
  m_.origin_[aw.slot()] = a;
  m_.origin_[wb.slot()] = w;
  m_.origin_[bv.slot()] = b;

  const HalfEdgeId av = m_.twin(first);  // a -> v, or none
  const HalfEdgeId vb = m_.twin(last);   // v -> b, or none
  m_.twin_[va.slot()] = av, glue(av, va);
  m_.twin_[bv.slot()] = vb, glue(vb, bv);
  glue(first, aw);
  glue(last, wb);
  // An interior v may have lost its start to w. A boundary v loses it only if the sector began on the boundary.
  if (!on_boundary || !av.valid()) restart(v, va);
  restart(w, first);
  if (m_.out(b) == last) restart(b, bv);  // b -> v on the boundary, the start of b's fan, is now in the new face
  return va;
}

HalfEdgeId split_unchecked(QuadMesh& mesh, HalfEdgeId first, HalfEdgeId last, int corner) {
  return MeshSurgery(mesh).split(first, last, corner);
}

SplitResult split(QuadMesh& mesh, HalfEdgeId first, HalfEdgeId last, int corner) {
  const Refusal refusal = why_not_split(mesh, first, last);
  if (refusal != Refusal::none) return {refusal, HalfEdgeId()};
  return {refusal, split_unchecked(mesh, first, last, corner)};
}

// --- operations as data ----------------------------------------------------------------------------------------------

std::string to_string(const BasicOperation& op) {
  const std::string h = " " + std::to_string(op.h.index());
  switch (op.kind) {
    case BasicOperation::Kind::flip_ccw: return "flip_ccw" + h;
    case BasicOperation::Kind::flip_cw: return "flip_cw" + h;
    case BasicOperation::Kind::collapse: return "collapse" + h;
    case BasicOperation::Kind::split:
      return "split" + h + " " + std::to_string(op.last.index()) + " " + std::to_string(op.corner);
  }
  return "";
}

Refusal why_not(const QuadMesh& m, const BasicOperation& op) {
  switch (op.kind) {
    case BasicOperation::Kind::flip_ccw: return why_not_flip(m, op.h, Turn::counter_clockwise);
    case BasicOperation::Kind::flip_cw: return why_not_flip(m, op.h, Turn::clockwise);
    case BasicOperation::Kind::collapse: return why_not_collapse(m, op.h);
    case BasicOperation::Kind::split: return why_not_split(m, op.h, op.last);
  }
  return Refusal::none;
}

std::array<VertexId, 4> changed_vertices(const QuadMesh& m, const BasicOperation& op) {
  const HalfEdgeId h = op.h;
  switch (op.kind) {
    case BasicOperation::Kind::flip_ccw:
      return {m.origin(h), m.target(h), m.target(m.next(h)), m.target(m.next(m.twin(h)))};
    case BasicOperation::Kind::flip_cw:
      return {m.origin(h), m.target(h), m.origin(m.previous(h)), m.origin(m.previous(m.twin(h)))};
    case BasicOperation::Kind::collapse: return m.corners(m.face(h));
    case BasicOperation::Kind::split: return {m.origin(h), m.target(h), m.origin(op.last), VertexId()};
  }
  return {};
}

Applied apply(QuadMesh& mesh, const BasicOperation& op) {
  const Refusal refusal = why_not(mesh, op);
  if (refusal != Refusal::none) return {refusal, {}, {}};
  return apply_unchecked(mesh, op);
}

Applied apply_unchecked(QuadMesh& mesh, const BasicOperation& op) {
  using Kind = BasicOperation::Kind;
  Applied done;
  switch (op.kind) {
    case Kind::flip_ccw:
      flip_unchecked(mesh, op.h, Turn::counter_clockwise);
      done.made = QuadMesh::next(op.h);
      done.inverse = {Kind::flip_cw, done.made, {}, 0};
      break;
    case Kind::flip_cw:
      flip_unchecked(mesh, op.h, Turn::clockwise);
      done.made = QuadMesh::previous(op.h);
      done.inverse = {Kind::flip_ccw, done.made, {}, 0};
      break;
    case Kind::collapse: {
      // c is interior, so both of its edges in the face have another side; the sector of c becomes the split's.
      const HalfEdgeId first = mesh.twin(QuadMesh::next(op.h));
      const HalfEdgeId last = mesh.twin(QuadMesh::opposite(op.h));
      done.inverse = {Kind::split, first, last, op.h.index() & 3};
      collapse_unchecked(mesh, op.h);
      break;
    }
    case Kind::split:
      done.made = split_unchecked(mesh, op.h, op.last, op.corner);
      done.inverse = {Kind::collapse, done.made, {}, 0};
      break;
  }
  return done;
}

}  // namespace requad::mesh
