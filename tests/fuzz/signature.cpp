// Signatures.
#include "mesh/topology/signature.hpp"

#include "mesh/topology/validate.hpp"
#include "tests/fuzz/fuzz.hpp"

const requad::fuzz::Memory requad::fuzz::kMemory{32 << 10, 400};

void requad::fuzz::try_input(std::string_view text) {
  using mesh::Orientation;
  mesh::Region region;
  if (!accepts([&] { region = mesh::from_signature(text); })) return;
  const mesh::QuadMesh& m = region.mesh;
  require(mesh::validate(m).empty() && m.is_live(region.root), "the mesh is not valid");
  require(mesh::component_count(m) == 1, "the mesh is not connected");
  require(mesh::signature(region) == text, "a mesh has two signatures at one root");
  // Isomorphic meshes with other ids: one has another root, one is reflected.
  const auto turned = mesh::from_signature(mesh::signature(m, mesh::HalfEdgeId(m.half_edge_capacity() - 1)));
  const auto reflected = mesh::from_signature(mesh::signature(m, region.root, Orientation::mirrored));
  const std::string canonical = mesh::canonical_signature(m);
  require(mesh::canonical_signature(turned.mesh) == canonical, "isomorphic meshes, two canonical signatures");
  require(mesh::canonical_signature(reflected.mesh, Orientation::mirrored) == canonical,
          "the reflected mesh, reflected, has another canonical signature");
}
