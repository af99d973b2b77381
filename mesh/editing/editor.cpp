#include "mesh/editing/editor.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

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

EditCounts count(std::span<const Edit> edits) {
  EditCounts counts;
  for (const Edit& edit : edits) {
    counts.operations += edit.operates ? 1 : 0;
    counts.faces_made += edit.made_face().valid() ? 1 : 0;
    counts.faces_deleted += edit.removed_face().valid() ? 1 : 0;
  }
  return counts;
}

Editor::Editor(QuadMesh& mesh, const FeatureSet* features, Positions* positions, const SectorPlan* plan)
    : OperationLog(mesh), features_(features), positions_(positions), sectors_(mesh, features, plan) {
  grow_positions();
}

// A position for each vertex slot.
void Editor::grow_positions() {
  if (positions_ != nullptr)
    positions_->resize(static_cast<std::size_t>(mesh_.vertex_capacity()), Eigen::Vector3d::Zero());
}

Refusal Editor::why_not(const BasicOperation& operation) const {
  const Refusal refusal = OperationLog::why_not(operation);
  if (refusal != Refusal::none || features_ == nullptr) return refusal;
  return features_->why_not(mesh_, operation);
}

// Performs the operation if why_not() allows it, and adds it to the log.
Applied Editor::perform(const BasicOperation& operation) {
  Applied done;
  done.refusal = why_not(operation);
  if (done.refusal != Refusal::none) return done;
  Edit& edit = edits_.emplace_back();
  edit.operates = true;
  edit.operation = operation;
  edit.changed = changed_vertices(mesh_, operation);
  for (std::size_t i = 0; i < edit.changed.size(); ++i) {
    if (edit.changed[i].valid()) edit.fans[i] = mesh_.out(edit.changed[i]);
  }
  if (operation.kind == BasicOperation::Kind::collapse) {
    for (int k = 0; k < 4; ++k) {
      const HalfEdgeId twin = mesh_.twin(QuadMesh::half_edge(QuadMesh::face(operation.h), k));
      if (twin.valid()) edit.beside[static_cast<std::size_t>(k)] = QuadMesh::face(twin);
    }
  }
  done = apply_unchecked(mesh_, operation);
  edit.inverse = done.inverse;
  operations_.push_back({operation, done.inverse});
  if (operation.kind == BasicOperation::Kind::split) edit.changed[3] = mesh_.origin(QuadMesh::opposite(done.made));
  return done;
}

Applied Editor::run(const BasicOperation& operation) {
  const Applied done = perform(operation);
  if (done.refusal != Refusal::none || positions_ == nullptr) return done;
  grow_positions();
  Edit& edit = edits_.back();
  if (const VertexId removed = edit.removed_vertex(); removed.valid()) {
    const VertexId kept = edit.changed[static_cast<std::size_t>(operation.h.index() & 3)];
    if (!is_fixed(kept))
      record_placement(edit, kept, 0.5 * ((*positions_)[kept.slot()] + (*positions_)[removed.slot()]));
  } else if (edit.made_vertex().valid()) {
    place_parts(done.made, edit);
  }
  return done;
}

Applied Editor::replay(const BasicOperation& operation, const Eigen::Vector3d& made_at) {
  const Applied done = perform(operation);
  if (done.refusal != Refusal::none || positions_ == nullptr) return done;
  grow_positions();
  Edit& edit = edits_.back();
  if (const VertexId made = edit.made_vertex(); made.valid()) record_placement(edit, made, made_at);
  return done;
}

void Editor::place(VertexId v, const Eigen::Vector3d& position) {
  record_placement(edits_.emplace_back(), v, position);
}

void Editor::smooth(std::span<const VertexId> vertices, SmoothingOptions how) {
  how.fixed = [this](VertexId v) { return sectors_.is_feature(v); };
  rearrange(vertices, [&](Positions& positions) { mesh::smooth(mesh_, positions, vertices, how); });
}

void Editor::keep(Correspondence* homes) {
  // What was fitted before is a mere placement for the new correspondence.
  for (Edit& edit : edits_) edit.carries = false;
  homes_ = homes;
  followed_ = edits_.size();
}

Edit Editor::carried() {
  Edit edit;
  edit.carries = true;
  edit.homes = homes_->mark();
  edit.followed = followed_;
  for (; followed_ < edits_.size(); ++followed_) {
    const Edit& done = edits_[followed_];
    if (done.removed_face().valid()) homes_->leave(done.removed_face(), done.beside);
  }
  return edit;
}

void Editor::carry() {
  edits_.push_back(carried());
  ++followed_;
}

void Editor::fit(std::span<const VertexId> vertices, const SurfaceIndex& surface, FitOptions how) {
  how.fixed = [this](VertexId v) { return sectors_.is_feature(v); };
  Edit edit = carried();
  edit.placements = rearranged(vertices, [&](Positions& positions) {
                      mesh::fit(mesh_, positions, vertices, *homes_, surface, how);
                    }).placements;
  edits_.push_back(std::move(edit));
  ++followed_;
}

void Editor::record_placement(Edit& edit, VertexId v, const Eigen::Vector3d& to) {
  Eigen::Vector3d& now = (*positions_)[v.slot()];
  edit.placements.push_back({v, now, to});
  now = to;
}

// Each part of a split vertex moves a third of the way to the mean of the other corners of the faces it has left.
void Editor::place_parts(HalfEdgeId made, Edit& edit) {
  const VertexId v = mesh_.origin(made);
  const VertexId w = mesh_.origin(QuadMesh::opposite(made));
  const FaceId opened = QuadMesh::face(made);
  const Eigen::Vector3d before = (*positions_)[v.slot()];
  const auto target = [&](VertexId part) -> Eigen::Vector3d {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
    mesh_.for_each_out(part, [&](HalfEdgeId h) {
      if (QuadMesh::face(h) == opened) return;
      for (const VertexId corner : mesh_.corners(QuadMesh::face(h))) {
        if (corner == v || corner == w) continue;
        sum += (*positions_)[corner.slot()];
        ++count;
      }
    });
    return before + (sum / count - before) / 3;
  };
  const Eigen::Vector3d to_w = target(w);
  const Eigen::Vector3d to_v = target(v);
  record_placement(edit, w, to_w);
  if (!is_fixed(v)) record_placement(edit, v, to_v);
}

void Editor::roll_back(std::size_t mark) {
  while (edits_.size() > mark) {
    const std::vector<Placement>& placements = edits_.back().placements;
    // NOLINTNEXTLINE(modernize-loop-convert): clang 14 refuses the reversed views of GCC 12's library
    for (auto p = placements.rbegin(); p != placements.rend(); ++p) (*positions_)[p->vertex.slot()] = p->from;
    if (edits_.back().operates) {
      roll_back_last();
      for (std::size_t i = 0; i < 4; ++i) {
        if (edits_.back().fans[i].valid()) MeshSurgery(mesh_).restart(edits_.back().changed[i], edits_.back().fans[i]);
      }
    }
    if (edits_.back().carries) {
      homes_->roll_back(edits_.back().homes);
      followed_ = edits_.back().followed;
    }
    edits_.pop_back();
  }
  followed_ = std::min(followed_, edits_.size());
}

void Editor::redo(const Edit& edit) {
  const bool carries = edit.carries && homes_ != nullptr;
  if (carries) {
    carry();
  } else if (!edit.operates) {
    edits_.emplace_back();
  } else if (perform(edit.operation).refusal != Refusal::none) {
    throw std::logic_error("an edit that was rolled back cannot be made again");
  }
  grow_positions();
  for (const Placement& p : edit.placements) record_placement(edits_.back(), p.vertex, p.to);
  if (!carries) return;
  std::vector<FaceId> faces;
  for (const Placement& p : edit.placements)
    mesh_.for_each_out(p.vertex, [&](HalfEdgeId h) { faces.push_back(QuadMesh::face(h)); });
  homes_->settle(mesh_, *positions_, faces);
}

void Editor::forget() {
  OperationLog::forget();
  edits_.clear();
}

}  // namespace requad::mesh
