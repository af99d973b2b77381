// Steps of a session: those that undo and redo, and those that need no offer.
#include <algorithm>

#include "mesh/editing/script.hpp"
#include "mesh/geometry/fitting.hpp"
#include "mesh/topology/id_lists.hpp"
#include "mesh/web/session.hpp"

namespace requad::web {

using mesh::Edit;

// --- steps -----------------------------------------------------------------------------------------------------------

Session::Touched Session::touched_by(const Step& step) const {
  Touched touched;
  for (std::size_t i = step.begin; i < step.end; ++i) {
    const Edit& edit = editor_.edits()[i];
    for (const VertexId v : edit.changed) {
      if (v.valid()) touched.vertices.push_back(v);
    }
    for (const mesh::Placement& p : edit.placements) touched.vertices.push_back(p.vertex);
    for (const FaceId f : {edit.made_face(), edit.removed_face()}) {
      if (f.valid()) touched.quads.push_back(f);
    }
  }
  mesh::sort_once(touched.vertices);
  add_round(touched);
  return touched;
}

void Session::add_round(Touched& touched) const {
  const std::vector<FaceId> round = mesh::faces_round(mesh_, touched.vertices);
  touched.quads.insert(touched.quads.end(), round.begin(), round.end());
  mesh::sort_once(touched.quads);
}

void Session::note_changes(const Touched& touched) {
  const auto& [vertices, quads] = touched;
  for (const VertexId v : vertices) {
    if (mesh_.is_live(v) && mesh::is_irregular(mesh_, v)) {
      irregular_.insert(v);
    } else {
      irregular_.erase(v);
    }
  }
  for (const FaceId f : quads) {
    if (mesh_.is_live(f) && is_inverted(f)) {
      inverted_.insert(f);
    } else {
      inverted_.erase(f);
    }
  }
  numbers_.clear();
  offered_to_.reset();
  if (changes_.everything) return;
  changes_.vertices.insert(changes_.vertices.end(), vertices.begin(), vertices.end());
  changes_.quads.insert(changes_.quads.end(), quads.begin(), quads.end());
  mesh::sort_once(changes_.vertices);
  mesh::sort_once(changes_.quads);
}

void Session::finish_step(Step step) {
  step.end = editor_.mark();
  steps_.push_back(std::move(step));
  undone_steps_.clear();
  undone_edits_.clear();
  note_changes(touched_by(steps_.back()));
}

bool Session::undo() {
  if (steps_.empty()) return false;
  reduction_.reset();
  const Step step = steps_.back();
  Touched touched = touched_by(step);
  const auto first = editor_.edits().begin() + static_cast<std::ptrdiff_t>(step.begin);
  undone_edits_.emplace_back(first, editor_.edits().end());
  editor_.roll_back(step.begin);
  undone_steps_.push_back(step);
  steps_.pop_back();
  take_features(step.before);
  add_round(touched);
  note_changes(touched);
  return true;
}

bool Session::redo() {
  if (undone_steps_.empty()) return false;
  reduction_.reset();
  const Step step = undone_steps_.back();
  for (const Edit& edit : undone_edits_.back()) editor_.redo(edit);
  undone_steps_.pop_back();
  undone_edits_.pop_back();
  steps_.push_back(step);
  take_features(step.after);
  note_changes(touched_by(step));
  return true;
}

std::vector<std::string> Session::lines(const Step& step) const {
  std::vector<std::string> lines;
  for (std::size_t i = step.begin; i < step.end; ++i) {
    const Edit& edit = editor_.edits()[i];
    if (edit.operates) lines.push_back(to_string(edit.operation));
  }
  return lines;
}

// --- steps that need no offer ----------------------------------------------------------------------------------------

std::string Session::smooth(std::span<const VertexId> centres, int rings) {
  std::vector<VertexId> vertices = mesh_.vertices();
  if (!centres.empty()) {
    const auto always = [](VertexId) { return true; };
    distances_.measure(mesh_, centres, always, always, [rings](VertexId, int distance) { return distance > rings; });
    vertices = distances_.met();
    std::erase_if(vertices, [&](VertexId v) { return distances_.distance(v) > rings; });
  }
  mesh::FitOptions how;
  how.quality = mesh::kGoodQuads;
  how.tolerance = mesh::kUsualTolerance * mesh::bounding_box_diagonal(mesh_, positions_);
  Step step{(centres.empty() ? "smooth all" : "smooth round " + name_of(centres.front())), editor_.mark(), 0};
  const std::vector<FaceId> faces = mesh::faces_round(mesh_, vertices);
  const auto was = std::count_if(faces.begin(), faces.end(), [this](FaceId f) { return is_inverted(f); });
  editor_.fit(vertices, shape_.surface(), how);
  const auto edits = std::span(editor_.edits()).subspan(step.begin);
  const bool moves = std::any_of(edits.begin(), edits.end(), [](const Edit& e) { return !e.placements.empty(); });
  const auto inverted = std::count_if(faces.begin(), faces.end(), [this](FaceId f) { return is_inverted(f); });
  if (!moves || inverted > was) {
    editor_.roll_back(step.begin);
    return moves ? "more quads would be inverted" : "nothing moves: all these vertices are fixed";
  }
  reduction_.reset();
  finish_step(std::move(step));
  return "";
}

void Session::take_features(const std::shared_ptr<const Features>& features) {
  if (!features) return;
  features_ = *features;
  changes_.features = true;
}

std::string Session::change_features(mesh::FeatureSet edges, std::string words) {
  auto after = std::make_shared<Features>();
  after->edges = std::move(edges);
  after->plan = mesh::plan_by_angles(mesh_, after->edges, positions_);
  Step step{std::move(words), editor_.mark(), 0, std::make_shared<Features>(features_), std::move(after)};
  take_features(step.after);
  reduction_.reset();
  finish_step(std::move(step));
  return "";
}

std::string Session::set_features(const mesh::FeatureEdges& edges) {
  if (edges == features()) return "these are the features already";
  mesh::FeatureSet set;
  for (const auto& [a, b] : edges) set.insert(a, b);
  return change_features(std::move(set),
                         edges.empty() ? "no features" : std::to_string(edges.size()) + " feature edges");
}

std::string Session::apply(std::string_view text, const std::string& name) {
  if (!steps_.empty()) return "a script starts from the mesh as it was opened; undo all steps first";
  const mesh::Script script = mesh::parse_script(text, name);
  Step step{"script " + name, editor_.mark(), 0};
  const mesh::Replay replay = mesh::replay(editor_, script);
  if (replay.refusal != mesh::Refusal::none)
    return name + ":" + std::to_string(replay.line) + ": " + std::string(replay.refusal.clause());
  reduction_.reset();
  finish_step(std::move(step));
  return "";
}

}  // namespace requad::web
