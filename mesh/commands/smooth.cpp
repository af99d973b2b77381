// requad-edit smooth and subdivide: change where vertices are, or how many there are, but no connectivity.

#include <array>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "mesh/commands/command.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/geometry/nearest_points.hpp"
#include "mesh/geometry/smoothing.hpp"

namespace requad::edit {

namespace {

using mesh::Diagnosis;
using nlohmann::ordered_json;
using program::Options;
using program::UsageError;

int smooth(const Options& options) {
  const std::string output = output_path(options, "smooth");
  wants_features(options);
  mesh::SmoothingOptions how;
  const auto iterations = static_cast<int>(options.integer("iterations", 10, 0, 1'000'000));
  how.iterations = 1;  // at a time, so that progress can be told
  if (options.has("no-guard")) how.guard.reset();
  const std::string weights = options.text("weights", "uniform");
  if (weights != "uniform" && weights != "chord")
    throw UsageError("--weights: '" + weights + "' is not one of uniform, chord");
  how.weights = weights == "chord" ? mesh::SmoothingWeights::chord : mesh::SmoothingWeights::uniform;
  how.pull_distance = options.number("pull", 0, 0, std::numeric_limits<double>::max());

  const mesh::Surface surface = read_input(options, "smooth");
  const mesh::FeatureEdges features = read_features(options, surface);
  std::vector<bool> fixed(surface.positions.size(), false);
  for (const auto& edge : features) {
    for (const mesh::VertexId v : edge) fixed[v.slot()] = true;
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
  outputs.add(output, mesh::obj_text(surface.mesh, positions));

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
                  options.on_stdout("script") ? ""
                                              : counted(moved, "vertex", "vertices") + " moved\n" +
                                                    line("before", before) + line("after ", after),
                  std::move(outputs));
  return program::kDone;
}

int subdivide(const Options& options) {
  const std::string output = output_path(options, "subdivide");
  if (options.words().size() != 1) throw UsageError("subdivide: expected one mesh file; see --help");
  const mesh::Surface surface = mesh::read_surface(options.words().front(), true);
  program::Outputs outputs;
  outputs.add(output, mesh::obj_text(surface.mesh, surface.positions));
  const int vertices = surface.mesh.vertex_count(), faces = surface.mesh.face_count();
  program::finish(
      options, ordered_json{{"vertices", vertices}, {"faces", faces}, {"unused_vertices", surface.dropped}}.dump(),
      counted(vertices, "vertex", "vertices") + ", " + counted(faces, "face", "faces") + "\n", std::move(outputs));
  return program::kDone;
}

}  // namespace

Command smooth_command() {
  return {
      "smooth",
      "  requad-edit smooth IN -o OUT [--iterations N] [--weights uniform|chord] [--project] [--pull T] [--no-guard]\n"
      "                     [--feature-angle DEG | --features FILE] [--script FILE] [--subdivide]\n"
      "      Laplacian smoothing (10 iterations, uniform weights); boundary and feature vertices stay; --project "
      "moves\n"
      "      each vertex back to the input's surface, --pull to within T of the input's nearest vertex; a step that\n"
      "      would invert a quad is not taken, unless --no-guard\n",
      {"requad-edit smooth bunny.obj --project -o smooth.obj",
       "requad-edit smooth fandisk.obj --feature-angle 30 --weights chord --iterations 50 --project -o smooth.obj"},
      {{"subdivide", "project", "no-guard"},
       {"iterations", "weights", "pull", "feature-angle", "features"},
       {},
       {"output,o", "script"}},
      smooth};
}

Command subdivide_command() {
  return {"subdivide",
          "  requad-edit subdivide IN -o OUT\n"
          "      each n-gon becomes n quads: the vertices of IN keep numbers and places, then come the middles of "
          "edges, then\n"
          "      those of faces\n",
          {"requad-edit subdivide triangles.obj -o quads.obj"},
          {{}, {}, {}, {"output,o"}},
          subdivide};
}

}  // namespace requad::edit
