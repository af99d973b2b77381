#include "mesh/commands/arguments.hpp"

#include <iostream>

#include "mesh/program/program.hpp"
#include "mesh/threads/threads.hpp"

namespace requad::edit {

using program::Options;
using program::UsageError;

std::vector<program::Option> input_options() {
  return {
      program::not_with(program::value("feature-angle", "DEG",
                                       "edges whose faces' normals differ by DEG degrees or more are features"),
                        {"features"}),
      program::input("features", "FILE",
                     "the edges that FILE lists are features: two vertices on each line, or the `l` lines of an OBJ "
                     "file; vertices are counted from 1"),
      program::flag("subdivide", "cut each polygon of IN with n sides into n quads first"),
      program::flag("weld", "join vertices of IN that are at the same place"),
  };
}

std::vector<program::Option> seam_options() {
  return {
      program::not_with(
          program::flag(
              "keep-seams",
              "seams of texture coordinates are features (the default, unless each face has a texture for itself)"),
          {"no-keep-seams"}),
      program::flag("no-keep-seams", "they are not: texture coordinates of what changes near them are guessed"),
  };
}

std::vector<program::Option> input_and_seam_options() {
  std::vector<program::Option> all = input_options();
  for (program::Option& option : seam_options()) all.push_back(std::move(option));
  return all;
}

bool keeps_seams(const Options& options, const mesh::Surface& surface, const mesh::FeatureEdges& seams) {
  for (const std::string option : {"keep-seams", "no-keep-seams"}) {
    if (options.has(option) && seams.empty())
      throw UsageError("--" + option + ": IN has no seams of texture coordinates");
  }
  return options.has("keep-seams") || (!options.has("no-keep-seams") && !mesh::has_texture_by_faces(surface, seams));
}

std::string not_kept_line(const mesh::Attributes& attributes) {
  const std::string words = mesh::not_kept_text(attributes);
  return words.empty() ? "" : "not kept: " + words + "\n";
}

program::Option output_option() {
  return program::output("output,o", "OUT", "the OBJ file to write, or -", {{"obj", {"obj"}}});
}

mesh::Surface read_input(const Options& options) {
  return mesh::read_surface(options.words().front(), options.has("subdivide"), options.has("weld"));
}

bool wants_features(const Options& options) { return options.has("feature-angle") || options.has("features"); }

mesh::FeatureEdges read_features(const Options& options, const mesh::Surface& surface) {
  if (!wants_features(options)) return {};
  if (options.has("features")) return mesh::read_feature_edges(options.text("features"), surface);
  return mesh::sharp_edges(surface.mesh, surface.positions, options.number("feature-angle", 0, 0, 180));
}

std::string output_path(const Options& options, const std::string& command) {
  if (!options.has("output"))
    throw UsageError(command + ": -o is missing; expected a file to write, or - for standard output");
  return options.text("output");
}

mesh::RunTasks tasks(const Options& options) {
  const int threads = options.threads();
  if (threads::thread_count(threads) == 1) return {};
  return [threads](std::size_t count, const std::function<void(std::size_t)>& task) {
    threads::run_on_threads(count, threads, task);
  };
}

void report_left_out(const Options& options, const mesh::Surface& surface) {
  if (surface.dropped == 0) return;
  std::cerr << "requad-edit: " << program::one_line(options.words().front()) << ": "
            << counted(surface.dropped, "vertex", "vertices") << " in no face, left out\n";
}

}  // namespace requad::edit
