#include "mesh/commands/session.hpp"

#include <iostream>
#include <utility>

#include "mesh/commands/quality.hpp"
#include "mesh/editing/carried_attributes.hpp"
#include "mesh/editing/element_map.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/diagnosis.hpp"

namespace requad::edit {

using nlohmann::ordered_json;
using program::Options;
using program::UsageError;

std::vector<program::Option> editing_options(std::vector<program::Option> own) {
  std::vector<program::Option> all = std::move(own);
  for (program::Option& option : std::vector<program::Option>{
           output_option(),
           program::output("script", "FILE", "write the edits as text, for `requad-edit apply`"),
           program::output("map", "FILE",
                           "write where each vertex and face is now, as JSON; see `requad-edit apply --help`",
                           {{"json", {"json"}}}),
           program::value("boundary", "angle|fixed|free",
                          "how many quads a boundary vertex should have (default angle); with another number\n"
                          "it counts as irregular\n"
                          "  angle  one for each 90 degrees, rounded\n"
                          "  fixed  as many as in IN\n"
                          "  free   any number"),
           program::value("smooth", "N",
                          "fit what lies round the changes to the surface of IN, N times (default 4; reduce:\n3); 0 "
                          "leaves vertices where the operations place them"),
       })
    all.push_back(std::move(option));
  for (program::Option& option : input_and_seam_options()) all.push_back(std::move(option));
  return all;
}

program::Option allow_inverted_option() {
  return program::flag("allow-inverted", "edit even if more quads are inverted then");
}

namespace {

mesh::BoundaryPlan boundary_plan(const Options& options) {
  const std::string word = options.choice("boundary", {"angle", "fixed", "free"}, "angle");
  return word == "free"    ? mesh::BoundaryPlan::free
         : word == "fixed" ? mesh::BoundaryPlan::fixed
                           : mesh::BoundaryPlan::angle;
}

// The text of the map that --map asks for. Elements have their numbers in the files, counted from 1.
std::string map_text(const mesh::Surface& input, const mesh::Editor& editor) {
  const mesh::ElementMap map = mesh::element_map(input.mesh, editor);
  const auto number = [](int index) { return index < 0 ? ordered_json() : ordered_json(index + 1); };
  const auto numbers = [&number](const std::vector<int>& indices) {
    ordered_json list = ordered_json::array();
    for (const int index : indices) list.push_back(number(index));
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
    : Session(options, command, read_input(options), true) {}

Session::Session(const Options& options, std::string command, mesh::Surface input, bool seams)
    : options_(options),
      command_(std::move(command)),
      input_(std::move(input)),
      editor_(mesh_, &features_, &positions_, &plan_) {
  mesh_ = input_.mesh;
  positions_ = input_.positions;
  for (const auto& [a, b] : read_features(options, input_)) features_.insert(a, b);
  if (seams) {
    const mesh::FeatureEdges edges = mesh::texture_seams(input_);
    if (keeps_seams(options, input_, edges)) {
      for (const auto& [a, b] : edges) features_.insert(a, b);
    }
  }
  plan_ = mesh::plan_by_angles(mesh_, features_, positions_, boundary_plan(options));
}

mesh::VertexId Session::vertex(const std::string& word) const {
  const std::int64_t number = program::parse_integer(word, "a vertex");
  const auto last = static_cast<std::int64_t>(input_.from_file.size());
  if (number < 1 || number > last) {
    throw UsageError(command_ + ": there is no vertex " + word + "; expected 1.." + std::to_string(last) +
                     ", for vertices are counted from 1");
  }
  const mesh::VertexId v(input_.from_file[static_cast<std::size_t>(number) - 1]);
  if (!v.valid()) throw UsageError(command_ + ": vertex " + word + " belongs to no face");
  return v;
}

int Session::number(mesh::VertexId v) const { return mesh::file_number(mesh_, v); }

std::string Session::describe(mesh::VertexId v) const {
  return std::to_string(number(v)) + " (v" + std::to_string(mesh_.valence(v)) + ")";
}

std::string Session::describe(mesh::VertexId a, mesh::VertexId b) const { return describe(a) + " and " + describe(b); }

std::size_t Session::begin() {
  if (rounds() > 0) shape_.emplace(editor_);
  return editor_.mark();
}

int Session::rounds() const {
  return static_cast<int>(options_.integer("smooth", mesh::ShapeKeeper::kUsualRounds, 0, 100'000));
}

void Session::fit_transport(std::size_t mark) {
  if (shape_) shape_->fit_transport(mark);
}

void Session::fit_since(std::size_t mark) {
  if (shape_) shape_->fit_since(mark, rounds());
}

bool Session::is_worse(const std::string& subject) const {
  const int before = mesh::count_inverted(input_.mesh, input_.positions),
            after = mesh::count_inverted(mesh_, positions_);
  if (options_.has("allow-inverted") || after <= before) return false;
  std::cerr << "requad-edit: " << command_ << ": " << program::one_line(subject) << ": " << counted(after, "quad")
            << " would be inverted, " << before << " before; --allow-inverted does it nevertheless\n";
  return true;
}

int Session::done(ordered_json summary, const std::string& text) {
  const std::string output = output_path(options_, command_);
  program::Outputs outputs;
  if (options_.has("script"))
    outputs.add(options_.text("script"), mesh::to_string(mesh::record_script(input_.mesh, input_.positions, editor_)));
  if (options_.has("map")) outputs.add(options_.text("map"), map_text(input_, editor_));
  const mesh::Attributes attributes = mesh::carried_attributes(input_, editor_);
  outputs.add(output, mesh::obj_text(mesh_, positions_, attributes));
  const Quality quality = compare(input_, mesh_, positions_);
  add(summary, quality);
  const bool taken = options_.on_stdout("script") || options_.on_stdout("map");
  if (!attributes.not_kept.empty()) summary["not_kept"] = attributes.not_kept;
  program::finish(options_, summary.dump(), taken ? "" : text + to_string(quality) + not_kept_line(attributes),
                  std::move(outputs));
  report_left_out(options_, input_);
  return program::kDone;
}

int Session::refused(const std::string& subject, mesh::Refusal why, const mesh::Obstacles& obstacles) {
  const std::string met = why == mesh::EditRefusal::no_path ? to_string(obstacles) : "";
  std::cerr << "requad-edit: " << command_ << ": " << program::one_line(subject) << ": " << why.clause()
            << (met.empty() ? "" : "; in the way: " + met) << '\n';
  return program::kCheckFailed;
}

}  // namespace requad::edit
