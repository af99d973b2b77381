// A log of what is done to a mesh: each operation is checked, recorded, and can be taken back.
//
// Whatever changes a mesh by more than one operation works on a log. Pair moves need no more than that. An Editor
// (editor.hpp) is a log that also guards features and keeps the vertices' positions in step.
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

  // What was done since the start, or since forget().
  const std::vector<Edit>& edits() const { return edits_; }
  std::size_t mark() const { return edits_.size(); }
  // Takes back all edits after the first `mark` ones.
  virtual void roll_back(std::size_t mark = 0);
  // Drops the memory of all edits, which then cannot be taken back any more.
  void forget() { edits_.clear(); }

 protected:
  // Takes the last edit back, its placements excepted.
  void take_back_last();

  QuadMesh& mesh_;
  std::vector<Edit> edits_;
};

}  // namespace requad::mesh
