// Separatrices (Definition 7.7): straight paths that start at an irregular vertex.
#pragma once

#include <span>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

// v is interior and its valence is not 4. Boundary vertices are not irregular: their index is the turn (region.hpp).
bool is_irregular(const QuadMesh& mesh, VertexId v);
std::vector<VertexId> irregular_vertices(const QuadMesh& mesh);

// Whether the vertex that h leaves is interior and of valence 4: three or four steps round it, and no other. h is live.
inline bool is_regular_at(const QuadMesh& mesh, HalfEdgeId h) {
  const HalfEdgeId second = mesh.ccw(h);
  if (!second.valid()) return false;
  const HalfEdgeId third = mesh.ccw(second);
  if (!third.valid() || third == h) return false;
  const HalfEdgeId fourth = mesh.ccw(third);
  return fourth.valid() && fourth != h && mesh.ccw(fourth) == h;
}

// The straight path that starts with h, as half-edges; every vertex between its ends is interior and regular.
struct Separatrix {
  enum class End { boundary, irregular, closed };
  std::vector<HalfEdgeId> path;  // at least h itself
  End end = End::boundary;       // closed: back at the start, which is then regular
  int length() const { return static_cast<int>(path.size()); }
};
// O(length); ends after at most one visit of each half-edge. Precondition: h is live.
Separatrix trace(const QuadMesh& mesh, HalfEdgeId h);

// Where trace() ends, without the path.
struct Arrival {
  HalfEdgeId last;  // the half-edge by which it arrives
  int length = 1;
  Separatrix::End end = Separatrix::End::boundary;
};
// Follows several paths, each from the half-edge that its `last` is. `most` >= 1 edges are walked of each at the most; one
// that goes on, closed ones among them, ends `closed` there. The paths advance side by side, since a step is nothing but
// waiting for memory. O(sum of lengths), no allocation.
void follow(const QuadMesh& mesh, std::span<Arrival> paths, int most);

}  // namespace requad::mesh
