#include "mesh/editing/operation_log.hpp"

namespace requad::mesh {

VertexId Edit::removed_vertex() const {
  if (!removed_face().valid()) return {};
  return changed[static_cast<std::size_t>(QuadMesh::opposite(operation.h).index() & 3)];
}

FaceId Edit::removed_face() const {
  if (!operates || operation.kind != BasicOperation::Kind::collapse) return {};
  return QuadMesh::face(operation.h);
}

VertexId Edit::made_vertex() const { return made_face().valid() ? changed[3] : VertexId(); }

FaceId Edit::made_face() const {
  if (!operates || operation.kind != BasicOperation::Kind::split) return {};
  return QuadMesh::face(inverse.h);
}

Applied OperationLog::run(const BasicOperation& operation) {
  const Applied done = apply(mesh_, operation);
  if (done.refusal == Refusal::none) {
    Edit& edit = edits_.emplace_back();
    edit.operates = true;
    edit.operation = operation;
    edit.inverse = done.inverse;
  }
  return done;
}

void OperationLog::take_back_last() {
  if (edits_.back().operates) take_back(mesh_, edits_.back().inverse);
  edits_.pop_back();
}

void OperationLog::roll_back(std::size_t mark) {
  while (edits_.size() > mark) take_back_last();
}

}  // namespace requad::mesh
