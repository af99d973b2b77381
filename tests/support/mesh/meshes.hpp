// Meshes for tests: generated, relabelled, and changed by random operations. Also the basic operations as surgery on
// face lists. Includes only mesh/.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "mesh/geometry/measures.hpp"
#include "mesh/topology/basic_operations.hpp"
#include "mesh/topology/region.hpp"

namespace requad::tests {

// The same mesh with faces, corners and vertices renamed at random; half_edge[old] is the new name.
struct Relabelled {
  mesh::QuadMesh mesh;
  std::vector<mesh::HalfEdgeId> half_edge;
};
Relabelled relabel(const mesh::QuadMesh& mesh, std::mt19937& random);
mesh::BasicOperation renamed(const mesh::BasicOperation& operation, const Relabelled& by);

// A random operation; all kinds are equally likely. It may be illegal, and it may name an element that was removed.
mesh::BasicOperation random_operation(const mesh::QuadMesh& mesh, std::mt19937& random);

// The independent side of the operation tests: face lists over the vertex ids of a mesh without gaps, and the three
// operations on such lists according to their definitions, without half-edges. is_legal_result() judges the result.
using FaceList = std::vector<std::array<int, 4>>;
FaceList face_list(const mesh::QuadMesh& mesh);
FaceList flipped(const mesh::QuadMesh& mesh, mesh::HalfEdgeId h, mesh::Rotation rotation);
FaceList collapsed(const mesh::QuadMesh& mesh, mesh::HalfEdgeId h);
FaceList split(const mesh::QuadMesh& mesh, const std::vector<mesh::FaceId>& sector, mesh::HalfEdgeId first,
               mesh::HalfEdgeId last);

// Whether the faces form a simple, manifold mesh with the boundary cycle and the Euler characteristic of `before`. The
// mesh must have all vertices from 0 to `vertices` - 1, except `gone` if that is not negative.
struct LegalResult {
  bool legal = false;
  mesh::QuadMesh mesh;
  std::vector<int> name;  // the id of each vertex in `mesh`, where the gap is closed
};
LegalResult is_legal_result(const mesh::QuadMesh& before, const FaceList& faces, int vertices, int gone);

// The boundary as a cycle of vertices that starts with the least one.
std::vector<int> boundary_cycle(const mesh::QuadMesh& mesh);

// A torus of columns x rows quads, and the sphere of the cube.
mesh::QuadMesh torus(int columns, int rows);
mesh::QuadMesh cube();
// A regular grid of columns x rows quads, with its root at a corner.
mesh::Region grid(int columns, int rows);

// A random position in the cube [-1, 1)^3 for every vertex slot.
mesh::Positions random_positions(const mesh::QuadMesh& mesh, std::mt19937& random);
// The number of irregular vertices of each valence.
std::map<int, int> irregular_valences(const mesh::QuadMesh& mesh);

// Does the tasks of a loop the other way round, as threads may (mesh/geometry/in_chunks.hpp).
void backwards(std::size_t count, const std::function<void(std::size_t)>& task);

}  // namespace requad::tests
