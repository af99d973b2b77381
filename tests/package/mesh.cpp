// A user of requad::mesh: a strip of two quads, and the edge between them flipped and flipped back.
#include <array>
#include <vector>

#include <requad/mesh/topology/basic_operations.hpp>
#include <requad/mesh/topology/quad_mesh.hpp>

int main() {
  using namespace requad::mesh;
  const std::vector<std::array<int, 4>> faces{{0, 1, 4, 3}, {1, 2, 5, 4}};
  QuadMesh mesh = QuadMesh::from_faces(6, faces);
  const QuadMesh before = mesh;
  const HalfEdgeId edge = mesh.find_half_edge(VertexId(1), VertexId(4));
  const Applied done = apply(mesh, {BasicOperation::Kind::flip_ccw, edge, {}, 0});
  if (done.refusal != Refusal::none || mesh == before) return 1;
  apply(mesh, done.inverse);
  return mesh == before ? 0 : 1;
}
