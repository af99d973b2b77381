#include "mesh/commands/session.hpp"

#include <iostream>
#include <utility>

#include "mesh/editing/element_map.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/diagnosis.hpp"

namespace requad::edit {

using nlohmann::ordered_json;
using program::Options;
using program::UsageError;

const std::string kLookingHelp =
    "      Vertices are counted from 1 in the order of IN. Features (--feature-angle DEG | --features FILE) and the\n"
    "      boundary are kept to the last bit.\n";
const std::string kEditingHelp =
    kLookingHelp +
    "      --smooth N: iterations of smoothing round what changed (4), projected on IN's surface. --script FILE: the\n"
    "      edits as text, for `apply`. --map FILE: where each vertex and face is now (see `apply --help`).\n"
    "      Exit code 1: the edit can not be made, and a line says why; then nothing is written.\n";

program::OptionTable looking_options() { return {{"subdivide"}, {"feature-angle", "features"}, {}}; }

program::OptionTable editing_options(program::OptionTable own) {
  own.flags.emplace_back("subdivide");
  for (const char* name : {"feature-angle", "features", "smooth"}) own.values.emplace_back(name);
  for (const char* name : {"output,o", "script", "map"}) own.outputs.emplace_back(name);
  return own;
}

namespace {

mesh::Surface read_first(const Options& options, const std::string& command) {
  if (options.words().empty()) throw UsageError(command + ": expected a mesh file; see --help");
  wants_features(options);
  return mesh::read_surface(options.words().front(), options.has("subdivide"));
}

// In the numbers of the files, from 1.
std::string map_text(const mesh::Surface& input, const mesh::Editor& editor) {
  const mesh::ElementMap map = mesh::element_map(input.mesh, editor);
  const auto number = [](int place) { return place < 0 ? ordered_json() : ordered_json(place + 1); };
  const auto numbers = [&number](const std::vector<int>& places) {
    ordered_json list = ordered_json::array();
    for (const int place : places) list.push_back(number(place));
    return list;
  };
  ordered_json vertices = ordered_json::array(), faces = ordered_json::array();
  for (const int v : input.from_file)
    vertices.push_back(v < 0 ? ordered_json() : number(map.vertices.now[static_cast<std::size_t>(v)]));
  for (const mesh::FaceId f : input.mesh.faces()) faces.push_back(number(map.faces.now[f.slot()]));
  std::vector<int> vertices_from;
  for (const int v : map.vertices.made_from) vertices_from.push_back(input.file_vertex[static_cast<std::size_t>(v)]);
  return ordered_json{{"vertices", vertices},
                      {"faces", faces},
                      {"new_vertices", numbers(map.vertices.made)},
                      {"new_vertices_from", numbers(vertices_from)},
                      {"new_faces", numbers(map.faces.made)},
                      {"new_faces_from", numbers(map.faces.made_from)}}
             .dump() +
         "\n";
}

}  // namespace

Session::Session(const Options& options, const std::string& command)
    : Session(options, command, read_first(options, command)) {}

Session::Session(const Options& options, std::string command, mesh::Surface input)
    : options_(options),
      command_(std::move(command)),
      input_(std::move(input)),
      editor_(mesh_, &features_, &positions_, &plan_) {
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
  const mesh::AffectedRegion affected = mesh::affected_region_since(editor_, distances_, mark, kRings);
  editor_.smooth(affected.near, how);
}

int Session::done(ordered_json summary, const std::string& text) {
  const std::string output = output_path(options_, command_);
  program::Outputs outputs;
  if (options_.has("script"))
    outputs.add(options_.text("script"), mesh::to_string(mesh::record_script(input_.mesh, input_.positions, editor_)));
  if (options_.has("map")) outputs.add(options_.text("map"), map_text(input_, editor_));
  outputs.add(output, mesh::obj_text(mesh_, positions_));
  const auto sizes = [](const mesh::Diagnosis& d) {
    return ordered_json{{"vertices", d.vertices},
                        {"faces", d.faces},
                        {"interior_irregular", d.interior_irregular},
                        {"inverted", d.inverted},
                        {"scaled_jacobian", {{"least", d.scaled_jacobian.least}, {"mean", d.scaled_jacobian.mean}}}};
  };
  summary["before"] = sizes(mesh::diagnose(input_.mesh, input_.positions));
  summary["after"] = sizes(mesh::diagnose(mesh_, positions_));
  const bool taken = options_.on_stdout("script") || options_.on_stdout("map");
  program::finish(options_, summary.dump(), taken ? "" : text, std::move(outputs));
  return program::kDone;
}

int Session::refused(const std::string& wish, mesh::Refusal why, const mesh::Obstacles& obstacles) {
  const std::string met = why == mesh::EditRefusal::no_path ? to_string(obstacles) : "";
  std::cerr << "requad-edit: " << command_ << ": " << program::one_line(wish) << ": " << why.clause()
            << (met.empty() ? "" : "; in the way: " + met) << '\n';
  return program::kCheckFailed;
}

}  // namespace requad::edit
