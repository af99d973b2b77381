#include "mesh/topology/basic_operations.hpp"

#include <stdexcept>
#include <vector>

namespace requad::mesh {

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
                           ", was refused: " + std::string(refusal.clause()));
}

std::vector<BasicOperation> operations_inside(const QuadMesh& m) {
  using Kind = BasicOperation::Kind;
  std::vector<BasicOperation> operations;
  const auto add = [&](const BasicOperation& op) {
    if (why_not(m, op) != Refusal::none) return;
    for (const VertexId v : changed_vertices(m, op)) {
      if (v.valid() && m.is_boundary(v)) return;
    }
    operations.push_back(op);
  };
  for (const HalfEdgeId h : m.half_edges()) {
    if (h < m.twin(h)) {
      add({Kind::flip_ccw, h, {}, 0});
      add({Kind::flip_cw, h, {}, 0});
    }
    if (h.index() % 4 < 2) add({Kind::collapse, h, {}, 0});
  }
  for (const VertexId v : m.vertices()) {
    if (m.is_boundary(v)) continue;
    std::vector<HalfEdgeId> out;
    m.for_each_out(v, [&out](HalfEdgeId h) { out.push_back(h); });
    for (std::size_t i = 0; i < out.size(); ++i) {
      for (std::size_t k = i + 1; k < out.size(); ++k) add({Kind::split, out[i], m.twin(out[k]), 0});
    }
  }
  return operations;
}

Refusal apply_all(QuadMesh& mesh, std::span<const BasicOperation> operations) {
  std::vector<BasicOperation> undo;
  for (const BasicOperation& op : operations) {
    const Applied done = apply(mesh, op);
    if (done.refusal != Refusal::none) {
      for (; !undo.empty(); undo.pop_back()) take_back(mesh, undo.back());
      return done.refusal;
    }
    undo.push_back(done.inverse);
  }
  return Refusal::none;
}

}  // namespace requad::mesh
