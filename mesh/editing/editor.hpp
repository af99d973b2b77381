// An editing session on one mesh: a log that also guards features and moves vertices.
//
// An editor performs basic operations on a mesh, refuses those that would break a feature, and updates the vertices'
// positions (if it is given any). All edits of real meshes, from the transport of an adjacent 3-5 pair to the
// reduction of a whole mesh, go through one.
//
// Law editing-2. roll_back(mark) also restores the positions of the live vertices, and the homes of a correspondence,
//         bit by bit.
// Law editing-3. No position of a fixed vertex changes. A vertex is fixed if it lies on the boundary or on a feature.
// Law editing-4. Whatever the editor performs keeps every feature edge (Law editing-5 in features.hpp).
//
// Costs: those of the log, and O(valence) for the positions.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "mesh/editing/features.hpp"
#include "mesh/editing/operation_log.hpp"
#include "mesh/editing/sectors.hpp"
#include "mesh/geometry/fitting.hpp"
#include "mesh/geometry/measures.hpp"
#include "mesh/geometry/smoothing.hpp"

namespace requad::mesh {

// A vertex that got another position.
struct Placement {
  VertexId vertex;
  Eigen::Vector3d from;
  Eigen::Vector3d to;
};

// What an editor did at once: a basic operation with the placements that belong to it, or placements alone.
struct Edit {
  bool operates = false;
  BasicOperation operation;         // if it operates
  BasicOperation inverse;           // if it operates
  std::array<VertexId, 4> changed;  // if it operates: the vertices whose valence changed, a split's new one among them
  std::array<HalfEdgeId, 4> fans;   // of these, the half-edge out() before; none if the vertex was not there
  std::array<FaceId, 4> beside;     // if it collapses: the faces that lay beyond the edges of the face's four corners
  std::vector<Placement> placements;
  // If it carries a correspondence: its mark before, and how many edits it had been carried through then.
  bool carries = false;
  std::size_t homes = 0;
  std::size_t followed = 0;

  // The vertex and the face that a collapse removed or that a split made; none if the edit did not.
  VertexId removed_vertex() const;
  FaceId removed_face() const;
  VertexId made_vertex() const;
  FaceId made_face() const;
};

// How many of some edits operate, and how many faces these make and delete.
struct EditCounts {
  int operations = 0;
  int faces_made = 0;
  int faces_deleted = 0;
};
EditCounts count(std::span<const Edit> edits);

class Editor : public OperationLog {
 public:
  // The mesh must outlive the editor, and so must features, positions and plan (optional: null). `positions` has an
  // entry for every vertex slot and grows with the mesh.
  // Without a sector plan, edits leave the valences of fixed vertices alone (sectors.hpp).
  explicit Editor(QuadMesh& mesh, const FeatureSet* features = nullptr, Positions* positions = nullptr,
                  const SectorPlan* plan = nullptr);

  const Positions* positions() const { return positions_; }
  const Sectors& sectors() const { return sectors_; }
  bool is_fixed(VertexId v) const { return sectors_.is_fixed(v); }

  // Whether the operation is legal and keeps the features.
  Refusal why_not(const BasicOperation& operation) const override;
  // Performs the operation, or leaves everything as it was. What a collapse merges comes to lie halfway, unless one of
  // the two vertices is fixed. The parts of a split vertex move a little towards the faces that they take.
  Applied run(const BasicOperation& operation) override;
  // Performs an operation that was recorded. The new vertex of a split comes to lie at `made_at`; nothing else moves
  // until place() is called for it.
  Applied replay(const BasicOperation& operation, const Eigen::Vector3d& made_at);
  // Moves a vertex. Precondition: there are positions, and v is live and not fixed.
  void place(VertexId v, const Eigen::Vector3d& position);
  // Lets `arrange(positions)` move some of these vertices, as one edit. It must move no other one and no fixed one.
  template <class Arrange>
  void rearrange(std::span<const VertexId> vertices, Arrange&& arrange) {
    Edit edit = rearranged(vertices, arrange);
    if (!edit.placements.empty()) edits_.push_back(std::move(edit));
  }

  // Smooths some vertices, as one edit. Fixed ones stay: `how.fixed` is overridden. Precondition: there are positions.
  void smooth(std::span<const VertexId> vertices, SmoothingOptions how);

  // From now on keeps a correspondence with the mesh, or none if it is null; it must live as long. The edits before this
  // call can still be rolled back, but the correspondence is wrong then. Preconditions: there are positions, and the
  // homes of the correspondence are on the mesh as it is.
  void keep(Correspondence* homes);
  // Carries the correspondence through the edits since the last time, as one edit: each sample has a face again.
  // Precondition: a correspondence is kept.
  void carry();
  // Carries the correspondence, then moves the vertices (fitting.hpp), as one edit. Fixed ones stay: `how.fixed` is
  // overridden. Precondition: a correspondence is kept.
  void fit(std::span<const VertexId> vertices, const SurfaceIndex& surface, FitOptions how);

  // What was done since the start, or since forget(), without what was rolled back. Marks count these edits.
  const std::vector<Edit>& edits() const { return edits_; }
  std::size_t mark() const override { return edits_.size(); }
  // Also restores the half-edge at which each fan starts, QuadMesh::out(). So edits that were tried and rolled back leave
  // no trace: what is done next, and in what order, does not depend on them.
  void roll_back(std::size_t mark = 0) override;
  // Makes an edit again that was rolled back: the same ids and bits. Precondition: the mesh is as it was before the
  // edit. The homes of a correspondence are found anew. Throws std::logic_error if the operation is refused.
  void redo(const Edit& edit);
  void forget() override;

 private:
  Applied perform(const BasicOperation& operation);
  Edit carried();
  template <class Arrange>
  Edit rearranged(std::span<const VertexId> vertices, Arrange&& arrange) {
    Edit edit;
    for (const VertexId v : vertices) edit.placements.push_back({v, (*positions_)[v.slot()], Eigen::Vector3d::Zero()});
    arrange(*positions_);
    for (Placement& p : edit.placements) p.to = (*positions_)[p.vertex.slot()];
    std::erase_if(edit.placements, [](const Placement& p) { return same_bits(p.from, p.to); });
    return edit;
  }
  void grow_positions();
  void record_placement(Edit& edit, VertexId v, const Eigen::Vector3d& to);
  void place_parts(HalfEdgeId made, Edit& edit);

  const FeatureSet* features_;
  Positions* positions_;
  Correspondence* homes_ = nullptr;
  std::size_t followed_ = 0;  // the correspondence is carried through so many edits
  Sectors sectors_;
  std::vector<Edit> edits_;
};

}  // namespace requad::mesh
