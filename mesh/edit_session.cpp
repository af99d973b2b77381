#include "mesh/edit_session.hpp"

#include <iostream>
#include <utility>

#include "mesh/diagnosis.hpp"
#include "mesh/obj.hpp"

namespace requad::edit {

using nlohmann::ordered_json;
using program::Options;
using program::UsageError;

const char* const kEditingHelp =
    "      Vertices are counted from 1 in the order of IN. Features (--feature-angle DEG | --features FILE) and the\n"
    "      boundary are kept to the last bit. --smooth N: iterations of smoothing round what changed (4), projected "
    "on\n"
    "      IN's surface. Exit code 1: the edit can not be made, and a line says why; then nothing is written.\n";

program::OptionTable editing_options(program::OptionTable own) {
  own.flags.emplace_back("subdivide");
  for (const char* name : {"output,o", "feature-angle", "features", "smooth"}) own.values.emplace_back(name);
  return own;
}

Session::Session(const Options& options, std::string command)
    : options_(options), command_(std::move(command)), editor_(mesh_, &features_, &positions_, &plan_) {
  if (options.words().empty()) throw UsageError(command_ + ": expected a mesh file; see --help");
  wants_features(options);
  input_ = mesh::read_surface(options.words().front(), options.has("subdivide"));
  mesh_ = input_.mesh;
  positions_ = input_.positions;
  for (const auto& [a, b] : read_features(options, input_)) features_.insert(a, b);
  plan_ = mesh::plan_by_angles(mesh_, features_, positions_);
}

const mesh::SurfaceIndex& Session::surface() {
  if (!surface_) surface_.emplace(input_.mesh, input_.positions);
  return *surface_;
}

mesh::VertexId Session::vertex(const std::string& word) const {
  const std::int64_t number = program::parse_integer(word, "a vertex");
  const auto last = static_cast<std::int64_t>(input_.from_file.size());
  if (number < 1 || number > last) {
    throw UsageError(command_ + ": there is no vertex " + word + "; expected 1.." + std::to_string(last));
  }
  const mesh::VertexId v(input_.from_file[static_cast<std::size_t>(number) - 1]);
  if (!v.valid()) throw UsageError(command_ + ": vertex " + word + " belongs to no face");
  return v;
}

int Session::number(mesh::VertexId v) const {
  int live = 1;
  for (int i = 0; i < v.index(); ++i) live += mesh_.is_live(mesh::VertexId(i)) ? 1 : 0;
  return live;
}

std::string Session::describe(mesh::VertexId v) const {
  return std::to_string(number(v)) + " (v" + std::to_string(mesh_.valence(v)) + ")";
}

void Session::smooth_since(std::size_t mark) {
  constexpr int kRings = 2;
  mesh::SmoothingOptions how;
  how.iterations = static_cast<int>(options_.integer("smooth", 4, 0, 100'000));
  if (how.iterations == 0) return;
  how.project_to = &surface();
  const mesh::Footprint footprint = mesh::footprint_since(editor_, surroundings_, mark, kRings);
  mesh::smooth_edit(editor_, footprint.near, how);
}

int Session::done(ordered_json summary, const std::string& text) {
  const std::string output = output_path(options_, command_);
  mesh::save_obj(output, mesh_, positions_);
  const auto sizes = [](const mesh::Diagnosis& d) {
    return ordered_json{{"vertices", d.vertices},
                        {"faces", d.faces},
                        {"interior_irregular", d.interior_irregular},
                        {"inverted", d.inverted},
                        {"scaled_jacobian", {{"least", d.scaled_jacobian.least}, {"mean", d.scaled_jacobian.mean}}}};
  };
  summary["before"] = sizes(mesh::diagnose(input_.mesh, input_.positions));
  summary["after"] = sizes(mesh::diagnose(mesh_, positions_));
  program::finish(options_, summary.dump(), text);
  return program::kDone;
}

int Session::refused(const std::string& wish, mesh::Refusal why, const mesh::Obstacles& obstacles) {
  const std::string met = why == mesh::Refusal::no_way ? to_string(obstacles) : "";
  std::cerr << "requad-edit: " << command_ << ": " << wish << ": " << mesh::explain(why)
            << (met.empty() ? "" : "; in the way: " + met) << '\n';
  return program::kCheckFailed;
}

}  // namespace requad::edit
