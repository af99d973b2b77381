// requad-enumerate signature: the canonical signature of a mesh, or the mesh of a signature.

#include "mesh/topology/signature.hpp"

#include <algorithm>
#include <iostream>

#include "enumerate/commands/arguments.hpp"
#include "enumerate/commands/commands.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/topology/validate.hpp"

namespace requad::enumerate {

namespace {

using mesh::QuadMesh;
using program::Options;
using program::UsageError;

bool is_closed(const QuadMesh& mesh) { return mesh::boundary_loop_count(mesh) == 0; }

// The signature of the mesh in a file. The mesh must be connected.
int signature_of_file(const Options& options, const std::string& path) {
  options.allow_only("signature FILE", {"subdivide"});
  const mesh::Surface surface = mesh::read_surface(path, options.has("subdivide"));
  const QuadMesh& m = surface.mesh;
  if (surface.dropped > 0) {
    std::cerr << "requad-enumerate: " << program::one_line(path)
              << ": vertices in no face, left out: " << surface.dropped << '\n';
  }
  if (const int components = mesh::component_count(m); components != 1)
    throw UsageError(path + ": the mesh has " + std::to_string(components) + " components; expected one");
  const std::string kept = mesh::canonical_signature(m),
                    mirrored = mesh::canonical_signature(m, mesh::Orientation::mirrored);
  const std::string& canonical = std::min(kept, mirrored);
  finish(options,
         {{"vertices", m.vertex_count()},
          {"faces", m.face_count()},
          {"closed", is_closed(m)},
          {"canonical", canonical},
          {"oriented", kept},
          {"chiral", kept != mirrored}},
         canonical + "\n");
  return program::kDone;
}

// The mesh that --from-signature names.
int mesh_of_signature(const Options& options) {
  options.allow_only("signature", {"from-signature", "output"});
  const mesh::Region rebuilt = mesh::from_signature(options.text("from-signature"));
  if (options.has("output")) {
    if (const std::string problem = mesh::region_problem(rebuilt); !problem.empty())
      throw UsageError("signature: it cannot be drawn: " + problem);
  }
  const QuadMesh& m = rebuilt.mesh;
  const std::string canonical =
      std::min(mesh::canonical_signature(m), mesh::canonical_signature(m, mesh::Orientation::mirrored));
  finish(
      options,
      {{"vertices", m.vertex_count()}, {"faces", m.face_count()}, {"closed", is_closed(m)}, {"canonical", canonical}},
      "vertices " + std::to_string(m.vertex_count()) + "\nfaces " + std::to_string(m.face_count()) + "\ncanonical " +
          canonical + "\n",
      &rebuilt, "rebuilt from its signature");
  return program::kDone;
}

int signature(const Options& options) {
  if (options.words().empty() != options.has("from-signature"))
    throw UsageError("signature: expected either a mesh file or --from-signature");
  return options.words().empty() ? mesh_of_signature(options) : signature_of_file(options, options.words().front());
}

}  // namespace

program::Command signature_command() {
  return {
      .name = "signature",
      .usage = {"FILE", "--from-signature TEXT"},
      .summary = "prints the canonical signature of a mesh, or checks a signature and draws its region",
      .text = R"(FILE is an OBJ or OFF file. Two files give the same line if and only if their
meshes are isomorphic. A mesh and its mirror image have one signature.
)",
      .examples = {"requad-enumerate signature mesh/examples/figure-17.obj",
                   "requad-enumerate signature --from-signature 1111f13e3934"},
      .options =
          {
              program::flag("subdivide", "with FILE: cut each polygon with n sides into n quads first"),
              program::value("from-signature", "TEXT", "the signature"),
              program::output("output,o", "FILE", "with --from-signature: the OBJ file to write, or -"),
          },
      .words = {0, 1},
      .run = signature,
  };
}

}  // namespace requad::enumerate
