// The reduction of a session: it runs on a copy of the mesh, and each cancellation is taken over as a step.
#include "mesh/web/session.hpp"

namespace requad::web {

// The copy has the ids of the session's mesh, free ones too. So its edits can be made again on the session's mesh.
struct Session::Reduction {
  Reduction(const Session& session, int until, double deviation)
      : mesh(session.mesh_),
        positions(session.positions_),
        features(session.features_),
        editor(mesh, &features.edges, &positions, &features.plan) {
    options.until = until;
    options.max_deviation = deviation < 0 ? -1 : deviation * mesh::bounding_box_diagonal(mesh, positions);
    work.emplace(editor, options);
  }

  mesh::QuadMesh mesh;
  mesh::Positions positions;
  Features features;
  mesh::Editor editor;
  mesh::ReduceOptions options;
  std::optional<mesh::Reduction> work;
  std::vector<std::size_t> ends;  // the editor's marks after the steps that were taken over
};

void Session::start_reduction(int until, double deviation) {
  reduction_ = std::make_shared<Reduction>(*this, until, deviation);
}

void Session::take_over(const Reduction& reduction, std::string words) {
  const std::vector<mesh::Edit>& edits = reduction.editor.edits();
  Step step{std::move(words), editor_.mark(), 0};
  for (std::size_t i = reduction.ends.empty() ? 0 : reduction.ends.back(); i < edits.size(); ++i)
    editor_.redo(edits[i]);
  if (editor_.mark() != step.begin) finish_step(std::move(step));
}

Session::Slice Session::reduce() {
  const Slice slice = reduction_->work->advance();
  if (slice != Slice::cancelled) return slice;
  take_over(*reduction_, "reduce to " + std::to_string(reduction_->work->irregular()));
  reduction_->ends.push_back(reduction_->editor.mark());
  return slice;
}

void Session::finish_reduction() {
  const std::shared_ptr<Reduction> reduction = std::move(reduction_);
  const mesh::ReduceReport report = reduction->work->finish();
  for (; reduction->ends.size() > static_cast<std::size_t>(report.cancelled); reduction->ends.pop_back()) {
    undo();
    undone_steps_.clear();
    undone_edits_.clear();
  }
  take_over(*reduction, "fit what was reduced");
}

}  // namespace requad::web
