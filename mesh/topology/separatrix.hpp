// Separatrices (Definition 7.7): straight paths that start at an irregular vertex.
//
// A path is straight if it enters and leaves each inner vertex by opposite edges, which is possible at regular vertices
// only. So a straight path continues until it reaches an irregular vertex or the boundary, or returns to its start.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

struct Separatrix {
  enum class End { boundary, irregular, closed };
  std::vector<HalfEdgeId> path;  // at least one half-edge; the inner vertices are regular
  End end = End::boundary;       // closed: the path returns to its first half-edge, whose origin is then regular
  int length() const { return static_cast<int>(path.size()); }
};
// The straight path that starts with h, as far as it goes. No half-edge occurs twice. Precondition: h is live.
// O(length).
Separatrix trace(const QuadMesh& mesh, HalfEdgeId h);

// The last half-edge of the straight path of `length` edges that starts with h; nothing if a vertex before its end is
// not regular. Preconditions: h is live; length >= 1. O(length).
inline std::optional<HalfEdgeId> end_of_straight_path(const QuadMesh& mesh, HalfEdgeId h, int length) {
  for (int i = 1; i < length; ++i) {
    if (!leaves_regular_vertex(mesh, QuadMesh::next(h))) return std::nullopt;
    h = mesh.straight(h);
  }
  return h;
}

// Where a straight path ends, without the path.
struct SeparatrixEnd {
  HalfEdgeId last;  // the last half-edge of the path
  int length = 1;   // in edges
  Separatrix::End end = Separatrix::End::boundary;
};
// Advances several straight paths, each from its `last` half-edge, which becomes the first of its path. Each path
// advances to its end, or until it has `most` edges (>= 1); a path that is not finished by then is reported as closed.
// The paths advance by turns, because following a half-edge is mostly waiting for memory. O(sum of lengths); allocates
// nothing.
void trace_ends(const QuadMesh& mesh, std::span<SeparatrixEnd> paths, int most);

}  // namespace requad::mesh
