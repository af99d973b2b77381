// requad-enumerate signature: the canonical signature of a mesh, or the mesh of a signature.

#include "mesh/topology/signature.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "enumerate/commands/arguments.hpp"
#include "enumerate/commands/commands.hpp"
#include "enumerate/planar_code.hpp"
#include "enumerate/space_drawing.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/drawing.hpp"
#include "mesh/text/text_scanner.hpp"
#include "mesh/topology/validate.hpp"

namespace requad::enumerate {

namespace {

using mesh::QuadMesh;
using nlohmann::ordered_json;
using program::Options;
using program::UsageError;

bool is_closed(const QuadMesh& mesh) { return mesh::boundary_loop_count(mesh) == 0; }

// What is said of a connected mesh.
ordered_json description(const QuadMesh& m) {
  const std::string kept = mesh::canonical_signature(m),
                    mirrored = mesh::canonical_signature(m, mesh::Orientation::mirrored);
  return {{"vertices", m.vertex_count()},          {"faces", m.face_count()}, {"closed", is_closed(m)},
          {"canonical", std::min(kept, mirrored)}, {"oriented", kept},        {"chiral", kept != mirrored}};
}

int signature_of_file(const Options& options, const std::string& path) {
  const mesh::Surface surface = mesh::read_surface(path, options.has("subdivide"));
  const QuadMesh& m = surface.mesh;
  if (surface.dropped > 0) {
    std::cerr << "requad-enumerate: " << program::one_line(mesh::name_in_messages(path))
              << ": vertices in no face, left out: " << surface.dropped << '\n';
  }
  if (const int components = mesh::component_count(m); components != 1)
    throw UsageError(mesh::name_in_messages(path) + ": the mesh has " + std::to_string(components) +
                     " components; expected one");
  const ordered_json said = description(m);
  finish(options, said, said["canonical"].get<std::string>() + "\n");
  return program::kDone;
}

// The signatures of all graphs that plantri wrote, a line for each.
int signatures_of_list(const Options& options, const std::string& path) {
  std::ifstream file;
  if (path != "-") file.open(path, std::ios::binary);
  std::istream& in = path == "-" ? std::cin : file;
  if (!in) throw UsageError(path + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  ordered_json list = ordered_json::array();
  std::string lines;
  for (const QuadMesh& m : parse_plantri(text, mesh::name_in_messages(path))) {
    list.push_back(description(m));
    lines += list.back()["canonical"].get<std::string>() + "\n";
  }
  finish(options, {{"count", list.size()}, {"meshes", list}}, lines);
  return program::kDone;
}

// The signature that --from-signature gives, or the first word of standard input for "-".
std::string given_signature(const Options& options) {
  std::string text = options.text("from-signature");
  if (text != "-") return text;
  std::istringstream(mesh::read_text("-")) >> text;
  return text;
}

// The mesh as OBJ: a region as it is drawn in the plane, any other mesh as it is drawn in space.
std::string drawn(mesh::Region region) {
  const std::vector<std::string> comments{"rebuilt from its signature"};
  if (mesh::boundary_loop_count(region.mesh) == 1) {
    for (const mesh::HalfEdgeId h : region.mesh.half_edges()) {
      if (region.mesh.is_boundary(region.root)) break;
      if (region.mesh.is_boundary(h)) region.root = h;
    }
    if (mesh::region_problem(region).empty() && region.mesh.face_count() <= mesh::kMostFacesDrawn)
      return mesh::obj_text(region, comments);
  }
  return mesh::obj_text(region.mesh, space_drawing(region.mesh), comments);
}

// The mesh that --from-signature names.
int mesh_of_signature(const Options& options) {
  const mesh::Region rebuilt = mesh::from_signature(given_signature(options));
  const QuadMesh& m = rebuilt.mesh;
  const std::string canonical =
      std::min(mesh::canonical_signature(m), mesh::canonical_signature(m, mesh::Orientation::mirrored));
  program::Outputs outputs;
  if (options.has("output")) outputs.add(options.text("output"), drawn(rebuilt));
  program::finish(
      options,
      ordered_json{
          {"vertices", m.vertex_count()}, {"faces", m.face_count()}, {"closed", is_closed(m)}, {"canonical", canonical}}
          .dump(),
      "vertices " + std::to_string(m.vertex_count()) + "\nfaces " + std::to_string(m.face_count()) + "\ncanonical " +
          canonical + "\n",
      std::move(outputs));
  return program::kDone;
}

int signature(const Options& options) {
  if (options.words().empty() != options.has("from-signature"))
    throw UsageError("signature: expected either a mesh file or --from-signature");
  if (options.words().empty()) return mesh_of_signature(options);
  const std::string& path = options.words().front();
  return options.has("plantri") ? signatures_of_list(options, path) : signature_of_file(options, path);
}

}  // namespace

program::Command signature_command() {
  return {
      .name = "signature",
      .usage = {"FILE", "--from-signature TEXT"},
      .summary = "prints the canonical signature of a mesh, or makes the mesh of a signature",
      .text = R"(FILE is an OBJ or OFF file. Two files give the same line if and only if their
meshes are isomorphic. A mesh and its mirror image have one signature. The mesh
of a signature is drawn in the plane if it is a disk, and else in space.
)",
      .examples = {"requad-enumerate signature mesh/examples/figure-17.obj",
                   "requad-enumerate signature --from-signature 1111f13e3934"},
      .options =
          {
              program::not_with(
                  program::flag("subdivide", "with FILE: cut each polygon with n sides into n quads first"),
                  {"from-signature", "plantri"}),
              program::not_with(
                  program::flag("plantri",
                                "FILE is a list of quadrangulations as plantri writes them, in planar_code "
                                "or ASCII; print a line for each"),
                  {"from-signature"}),
              program::value("from-signature", "TEXT", "the signature, or - to read it from standard input"),
              program::only_with(mesh_output(), {"from-signature"}),
          },
      .words = {0, 1},
      .files = {0},
      .run = signature,
  };
}

}  // namespace requad::enumerate
