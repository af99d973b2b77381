// The three basic operations of section 4: edge flip, quad collapse, edge split.
//
// Each has a const query that says whether it is legal and why not, a checked call that leaves the mesh untouched when
// it refuses, and an unchecked call whose precondition is that the query says Refusal::none.
//
// Laws, for every legal operation
//   O1  The result satisfies the invariants of QuadMesh; Euler characteristic and orientation stay.
//   O2  The boundary stays as a cycle of vertices: no boundary edge is made or removed. (Boundary vertices may change
//       their valence; what must not touch them at all asks changed_vertices() first, as the pair moves do.)
//   O3  Valences (Law B2 of the paper's section 4):
//         flip      the two ends of the edge lose 1, the two vertices it turns to gain 1
//         collapse  corners a, c merge into one of valence l(a) + l(c) - 2; corners b, d lose 1
//         split     v parts into two vertices of valence g1 + 2 and g2 + 2, where g1, g2 edges lie strictly between the
//                   two edges of the path, on either side; the path's ends gain 1
//   O4  An operation followed by the inverse that apply() returns gives an equal mesh: same ids, same free ids next.
//   O5  An operation touches the arrays of its own one or two faces, their neighbours' twins, and (collapse, split) the
//       half-edges out of one vertex: O(1), or O(valence) of the vertex removed or made.
// A flip is not its own inverse: three counter-clockwise flips bring an edge back, turned end for end, as three diagonals
// of a hexagon join opposite corners.
#pragma once

#include <array>
#include <span>
#include <string>

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

// What came of an operation.
struct Applied {
  Refusal refusal = Refusal::none;
  BasicOperation inverse;  // meaningful if refusal is none
  HalfEdgeId made;         // the flipped edge in face(h), or the split's v -> a; none for a collapse
};

Refusal why_not(const QuadMesh& mesh, const BasicOperation& operation);
// The vertices whose valence the operation changes (a split's v, a, b; none in unused places). Precondition: legal.
std::array<VertexId, 4> changed_vertices(const QuadMesh& mesh, const BasicOperation& operation);
Applied apply(QuadMesh& mesh, const BasicOperation& operation);
// Precondition: why_not() says Refusal::none.
Applied apply_unchecked(QuadMesh& mesh, const BasicOperation& operation);
// Takes the last operation back by its inverse. This is checked: the inverse is legal by the law above, and what breaks
// that law must not break a mesh. Throws std::logic_error if the inverse is refused.
void take_back(QuadMesh& mesh, const BasicOperation& inverse);
// Applies the operations in order, all or none. Returns the refusal of the first that was refused.
Refusal apply_all(QuadMesh& mesh, std::span<const BasicOperation> operations);

enum class Rotation { counter_clockwise, clockwise };

// Edge flip. The edge h = u -> v, between two quads that form a hexagon, turns by one corner of it:
//
//        p --- v --- s            p --- v --- s            p --- v --- s
//        |     ^     |            | `.        |            |        ,' |
//        |  f  | h   |     =>     |    `.     |     or     |     ,'    |
//        |     |     |            |       `.  |            |  ,'       |
//        q --- u --- r            q --- u --- r            q --- u --- r
//            before             counter-clockwise            clockwise
//
// u and v lose an edge; p and r, or q and s, gain one. Faces keep their ids. Counter-clockwise, the edge is afterwards
// next(h) in face(h); clockwise, previous(h).
Refusal why_not_flip(const QuadMesh& mesh, HalfEdgeId h, Rotation rotation);
Refusal flip(QuadMesh& mesh, HalfEdgeId h, Rotation rotation);
void flip_unchecked(QuadMesh& mesh, HalfEdgeId h, Rotation rotation);

// Quad collapse. In the face of h = a -> b with corners a, b, c, d, vertex c merges into a; the face and c disappear.
//
//      d <-- c            d
//      |     |     =>     |  \        (a's id stays; edges a-b and a-d stay)
//      a -h-> b           a -- b
Refusal why_not_collapse(const QuadMesh& mesh, HalfEdgeId h);
Refusal collapse(QuadMesh& mesh, HalfEdgeId h);
void collapse_unchecked(QuadMesh& mesh, HalfEdgeId h);

// Edge split. first = v -> a and last = b -> v bound a sector of faces round v, from face(first) counter-clockwise to
// face(last). A new vertex w takes the sector, and a new face (v, a, w, b) opens between.
//
//            \|/                     \|/
//      b ---- v ---- a      =>    b <- w <- a        (v keeps what is outside the sector)
//            /|\                   \-> v ->/
//
// In the result `made` is v -> a in the new face, whose opposite is w -> b.
// `corner` (0..3) is the corner of the new face at v, so that an inverse restores ids exactly.
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
  // Ends on the boundary keep a face: the edge is not on it, so each has two.
  if (has_two_edges(m, h) || has_two_edges(m, t)) return Refusal::valence_too_low;
  // The edge's ends move along the hexagon, to the origins of x and y.
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
  // The edges at c are not on the boundary, so b and d keep a face.
  if (has_two_edges(m, QuadMesh::next(h)) || has_two_edges(m, QuadMesh::previous(h))) return Refusal::valence_too_low;
  // No neighbour of c but b and d is a or a neighbour of a.
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
