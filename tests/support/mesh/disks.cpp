#include "tests/support/mesh/disks.hpp"

#include <set>
#include <string>

#include "mesh/topology/basic_operations.hpp"
#include "mesh/topology/signature.hpp"
#include "tests/support/mesh/meshes.hpp"

namespace requad::tests {

using mesh::BasicOperation;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;

namespace {

// Every basic operation that may be legal: each flip and collapse, each split at a vertex.
std::vector<BasicOperation> candidates(const QuadMesh& m) {
  using Kind = BasicOperation::Kind;
  std::vector<BasicOperation> all;
  for (const HalfEdgeId h : m.half_edges()) {
    for (const Kind kind : {Kind::flip_ccw, Kind::flip_cw, Kind::collapse}) all.push_back({kind, h, {}, 0});
    m.for_each_out(m.origin(h), [&](HalfEdgeId g) { all.push_back({Kind::split, h, QuadMesh::previous(g), 0}); });
  }
  return all;
}

}  // namespace

std::vector<Region> small_disks(int perimeter, int faces) {
  std::vector<Region> found;
  std::set<std::string> known;
  const auto add = [&](const QuadMesh& m, VertexId root) {
    if (m.face_count() > faces || !known.insert(signature(m, m.out(root))).second) return;
    // from_signature() gives a mesh without free ids.
    found.push_back(mesh::from_signature(signature(m, m.out(root))));
  };
  const Region start = grid(perimeter / 2 - 1, 1);
  add(start.mesh, start.mesh.origin(start.root));
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Region here = found[i];
    for (const BasicOperation& op : candidates(here.mesh)) {
      QuadMesh m = here.mesh;
      if (mesh::apply(m, op).refusal == mesh::Refusal::none) add(m, here.mesh.origin(here.root));
    }
  }
  return found;
}

std::int64_t number_of_disks(int perimeter, int faces) {
  const int p = perimeter / 2, inner = faces - (p - 1);  // vertices inside
  if (inner < 0) return 0;
  // Without inner vertices: C(3(p-1), p-1) / (2p-1). Each further vertex multiplies by a quotient of factorials:
  // (3n + 3p - 4)! / (n! (2n + 3p - 2)!) for n of them.
  double count = 1;
  for (int i = 1; i < p; ++i) count *= static_cast<double>(2 * (p - 1) + i) / i;
  count /= 2 * p - 1;
  for (int n = 1; n <= inner; ++n) {
    for (int i = 0; i < 3; ++i) count *= 3 * n + 3 * p - 4 - i;
    count /= static_cast<double>(n) * (2 * n + 3 * p - 2) * (2 * n + 3 * p - 3);
  }
  return static_cast<std::int64_t>(count + 0.5);
}

}  // namespace requad::tests
