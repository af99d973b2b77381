// requad-edit smooth: moves vertices and changes no connectivity.

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "mesh/commands/arguments.hpp"
#include "mesh/commands/commands.hpp"
#include "mesh/commands/quality.hpp"
#include "mesh/editing/carried_attributes.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/correspondence.hpp"
#include "mesh/geometry/fitting.hpp"
#include "mesh/geometry/hausdorff_distance.hpp"
#include "mesh/geometry/nearest_points.hpp"
#include "mesh/geometry/smoothing.hpp"
#include "mesh/program/run/progress.hpp"

namespace requad::edit {

namespace {

using nlohmann::ordered_json;
using program::Options;

constexpr double kProjectedBound = 0.01;  // of the diagonal, by default

int smooth(const Options& options) {
  const std::string output = output_path(options, "smooth");
  mesh::SmoothingOptions how;
  const auto iterations = static_cast<int>(options.integer("iterations", 10, 0, 1'000'000));
  how.iterations = 1;  // one at a time, so that progress can be shown
  if (options.has("no-guard")) how.guard.reset();
  how.weights = options.choice("weights", {"uniform", "chord"}, "uniform") == "chord" ? mesh::SmoothingWeights::chord
                                                                                      : mesh::SmoothingWeights::uniform;
  how.pull_distance = options.number("pull", 0, 0, std::numeric_limits<double>::max());
  const bool fits = options.has("project");
  const double bound = options.number("max-deviation", fits ? kProjectedBound : -1, 0, 1);

  const mesh::Surface surface = read_input(options);
  mesh::FeatureSet features;
  for (const auto& [a, b] : read_features(options, surface)) features.insert(a, b);
  const std::size_t feature_edges = features.size();
  const mesh::FeatureEdges seams = mesh::texture_seams(surface);
  if (keeps_seams(options, surface, seams)) {
    for (const auto& [a, b] : seams) features.insert(a, b);
  }
  mesh::QuadMesh same = surface.mesh;
  mesh::Positions positions = surface.positions;
  mesh::Editor editor(same, &features, &positions);
  std::optional<mesh::SurfaceIndex> original;
  std::optional<mesh::Correspondence> homes;
  std::optional<mesh::PointIndex> original_vertices;
  if (fits) {
    original.emplace(surface.mesh, surface.positions);
    editor.keep(&homes.emplace(same, positions));
  }
  if (options.has("pull")) how.pull_to = &original_vertices.emplace(surface.positions);
  const double diagonal = mesh::bounding_box_diagonal(surface.mesh, surface.positions);
  mesh::FitOptions fitting;
  fitting.rounds = 1;
  fitting.sweeps = 1;
  fitting.quality = mesh::kGoodQuads;
  fitting.run = tasks(options);
  fitting.tolerance = std::max(bound, kProjectedBound / 10) * diagonal / 2;
  const int inverted = mesh::count_inverted(same, positions);

  // Whatever goes too far, or makes quads worse, is taken back, and ends the work.
  const std::vector<mesh::VertexId> vertices = surface.mesh.vertices();
  program::Progress progress("iterations", iterations, options.quiet());
  int made = 0;
  for (; made < iterations; ++made) {
    const std::size_t before = editor.mark();
    if (fits) {
      editor.fit(vertices, *original, fitting);
    } else {
      editor.smooth(vertices, how);
    }
    const bool is_worse = !options.has("no-guard") && mesh::count_inverted(same, positions) > inverted;
    if (is_worse || (bound >= 0 && mesh::hausdorff_distance({same, positions}, {surface.mesh, surface.positions}) >
                                       bound * diagonal)) {
      editor.roll_back(before);
      break;
    }
    progress.advance();
  }
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
  const Quality quality = compare(surface, same, positions);
  ordered_json summary{{"vertices", surface.mesh.vertex_count()},
                       {"moved", moved},
                       {"largest_move", farthest},
                       {"iterations", made},
                       {"feature_edges", feature_edges}};
  add(summary, quality);
  std::string text = counted(moved, "vertex", "vertices") + " moved\n";
  if (made < iterations) {
    text += "stopped after " + counted(made, "iteration", "iterations") +
            ": the next one goes beyond --max-deviation, or inverts a quad\n";
  }
  program::finish(options, summary.dump(),
                  options.on_stdout("script") ? "" : text + to_string(quality) + not_kept_line(attributes),
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
      program::flag("project",
                    "fit to the surface of IN: vertices stay near it, and what sticks out of IN stays\n"
                    "covered"),
      program::value("max-deviation", "D",
                     "stop before the Hausdorff distance of OUT and IN exceeds D times the diagonal of\n"
                     "IN (default with --project: 0.01; else no bound)"),
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
is not taken. Laplacian smoothing shrinks what is round; --project keeps the
shape.
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
