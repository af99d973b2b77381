// Separatrices (Definition 7.7): straight paths that start at an irregular vertex.
#pragma once

#include <vector>

#include "mesh/quad_mesh.hpp"

namespace requad::mesh {

// v is interior and its valence is not 4. Boundary vertices are not irregular: their index is the turn (region.hpp).
bool is_irregular(const QuadMesh& mesh, VertexId v);
std::vector<VertexId> irregular_vertices(const QuadMesh& mesh);

// The straight path that starts with h, as half-edges; every vertex between its ends is interior and regular.
struct Separatrix {
  enum class End { boundary, irregular, closed };
  std::vector<HalfEdgeId> path;  // at least h itself
  End end = End::boundary;       // closed: back at the start, which is then regular
  int length() const { return static_cast<int>(path.size()); }
};
// O(length); ends after at most one visit of each half-edge. Precondition: h is live.
Separatrix trace(const QuadMesh& mesh, HalfEdgeId h);

}  // namespace requad::mesh
