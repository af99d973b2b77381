#include "mesh/commands/command.hpp"

namespace requad::edit {

using program::Options;
using program::UsageError;

mesh::Surface read_input(const Options& options, const std::string& command) {
  const std::vector<std::string>& words = options.words();
  if (words.size() != 1) {
    throw UsageError(command + ": expected one mesh file, not " + std::to_string(words.size()) + "; see --help");
  }
  return mesh::read_surface(words.front(), options.has("subdivide"));
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
    throw UsageError(path + ": OBJ is what is written; expected a name that ends in .obj");
  return path;
}

std::string counted(int count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace requad::edit
