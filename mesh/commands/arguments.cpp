#include "mesh/commands/arguments.hpp"

namespace requad::edit {

using program::Options;
using program::UsageError;

std::vector<program::Option> input_options() {
  return {
      program::value("feature-angle", "DEG", "edges whose faces' normals differ by DEG degrees or more are features"),
      program::value("features", "FILE",
                     "the edges that FILE lists are features: two vertices on each line, or the `l` lines of an OBJ "
                     "file; vertices are counted from 1"),
      program::flag("subdivide", "cut each polygon of IN with n sides into n quads first"),
  };
}

program::Option output_option() { return program::output("output,o", "OUT", "the OBJ file to write, or -"); }

mesh::Surface read_input(const Options& options) {
  return mesh::read_surface(options.words().front(), options.has("subdivide"));
}

bool wants_features(const Options& options) {
  if (options.has("feature-angle") && options.has("features")) {
    throw UsageError("features come from --feature-angle or --features, not from both");
  }
  return options.has("feature-angle") || options.has("features");
}

mesh::FeatureEdges read_features(const Options& options, const mesh::Surface& surface) {
  if (!wants_features(options)) return {};
  if (options.has("features")) return mesh::read_feature_edges(options.text("features"), surface);
  return mesh::sharp_edges(surface.mesh, surface.positions, options.number("feature-angle", 0, 0, 180));
}

std::string output_path(const Options& options, const std::string& command) {
  if (!options.has("output"))
    throw UsageError(command + ": -o is missing; expected a file to write, or - for standard output");
  std::string path = options.text("output");
  if (path.ends_with(".off") || path.ends_with(".OFF"))
    throw UsageError(path + ": only OBJ can be written; expected a name that ends in .obj");
  return path;
}

std::string counted(int count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace requad::edit
