// A region: a disk of quads with a marked half-edge on its boundary. Its sides, its turns and its discrete curvature.
//
// Terms (section 7)
//   turn       of a boundary vertex with m faces: 2 - m quarter turns. A vertex of turn 1 is a corner (the paper's
//              normal convex turn point), 0 is straight, and a negative turn is concave.
//   convex     without concave vertices on the boundary.
//   side       the boundary edges from one corner to the next. Sides are read counter-clockwise from the root.
//   root       the boundary half-edge with which side 1 starts. Two regions are the same configuration, rel boundary,
//              iff an isomorphism takes root to root.
#pragma once

#include <string>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

struct Region {
  QuadMesh mesh;
  HalfEdgeId root;  // on the boundary
};

// The half-edges of the boundary loop of `start`, counter-clockwise from it. Precondition: it is on the boundary.
// O(boundary).
std::vector<HalfEdgeId> boundary_loop(const QuadMesh& mesh, HalfEdgeId start);

// 2 - (number of faces at v). Precondition: v is on the boundary.
inline int turn(const QuadMesh& mesh, VertexId v) { return 2 - mesh.face_valence(v); }

// Why the mesh is not a convex region whose root starts a side; "" if it is. It must be a disk without a concave
// vertex, and the root must leave a corner, if there is one. O(V).
std::string region_problem(const Region& region);

// The side lengths E_1, E_2, ..., counter-clockwise from the root. If there is no corner, the whole boundary is one
// side. Precondition: region_problem() is "". O(boundary).
std::vector<int> side_lengths(const Region& region);

// Where a boundary vertex lies: the index of its side, 0-based, and its distance from the start of the side, in edges.
// A corner belongs to the side that it starts.
struct BoundaryPosition {
  int side = -1;
  int distance = -1;
  friend bool operator==(const BoundaryPosition&, const BoundaryPosition&) = default;
};
// By vertex slot; {-1, -1} for interior vertices. Precondition: region_problem() is "". O(V).
std::vector<BoundaryPosition> boundary_positions(const Region& region);

// Law topology-10. Equation 1, discrete Gauss-Bonnet: total_turn + total_index = 4 * Euler characteristic.
int total_turn(const QuadMesh& mesh);   // sum of turns over the boundary
int total_index(const QuadMesh& mesh);  // sum of 4 - l(v) over interior vertices

}  // namespace requad::mesh
