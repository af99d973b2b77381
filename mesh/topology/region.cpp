#include "mesh/topology/region.hpp"

#include "mesh/topology/validate.hpp"

namespace requad::mesh {

std::vector<HalfEdgeId> boundary_loop(const QuadMesh& m, HalfEdgeId start) {
  std::vector<HalfEdgeId> loop;
  HalfEdgeId h = start;
  do {
    loop.push_back(h);
    h = m.next_on_boundary(h);
  } while (h != start);
  return loop;
}

std::string region_problem(const Region& r) {
  if (!r.mesh.is_live(r.root) || !r.mesh.is_boundary(r.root)) return "the root is not a boundary half-edge";
  if (component_count(r.mesh) != 1 || boundary_loop_count(r.mesh) != 1 || euler_characteristic(r.mesh) != 1) {
    return "the mesh is not a disk";
  }
  bool corners = false;
  for (const HalfEdgeId h : boundary_loop(r.mesh, r.root)) {
    const VertexId v = r.mesh.origin(h);
    const int t = turn(r.mesh, v);
    if (t < 0) return "boundary vertex " + std::to_string(v.index()) + " is concave";
    corners = corners || t > 0;
  }
  if (corners && turn(r.mesh, r.mesh.origin(r.root)) != 1) return "the root does not start a side";
  return "";
}

std::vector<int> side_lengths(const Region& r) {
  std::vector<int> lengths;
  for (const HalfEdgeId h : boundary_loop(r.mesh, r.root)) {
    if (lengths.empty() || turn(r.mesh, r.mesh.origin(h)) == 1) lengths.push_back(0);
    ++lengths.back();
  }
  return lengths;
}

std::vector<BoundaryPosition> boundary_positions(const Region& r) {
  std::vector<BoundaryPosition> position(static_cast<std::size_t>(r.mesh.vertex_capacity()));
  BoundaryPosition here{-1, 0};
  for (const HalfEdgeId h : boundary_loop(r.mesh, r.root)) {
    const VertexId v = r.mesh.origin(h);
    if (here.side < 0 || turn(r.mesh, v) == 1) here = {here.side + 1, 0};
    position[v.slot()] = here;
    ++here.distance;
  }
  return position;
}

int total_turn(const QuadMesh& m) {
  int sum = 0;
  for (const VertexId v : m.vertices()) {
    if (m.is_boundary(v)) sum += turn(m, v);
  }
  return sum;
}

int total_index(const QuadMesh& m) {
  int sum = 0;
  for (const VertexId v : m.vertices()) {
    if (!m.is_boundary(v)) sum += 4 - m.face_valence(v);
  }
  return sum;
}

}  // namespace requad::mesh
