// requad-edit subdivide: cuts every polygon into quads.

#include <nlohmann/json.hpp>

#include "mesh/commands/arguments.hpp"
#include "mesh/commands/commands.hpp"
#include "mesh/files/write_obj.hpp"

namespace requad::edit {

namespace {

using nlohmann::ordered_json;

int subdivide(const program::Options& options) {
  const std::string output = output_path(options, "subdivide");
  const mesh::Surface surface = mesh::read_surface(options.words().front(), true, options.has("weld"));
  program::Outputs outputs;
  outputs.add(output, mesh::whole_obj_text(surface));
  const int vertices = surface.mesh.vertex_count(), faces = surface.mesh.face_count();
  program::finish(options,
                  ordered_json{{"vertices", vertices}, {"faces", faces}, {"unused_vertices", surface.dropped}}.dump(),
                  counted(vertices, "vertex", "vertices") + ", " + counted(faces, "face", "faces") + "\n" +
                      not_kept_line(surface.attributes),
                  std::move(outputs));
  return program::kDone;
}

}  // namespace

program::Command subdivide_command() {
  return {
      .name = "subdivide",
      .usage = {"IN -o OUT"},
      .summary = "cuts each polygon with n sides into n quads",
      .text = R"(The vertices of IN keep their numbers and places. The middles of the edges
follow them, then the middles of the faces. Vertices in no face are written too.
)",
      .examples = {"requad-edit subdivide mesh/examples/figure-18.obj -o fine.obj"},
      .options = {output_option(), program::flag("weld", "join vertices of IN that are at the same place")},
      .words = {1, 1},
      .files = {0},
      .run = subdivide,
  };
}

}  // namespace requad::edit
