// Checks the invariants of a mesh (topology-1 to topology-4 of quad_mesh.hpp), whatever its arrays hold.
#pragma once

#include <string>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

struct Defect {
  enum class Kind {
    sizes,            // the number of half-edges is not a multiple of four
    range,            // an index is out of range, or that of a deleted element
    half_deleted,     // some corners of a face are deleted, but not all
    twin,             // twin is not an involution, or pairs a half-edge with itself (topology-1)
    twin_ends,        // twins do not join the same two vertices in opposite directions (topology-1)
    out,              // out(v) does not leave v, or a boundary fan does not start on the boundary (topology-3)
    fan,              // the faces at a vertex do not form one fan (topology-2)
    isolated,         // a live vertex has no face, or a half-edge leaves a deleted vertex
    repeated_vertex,  // a vertex occurs twice in a face (topology-4)
    repeated_edge     // two edges join the same two vertices (topology-4)
  };
  Kind kind;
  std::string message;  // one line, names the element
};

// The defects, at most one for each element and kind; none if the mesh is valid. A defect that makes the rest
// unreadable ends the search. Always returns, and reads nothing out of bounds. O(V + E log E).
std::vector<Defect> validate(const QuadMesh& mesh);

// Topology. Preconditions: the mesh is valid. O(V + F).
int euler_characteristic(const QuadMesh& mesh);  // V - E + F
int boundary_loop_count(const QuadMesh& mesh);
int component_count(const QuadMesh& mesh);

}  // namespace requad::mesh
