// requad-edit info: describes a mesh.

#include <array>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "mesh/commands/arguments.hpp"
#include "mesh/commands/commands.hpp"
#include "mesh/files/welding.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::edit {

namespace {

using mesh::Diagnosis;
using nlohmann::ordered_json;
using program::Options;

ordered_json to_json(const std::map<int, int>& counts) {
  ordered_json json = ordered_json::object();
  for (const auto& [key, count] : counts) json[std::to_string(key)] = count;
  return json;
}

// JSON has no infinite numbers; the library writes null for them.
ordered_json to_json(const Diagnosis::Statistics& s) {
  return {{"least", s.least}, {"mean", s.mean}, {"greatest", s.greatest}};
}

std::string to_text(const std::map<int, int>& counts, const char* prefix) {
  std::string text;
  for (const auto& [key, count] : counts) text += " " + (prefix + std::to_string(key)) + ":" + std::to_string(count);
  return text.empty() ? " none" : text;
}

std::string to_text(const Diagnosis::Statistics& s) {
  const auto number = [](double value) {
    std::array<char, 32> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.4g", value);
    return std::string(buffer.data());
  };
  return number(s.least) + " to " + number(s.greatest) + ", mean " + number(s.mean);
}

int info(const Options& options) {
  const bool features = wants_features(options);
  const mesh::Surface surface = read_input(options);
  const Diagnosis d = mesh::diagnose(surface.mesh, surface.positions);
  const mesh::FeatureEdges edges = read_features(options, surface);
  const auto corners = static_cast<int>(mesh::feature_corners(surface.mesh, edges).size());

  const int coincident = mesh::coincident_vertices(surface.positions);
  ordered_json json{{"vertices", d.vertices},
                    {"edges", d.edges},
                    {"faces", d.faces},
                    {"unused_vertices", surface.dropped},
                    {"coincident_vertices", coincident},
                    {"components", d.components},
                    {"boundary_loops", d.boundary_loops},
                    {"genus", d.genus},
                    {"euler_characteristic", d.euler_characteristic},
                    {"valences", to_json(d.valences)},
                    {"interior_irregular", d.interior_irregular},
                    {"doublets", d.doublets},
                    {"boundary_turns", to_json(d.turns)},
                    {"boundary_irregular", d.boundary_irregular},
                    {"degenerate", d.degenerate},
                    {"inverted", d.inverted},
                    {"scaled_jacobian", to_json(d.scaled_jacobian)},
                    {"aspect_ratio", to_json(d.aspect_ratio)},
                    {"edge_length", to_json(d.edge_length)},
                    {"bounding_box_diagonal", d.bounding_box_diagonal}};
  json["feature_edges"] = features ? ordered_json(edges.size()) : ordered_json(nullptr);
  json["feature_corners"] = features ? ordered_json(corners) : ordered_json(nullptr);

  std::string text = counted(d.vertices, "vertex", "vertices") + ", " + counted(d.edges, "edge", "edges") + ", " +
                     counted(d.faces, "face", "faces") + "\n" + counted(d.components, "component", "components") +
                     ", genus " + std::to_string(d.genus) + ", " +
                     counted(d.boundary_loops, "boundary loop", "boundary loops") + ", Euler characteristic " +
                     std::to_string(d.euler_characteristic) + "\n";
  if (surface.dropped > 0) text += counted(surface.dropped, "vertex", "vertices") + " in no face, left out\n";
  if (coincident > 0) {
    text +=
        counted(coincident, "vertex coincides with another", "vertices coincide with others") + ": --weld joins them\n";
  }
  text += "interior valences:" + to_text(d.valences, "v") + "; " + std::to_string(d.interior_irregular) +
          " irregular, " + counted(d.doublets, "doublet", "doublets") + "\n";
  if (d.boundary_loops > 0) {
    text += "boundary turns:" + to_text(d.turns, "") + "; " + std::to_string(d.boundary_irregular) + " not straight\n";
  }
  text += "scaled Jacobian " + to_text(d.scaled_jacobian) + "; " + std::to_string(d.inverted) + " inverted, " +
          std::to_string(d.degenerate) + " without area\n" + "aspect ratio " + to_text(d.aspect_ratio) +
          "\nedge length " + to_text(d.edge_length) + "\n";
  if (features) {
    text += counted(static_cast<int>(edges.size()), "feature edge", "feature edges") + ", " +
            counted(corners, "corner", "corners") + "\n";
  }
  if (options.has("list")) {
    json["irregular"] = ordered_json::array();
    text += "irregular vertices, by their numbers in the file:";
    for (const mesh::VertexId v : mesh::irregular_vertices(surface.mesh)) {
      const int number = surface.file_vertex[v.slot()] + 1;
      const int valence = surface.mesh.valence(v);
      json["irregular"].push_back({{"vertex", number}, {"valence", valence}});
      text += " " + std::to_string(number) + " (v" + std::to_string(valence) + ")";
    }
    text += "\n";
  }
  program::finish(options, json.dump(), text);
  return program::kDone;
}

}  // namespace

program::Command info_command() {
  std::vector<program::Option> options{
      program::flag("list", "list the irregular vertices inside the mesh by their numbers in IN")};
  for (program::Option& option : input_options()) options.push_back(std::move(option));
  return {
      .name = "info",
      .usage = {"IN"},
      .summary = "describes a mesh: size, topology, irregular vertices, quality of the quads",
      .text = R"(Valences are those of vertices inside the mesh. A boundary vertex with q quads
has turn 2 - q. The genus of several components is their sum. Features are
counted if one of the options names them.
)",
      .examples = {"requad-edit info mesh/examples/figure-17.obj",
                   "requad-edit info mesh/examples/figure-17.obj --feature-angle 40 --list --json -"},
      .options = std::move(options),
      .words = {1, 1},
      .files = {0},
      .run = info,
  };
}

}  // namespace requad::edit
