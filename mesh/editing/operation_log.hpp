// A log of the edits of a mesh: each operation is checked and recorded, and the log can be rolled back.
//
// Terms
//   inverse     of an operation: the operation that restores the mesh (basic_operations.hpp).
//   roll back   of a log: to apply the inverses of its last edits, last first.
//   undo        what a user does to a script (script.hpp) or to a move (MoveReport::undo): to apply all its inverses.
//
// Code that changes a mesh by more than one operation works on a log. A pair move needs nothing else. An Editor
// (editor.hpp) is a log that also guards features and updates the positions of vertices.
//
// Law editing-1. roll_back(mark) restores the mesh of that mark, with all ids and free ids.
//
// Costs: those of the basic operations. Memory grows by the edits until forget(), which keeps it for the next ones.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/topology/basic_operations.hpp"

namespace requad::mesh {

// An operation that was performed, with its inverse.
struct PerformedOperation {
  BasicOperation operation;
  BasicOperation inverse;
};

class OperationLog {
 public:
  // The mesh must outlive the log. Nothing else may change it meanwhile.
  explicit OperationLog(QuadMesh& mesh) : mesh_(mesh) {}
  virtual ~OperationLog() = default;
  OperationLog(const OperationLog&) = delete;
  OperationLog& operator=(const OperationLog&) = delete;

  const QuadMesh& mesh() const { return mesh_; }

  // Why the operation is refused: it is illegal, or what goes along with the mesh does not allow it.
  virtual Refusal why_not(const BasicOperation& operation) const { return mesh::why_not(mesh_, operation); }
  // Performs the operation, or leaves everything as it was.
  virtual Applied run(const BasicOperation& operation);

  // The operations since the start, or since forget(), without those that were rolled back.
  const std::vector<PerformedOperation>& operations() const { return operations_; }
  // How much was done since the start, or since forget(): a place in the log to which it can be rolled back.
  virtual std::size_t mark() const { return operations_.size(); }
  // Rolls back, last first, whatever was done after the log had this mark.
  virtual void roll_back(std::size_t mark = 0);
  // Empties the log. What was done before can then no longer be rolled back.
  virtual void forget() { operations_.clear(); }

 protected:
  // Rolls back the last operation.
  void roll_back_last();

  QuadMesh& mesh_;
  std::vector<PerformedOperation> operations_;
};

}  // namespace requad::mesh
