// An editing session on one mesh: every change is checked, recorded and can be taken back.
//
// An editor performs basic operations on a mesh, refuses those that would break a feature, keeps the vertices'
// positions (if it is given any) in step, and remembers each change together with its inverse. All the composite
// operations of this folder, from the courier's steps to the reduction of a whole mesh, go through one.
//
// Law E1. roll_back(mark) restores the mesh of that mark with all ids and free ids, and the positions of its live
//         vertices bit by bit.
// Law E2. No position of a fixed vertex changes. A vertex is fixed if it lies on the boundary or on a feature.
// Law E3. Whatever the editor performs keeps every feature edge (Law F of features.hpp).
//
// Costs: those of the basic operations; memory grows by the edits until forget().
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "mesh/editing/features.hpp"
#include "mesh/editing/sectors.hpp"
#include "mesh/geometry/measures.hpp"

namespace requad::mesh {

// A vertex that got another position.
struct Placement {
  VertexId vertex;
  Eigen::Vector3d from;
  Eigen::Vector3d to;
};

// One change: a basic operation with the placements that belong to it, or placements alone.
struct Edit {
  bool operates = false;
  BasicOperation operation;         // if operates
  BasicOperation inverse;           // if operates
  std::array<VertexId, 4> changed;  // if operates: the vertices whose valence changed, a split's new one among them
  std::vector<Placement> placements;

  // The vertex and the face that a collapse removed, or a split made; none if the edit did not.
  VertexId removed_vertex() const;
  FaceId removed_face() const;
  VertexId made_vertex() const;
  FaceId made_face() const;
};

class Editor {
 public:
  // The mesh must outlive the editor, and so must features, positions and plan (optional: null). `positions` has an
  // entry for every vertex slot and grows with the mesh.
  // Without a sector plan, couriers leave the valences of fixed vertices alone (sectors.hpp).
  explicit Editor(QuadMesh& mesh, const FeatureSet* features = nullptr, Positions* positions = nullptr,
                  const SectorPlan* plan = nullptr);

  const QuadMesh& mesh() const { return mesh_; }
  const Positions* positions() const { return positions_; }
  const Sectors& sectors() const { return sectors_; }
  bool is_fixed(VertexId v) const { return sectors_.is_fixed(v); }

  // Whether the operation is legal and keeps the features.
  Refusal why_not(const BasicOperation& operation) const;
  // Performs it, or leaves everything as it was. New positions: what a collapse merges lies halfway, unless one of the
  // two is fixed; the parts of a split vertex move a little towards the faces they take.
  Applied run(const BasicOperation& operation);
  // Performs an operation that was recorded: the new vertex of a split comes to `made_at`, and nothing else moves until
  // place() is called for it.
  Applied replay(const BasicOperation& operation, const Eigen::Vector3d& made_at);
  // Moves a vertex. Precondition: there are positions, and v is live and not fixed.
  void place(VertexId v, const Eigen::Vector3d& position);
  // Lets `arrange(positions)` move some vertices, of which it may move no other and no fixed one, as one edit.
  template <class Arrange>
  void rearrange(std::span<const VertexId> vertices, Arrange&& arrange) {
    Edit edit;
    for (const VertexId v : vertices) edit.placements.push_back({v, (*positions_)[v.slot()], Eigen::Vector3d::Zero()});
    arrange(*positions_);
    for (Placement& p : edit.placements) p.to = (*positions_)[p.vertex.slot()];
    std::erase_if(edit.placements, [](const Placement& p) { return same_bits(p.from, p.to); });
    if (!edit.placements.empty()) edits_.push_back(std::move(edit));
  }

  // The changes since the start, or since forget().
  const std::vector<Edit>& edits() const { return edits_; }
  std::size_t mark() const { return edits_.size(); }
  // Takes back all edits after the first `mark` ones.
  void roll_back(std::size_t mark = 0);
  // Drops the memory of all edits, which can not be taken back any more.
  void forget() { edits_.clear(); }

 private:
  // Checks and performs the operation, fills in the edit, but for its placements, and makes room for positions.
  Applied perform(const BasicOperation& operation, Edit& edit);
  void record_placement(Edit& edit, VertexId v, const Eigen::Vector3d& to);
  void place_parts(HalfEdgeId made, Edit& edit);

  QuadMesh& mesh_;
  const FeatureSet* features_;
  Positions* positions_;
  Sectors sectors_;
  std::vector<Edit> edits_;
};

}  // namespace requad::mesh
