// Checks a mesh's invariants (I1-I4 of quad_mesh.hpp) on arrays that may be broken in any way.
#pragma once

#include <string>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

struct Defect {
  enum class Kind {
    sizes,            // half-edges are not four for each face
    range,            // an index is out of range, or points to a deleted element
    half_deleted,     // a face of which some corners are deleted
    twin,             // twin is no involution, or pairs a half-edge with itself (I1)
    twin_ends,        // twins do not join the same two vertices in opposite directions (I1)
    out,              // out(v) does not leave v, or a boundary fan does not start on the boundary (I3)
    fan,              // the faces at a vertex do not form one fan (I2)
    isolated,         // a live vertex without a face, or a half-edge out of a deleted vertex
    repeated_vertex,  // a face with one vertex twice (I4)
    repeated_edge     // two edges between the same two vertices (I4)
  };
  Kind kind;
  std::string message;  // one line, names the element
};

// Every defect found, at most one for each element and kind; empty means valid. Never loops or reads out of bounds,
// whatever the arrays hold. O(V + E log E).
std::vector<Defect> validate(const QuadMesh& mesh);

// V - E + F.
int euler_characteristic(const QuadMesh& mesh);
int boundary_loop_count(const QuadMesh& mesh);
int component_count(const QuadMesh& mesh);

}  // namespace requad::mesh
