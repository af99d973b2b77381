// A region: a quadrangulated disk with a marked boundary half-edge, its sides, turns and discrete curvature.
//
// Terms (section 7)
//   turn       of a boundary vertex with m interior quads: 2 - m quarter turns. 1 is a normal convex turn point (a
//              corner), 0 is straight, negative is concave.
//   convex     no concave vertex on the boundary.
//   side       the boundary edges between two corners. Sides are read counter-clockwise from the root.
//   root       the boundary half-edge that marks where side 1 starts. It makes "rel boundary" mean something: two
//              regions are the same configuration iff an isomorphism takes root to root.
#pragma once

#include <string>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

struct Region {
  QuadMesh mesh;
  HalfEdgeId root;  // on the boundary
};

// Boundary half-edges counter-clockwise from `start`. O(boundary).
std::vector<HalfEdgeId> boundary_loop(const QuadMesh& mesh, HalfEdgeId start);

// 2 - (interior quads at v). Precondition: v is on the boundary.
inline int turn(const QuadMesh& mesh, VertexId v) { return 2 - mesh.face_valence(v); }

// Why the mesh is not a convex region whose root starts a side ("" if it is): a disk, no concave vertex, root at a corner
// (any boundary half-edge if there is no corner).
std::string region_problem(const Region& region);

// Side lengths E_1.. counter-clockwise from the root. Precondition: region_problem() is "". Without corners the whole
// boundary is one side.
std::vector<int> side_lengths(const Region& region);

// Where boundary vertex v lies: side index (0-based) and distance from that side's start. A corner belongs to the side
// that it starts.
struct BoundaryPosition {
  int side = -1;
  int distance = -1;
  friend bool operator==(const BoundaryPosition&, const BoundaryPosition&) = default;
};
// By vertex slot; {-1,-1} for interior vertices. O(V).
std::vector<BoundaryPosition> boundary_positions(const Region& region);

// Equation 1, discrete Gauss-Bonnet: total_turn + total_index = 4 * Euler characteristic.
int total_turn(const QuadMesh& mesh);   // sum of turns over the boundary
int total_index(const QuadMesh& mesh);  // sum of 4 - l(v) over interior vertices

}  // namespace requad::mesh
