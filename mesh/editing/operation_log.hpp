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

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "mesh/topology/basic_operations.hpp"

namespace requad::mesh {

// A vertex that got another position.
struct Placement {
  VertexId vertex;
  Eigen::Vector3d from;
  Eigen::Vector3d to;
};

// One entry of a log: a basic operation with the placements that belong to it, or placements alone.
struct Edit {
  bool operates = false;
  BasicOperation operation;  // if operates
  BasicOperation inverse;    // if operates
  // If an Editor performed the operation: the vertices whose valence changed, a split's new one among them.
  std::array<VertexId, 4> changed;
  std::vector<Placement> placements;

  // The vertex (by an Editor only) and the face that a collapse removed or that a split made; none if the edit did not.
  VertexId removed_vertex() const;
  FaceId removed_face() const;
  VertexId made_vertex() const;
  FaceId made_face() const;
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

  // The edits since the start, or since the last forget().
  const std::vector<Edit>& edits() const { return edits_; }
  std::size_t mark() const { return edits_.size(); }
  // Rolls back all edits after the first `mark` ones.
  virtual void roll_back(std::size_t mark = 0);
  // Drops all edits from the log. They can then no longer be rolled back.
  void forget() { edits_.clear(); }

 protected:
  // Rolls back the last edit, except for its placements.
  void take_back_last();

  QuadMesh& mesh_;
  std::vector<Edit> edits_;
};

}  // namespace requad::mesh
