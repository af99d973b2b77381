#include "mesh/topology/basic_operations.hpp"

#include <stdexcept>

namespace requad::mesh {

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
    case Refusal::odd_distance:
      return "the pair is an odd number of edges apart, and parity never changes (Theorems 7.2, 7.3)";
    case Refusal::lone_pair: return "a 3-5 pair can not be cancelled without a third irregular vertex (Theorem 7.4)";
    case Refusal::lone_vertex: return "a single irregular vertex can not be moved (Theorem 7.1)";
    case Refusal::index: return "the sum of 4 - l(v) is fixed by the surface (discrete Gauss-Bonnet)";
  }
  return "";
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
    case BasicOperation::Kind::flip_ccw: return why_not_flip(m, op.h, Rotation::counter_clockwise);
    case BasicOperation::Kind::flip_cw: return why_not_flip(m, op.h, Rotation::clockwise);
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
      flip_unchecked(mesh, op.h, Rotation::counter_clockwise);
      done.made = QuadMesh::next(op.h);
      done.inverse = {Kind::flip_cw, done.made, {}, 0};
      break;
    case Kind::flip_cw:
      flip_unchecked(mesh, op.h, Rotation::clockwise);
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

void take_back(QuadMesh& mesh, const BasicOperation& inverse) {
  const Refusal refusal = apply(mesh, inverse).refusal;
  if (refusal != Refusal::none)
    throw std::logic_error("the inverse of an operation, " + to_string(inverse) +
                           ", was refused: " + std::string(explain(refusal)));
}

}  // namespace requad::mesh
