#include "mesh/editor.hpp"

#include <utility>

namespace requad::mesh {

Editor::Editor(QuadMesh& mesh, const FeatureSet* features, Positions* positions, const SectorPlan* plan)
    : mesh_(mesh), features_(features), positions_(positions), sectors_(mesh, features, plan) {
  if (positions_ != nullptr)
    positions_->resize(static_cast<std::size_t>(mesh_.vertex_capacity()), Eigen::Vector3d::Zero());
}

Refusal Editor::why_not(const BasicOperation& operation) const {
  const Refusal refusal = mesh::why_not(mesh_, operation);
  if (refusal != Refusal::none || features_ == nullptr) return refusal;
  return features_->why_not(mesh_, operation);
}

Applied Editor::run(const BasicOperation& operation) {
  Applied done;
  done.refusal = why_not(operation);
  if (done.refusal != Refusal::none) return done;
  const bool collapses = operation.kind == BasicOperation::Kind::collapse;
  const VertexId removed = collapses ? mesh_.origin(QuadMesh::opposite(operation.h)) : VertexId();
  const VertexId kept = mesh_.origin(operation.h);
  std::array<VertexId, 4> changed = changed_vertices(mesh_, operation);
  done = apply(mesh_, operation);
  if (operation.kind == BasicOperation::Kind::split) changed[3] = mesh_.origin(QuadMesh::opposite(done.made));
  Edit edit{true, operation, done.inverse, changed, {}};
  if (positions_ != nullptr) {
    positions_->resize(static_cast<std::size_t>(mesh_.vertex_capacity()), Eigen::Vector3d::Zero());
    if (collapses && !is_fixed(kept)) {
      record_placement(edit, kept, 0.5 * ((*positions_)[kept.slot()] + (*positions_)[removed.slot()]));
    } else if (operation.kind == BasicOperation::Kind::split) {
      place_parts(done.made, edit);
    }
  }
  edits_.push_back(std::move(edit));
  return done;
}

void Editor::place(VertexId v, const Eigen::Vector3d& position) {
  Edit edit;
  record_placement(edit, v, position);
  edits_.push_back(std::move(edit));
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
    const Edit& edit = edits_.back();
    for (auto p = edit.placements.rbegin(); p != edit.placements.rend(); ++p) (*positions_)[p->vertex.slot()] = p->from;
    if (edit.operates) apply(mesh_, edit.inverse);
    edits_.pop_back();
  }
}

}  // namespace requad::mesh
