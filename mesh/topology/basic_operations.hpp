// The three basic operations of section 4: edge flip, quad collapse, edge split.
//
// Each operation has three functions. For the edge flip they are:
//   why_not_flip     a query: whether the flip is legal, and why not.
//   flip             makes the flip if it is legal; otherwise it leaves the mesh untouched and returns the refusal.
//   flip_unchecked   makes the flip without the query. Precondition: why_not_flip() returns Refusal::none.
//
// Laws, for every legal operation
//   topology-5  The result satisfies the invariants of QuadMesh. The Euler characteristic and the orientation stay.
//   topology-6  Each boundary loop stays as a cycle of vertices: no boundary edge is made or removed. The valence of a
//               boundary vertex may change. (A caller that must not allow this, like the pair moves, looks at
//               changed_vertices() first.)
//   topology-7  Valences (claim B2; section 4):
//                 flip      The two ends of the edge lose 1. The two vertices that become its ends gain 1.
//                 collapse  Corners a and c merge into a vertex of valence l(a) + l(c) - 2. Corners b and d lose 1.
//                 split     A path of two edges runs through v, with g1 edges of v strictly on one side and g2 on the
//                           other. Vertex v becomes two vertices of valence g1 + 2 and g2 + 2. The path's ends gain 1.
//   topology-8  An operation followed by the inverse that apply() returns gives an equal mesh: the same ids, and the
//               same free ids next.
//   topology-9  A flip writes to the half-edges of its two faces and to two twins outside: O(1). A collapse or a split
//               writes to the half-edges of its face, to the twins outside, and to the half-edges out of the vertex
//               that is removed or made: O(valence of that vertex).
// Not a law: a flip is not its own inverse. The three main diagonals of a hexagon join opposite corners, so the third
// counter-clockwise flip brings an edge back with its ends exchanged.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "mesh/topology/refusal.hpp"
#include "mesh/topology/surgery.hpp"

namespace requad::mesh {

// An operation as data: what scripts are made of.
struct BasicOperation {
  enum class Kind { flip_ccw, flip_cw, collapse, split };
  Kind kind = Kind::flip_ccw;
  HalfEdgeId h;     // the edge, the face's corner to keep, or the split's first
  HalfEdgeId last;  // split only
  int corner = 0;   // split only

  friend bool operator==(const BasicOperation&, const BasicOperation&) = default;
};
// "flip_ccw 12", "flip_cw 12", "collapse 12", "split 12 34 0".
std::string to_string(const BasicOperation& operation);

// The outcome of an operation.
struct Applied {
  Refusal refusal = Refusal::none;
  BasicOperation inverse;  // meaningful if refusal is none
  HalfEdgeId made;         // the flipped edge in face(h), or the split's v -> a; none for a collapse
};

Refusal why_not(const QuadMesh& mesh, const BasicOperation& operation);
// The vertices whose valence the operation changes, of a split v, a and b. Unused places hold none. Precondition: the
// operation is legal.
std::array<VertexId, 4> changed_vertices(const QuadMesh& mesh, const BasicOperation& operation);
Applied apply(QuadMesh& mesh, const BasicOperation& operation);
// Precondition: why_not() says Refusal::none.
Applied apply_unchecked(QuadMesh& mesh, const BasicOperation& operation);
// Undoes the last operation by its inverse, which is legal by Law topology-8. Checks this nevertheless, so that a fault
// of this library cannot break a mesh. Throws std::logic_error if the inverse is refused.
void take_back(QuadMesh& mesh, const BasicOperation& inverse);
// All legal operations that change no valence on the boundary, each once up to names: two flips for each edge, two
// collapses for each face (one for each diagonal), and one split for any two edges at a vertex. O(sum of l^3).
std::vector<BasicOperation> operations_inside(const QuadMesh& mesh);
// Applies the operations in order, all or none. Returns the refusal of the first that was refused.
Refusal apply_all(QuadMesh& mesh, std::span<const BasicOperation> operations);

enum class Rotation { counter_clockwise, clockwise };

// Edge flip. The edge h = u -> v lies between two quads, which form a hexagon. Each end moves to the next corner of it:
//
//        p --- v --- s            p --- v --- s            p --- v --- s
//        |     ^     |            | `.        |            |        ,' |
//        |  f  | h   |     =>     |    `.     |     or     |     ,'    |
//        |     |     |            |       `.  |            |  ,'       |
//        q --- u --- r            q --- u --- r            q --- u --- r
//            before             counter-clockwise            clockwise
//
// u and v lose an edge; p and r, or q and s, gain one. The faces keep their ids. Afterwards the edge is next(h) in
// face(h) if the flip was counter-clockwise, and previous(h) if it was clockwise.
Refusal why_not_flip(const QuadMesh& mesh, HalfEdgeId h, Rotation rotation);
Refusal flip(QuadMesh& mesh, HalfEdgeId h, Rotation rotation);
void flip_unchecked(QuadMesh& mesh, HalfEdgeId h, Rotation rotation);

// Quad collapse. The face of h = a -> b has the corners a, b, c, d. Vertex c merges into a; the face and c disappear.
//
//      d <--- c            d
//      |      |     =>     |           The edges c-b and c-d become one with a-b and a-d. All other edges of c are then
//      a -h-> b            a --- b     edges of a.
Refusal why_not_collapse(const QuadMesh& mesh, HalfEdgeId h);
Refusal collapse(QuadMesh& mesh, HalfEdgeId h);
void collapse_unchecked(QuadMesh& mesh, HalfEdgeId h);

// Edge split, the inverse of a collapse. The half-edges first = v -> a and last = b -> v bound a sector of faces round
// v, from face(first) counter-clockwise to face(last). The edges of the sector move from v to a new vertex w, and a new
// face (v, a, w, b) opens between:
//
//                                          \|/
//            \|/                         ,- w -.
//      b ---- v ---- a         =>       b       a
//            /|\                         `- v -'
//                                          /|\     v keeps the other edges
//
// In the result `made` is v -> a in the new face, whose opposite is w -> b.
// `corner` (0..3) says which corner of the new face is at v, so that an inverse can restore ids exactly.
Refusal why_not_split(const QuadMesh& mesh, HalfEdgeId first, HalfEdgeId last);
Applied split(QuadMesh& mesh, HalfEdgeId first, HalfEdgeId last, int corner = 0);
HalfEdgeId split_unchecked(QuadMesh& mesh, HalfEdgeId first, HalfEdgeId last, int corner = 0);

// --- the bodies of the above, to be inlined -------------------------------------------------------------------------
//
// The time goes into memory. So a query reads the faces that the operation touches anyway, and as few others as it can:
// the two faces at an edge show whether a valence is 2, and one walk both ways round a vertex (QuadMesh::joined) shows
// whether an edge exists already.

// Whether origin(h) is an interior vertex of valence 2, which cannot lose an edge.
inline bool has_two_edges(const QuadMesh& m, HalfEdgeId h) {
  const HalfEdgeId left = m.ccw(h);
  return left.valid() && left == m.cw(h);
}

inline Refusal why_not_flip(const QuadMesh& m, HalfEdgeId h, Rotation rotation) {
  if (!m.is_live(h)) return Refusal::dead_element;
  const HalfEdgeId t = m.twin(h);
  if (!t.valid()) return Refusal::boundary_edge;
  // A boundary vertex at an end keeps a face: the edge is interior, so that vertex has two faces or more.
  if (has_two_edges(m, h) || has_two_edges(m, t)) return Refusal::valence_too_low;
  // The ends move to the origins of x and y.
  const bool ccw = rotation == Rotation::counter_clockwise;
  const HalfEdgeId x = ccw ? QuadMesh::opposite(t) : QuadMesh::previous(h);
  const HalfEdgeId y = ccw ? QuadMesh::opposite(h) : QuadMesh::previous(t);
  if (m.origin(x) == m.origin(y) || m.joined(x, m.origin(y))) return Refusal::edge_exists;
  return Refusal::none;
}

inline void flip_unchecked(QuadMesh& mesh, HalfEdgeId h, Rotation rotation) {
  if (rotation == Rotation::counter_clockwise) {
    MeshSurgery(mesh).flip_counter_clockwise(h);
  } else {
    MeshSurgery(mesh).flip_clockwise(h);
  }
}

inline Refusal flip(QuadMesh& mesh, HalfEdgeId h, Rotation rotation) {
  const Refusal refusal = why_not_flip(mesh, h, rotation);
  if (refusal == Refusal::none) flip_unchecked(mesh, h, rotation);
  return refusal;
}

inline Refusal why_not_collapse(const QuadMesh& m, HalfEdgeId h) {
  if (!m.is_live(h)) return Refusal::dead_element;
  const HalfEdgeId h2 = QuadMesh::opposite(h);  // c -> d
  if (m.is_boundary(m.origin(h2))) return Refusal::boundary_corner;
  // The edges at c are interior, so b and d keep a face.
  if (has_two_edges(m, QuadMesh::next(h)) || has_two_edges(m, QuadMesh::previous(h))) return Refusal::valence_too_low;
  // Apart from b and d, no neighbour of c may be a or a neighbour of a.
  const VertexId a = m.origin(h);
  for (HalfEdgeId x = m.ccw(m.ccw(h2)); x != h2; x = m.ccw(x)) {
    if (m.target(x) == a || m.joined(h, m.target(x))) return Refusal::edge_exists;
  }
  return Refusal::none;
}

inline void collapse_unchecked(QuadMesh& mesh, HalfEdgeId h) { MeshSurgery(mesh).collapse(h); }

inline Refusal collapse(QuadMesh& mesh, HalfEdgeId h) {
  const Refusal refusal = why_not_collapse(mesh, h);
  if (refusal == Refusal::none) collapse_unchecked(mesh, h);
  return refusal;
}

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

inline HalfEdgeId split_unchecked(QuadMesh& mesh, HalfEdgeId first, HalfEdgeId last, int corner) {
  return MeshSurgery(mesh).split(first, last, corner);
}

inline Applied split(QuadMesh& mesh, HalfEdgeId first, HalfEdgeId last, int corner) {
  const Refusal refusal = why_not_split(mesh, first, last);
  if (refusal != Refusal::none) return {refusal, {}, {}};
  const HalfEdgeId made = split_unchecked(mesh, first, last, corner);
  return {refusal, {BasicOperation::Kind::collapse, made, {}, 0}, made};
}

}  // namespace requad::mesh
