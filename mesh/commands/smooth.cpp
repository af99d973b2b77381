// requad-edit smooth: moves vertices and changes no connectivity.

#include <array>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "mesh/commands/arguments.hpp"
#include "mesh/commands/commands.hpp"
#include "mesh/editing/carried_attributes.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/geometry/nearest_points.hpp"
#include "mesh/geometry/smoothing.hpp"
#include "mesh/program/progress.hpp"

namespace requad::edit {

namespace {

using mesh::Diagnosis;
using nlohmann::ordered_json;
using program::Options;

int smooth(const Options& options) {
  const std::string output = output_path(options, "smooth");
  mesh::SmoothingOptions how;
  const auto iterations = static_cast<int>(options.integer("iterations", 10, 0, 1'000'000));
  how.iterations = 1;  // one at a time, so that progress can be shown
  if (options.has("no-guard")) how.guard.reset();
  how.weights = options.choice("weights", {"uniform", "chord"}, "uniform") == "chord" ? mesh::SmoothingWeights::chord
                                                                                      : mesh::SmoothingWeights::uniform;
  how.pull_distance = options.number("pull", 0, 0, std::numeric_limits<double>::max());

  const mesh::Surface surface = read_input(options);
  const mesh::FeatureEdges features = read_features(options, surface);
  std::vector<bool> fixed(surface.positions.size(), false);
  for (const auto& edge : features) {
    for (const mesh::VertexId v : edge) fixed[v.slot()] = true;
  }
  const mesh::FeatureEdges seams = mesh::texture_seams(surface);
  if (keeps_seams(options, surface, seams)) {
    for (const auto& edge : seams) {
      for (const mesh::VertexId v : edge) fixed[v.slot()] = true;
    }
  }
  how.fixed = [&fixed](mesh::VertexId v) { return fixed[v.slot()]; };
  std::optional<mesh::SurfaceIndex> original;
  std::optional<mesh::PointIndex> original_vertices;
  if (options.has("project")) how.project_to = &original.emplace(surface.mesh, surface.positions);
  if (options.has("pull")) how.pull_to = &original_vertices.emplace(surface.positions);

  mesh::QuadMesh same = surface.mesh;
  mesh::Positions positions = surface.positions;
  mesh::Editor editor(same, nullptr, &positions);
  const std::vector<mesh::VertexId> vertices = surface.mesh.vertices();
  program::Progress progress("iterations", iterations, options.quiet());
  editor.rearrange(vertices, [&](mesh::Positions& moving) {
    for (int i = 0; i < iterations; ++i) {
      mesh::smooth(surface.mesh, moving, vertices, how);
      progress.advance();
    }
  });
  progress.finish();
  program::Outputs outputs;
  if (options.has("script"))
    outputs.add(options.text("script"), mesh::to_string(mesh::record_script(surface.mesh, surface.positions, editor)));
  const mesh::Attributes attributes = mesh::carried_attributes(surface, editor);
  outputs.add(output, mesh::obj_text(surface.mesh, positions, attributes));

  int moved = 0;
  double farthest = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double distance = (positions[v] - surface.positions[v]).norm();
    farthest = std::max(farthest, distance);
    moved += distance > 0 ? 1 : 0;
  }
  const Diagnosis before = mesh::diagnose(surface.mesh, surface.positions),
                  after = mesh::diagnose(surface.mesh, positions);
  const auto quality = [](const Diagnosis& d) {
    return ordered_json{{"inverted", d.inverted},
                        {"scaled_jacobian", {{"least", d.scaled_jacobian.least}, {"mean", d.scaled_jacobian.mean}}}};
  };
  const auto line = [](const char* name, const Diagnosis& d) {
    std::array<char, 128> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%s scaled Jacobian mean %.4f, least %.4f, %d inverted\n", name,
                  d.scaled_jacobian.mean, d.scaled_jacobian.least, d.inverted);
    return std::string(buffer.data());
  };
  program::finish(options,
                  ordered_json{{"vertices", surface.mesh.vertex_count()},
                               {"moved", moved},
                               {"largest_move", farthest},
                               {"feature_edges", features.size()},
                               {"before", quality(before)},
                               {"after", quality(after)}}
                      .dump(),
                  options.on_stdout("script")
                      ? ""
                      : counted(moved, "vertex", "vertices") + " moved\n" + line("before", before) +
                            line("after ", after) + not_kept_line(attributes),
                  std::move(outputs));
  report_left_out(options, surface);
  return program::kDone;
}

}  // namespace

program::Command smooth_command() {
  std::vector<program::Option> options{
      output_option(),
      program::value("iterations", "N", "smooth N times (default 10)"),
      program::value("weights", "uniform|chord", "weights of the neighbours (default uniform)"),
      program::flag("project", "move each vertex back to the surface of IN"),
      program::value("pull", "T", "keep each vertex within distance T of the nearest vertex of IN"),
      program::flag("no-guard", "take steps that invert a quad too"),
      program::output("script", "FILE", "write the move as text, for `requad-edit apply`"),
  };
  for (program::Option& option : input_and_seam_options()) options.push_back(std::move(option));
  return {
      .name = "smooth",
      .usage = {"IN -o OUT"},
      .summary = "smooths the mesh (Laplacian smoothing)",
      .text = R"(Vertices on the boundary and on features stay. A step that would invert a quad
is not taken.
)",
      .examples = {"requad-edit smooth mesh/examples/figure-16.obj --project -o smooth.obj",
                   "requad-edit smooth mesh/examples/figure-17.obj --feature-angle 40 --weights chord -o smooth.obj"},
      .options = std::move(options),
      .words = {1, 1},
      .files = {0},
      .run = smooth,
  };
}

}  // namespace requad::edit
