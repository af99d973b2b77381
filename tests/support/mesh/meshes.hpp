// Meshes for tests, relabelled, operated on at random, and the basic operations as surgery on face lists. Knows mesh/ alone.
#pragma once

#include <array>
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

// One that may be illegal, or name an element that was removed; all kinds are alike likely.
mesh::BasicOperation random_operation(const mesh::QuadMesh& mesh, std::mt19937& random);

// Face lists over the vertex ids of a mesh without gaps, and the three operations on them as their definitions say, with
// no half-edges: the independent side of the operation tests. The caller judges the result by is_legal_result().
using FaceList = std::vector<std::array<int, 4>>;
FaceList face_list(const mesh::QuadMesh& mesh);
FaceList flipped(const mesh::QuadMesh& mesh, mesh::HalfEdgeId h, mesh::Rotation rotation);
FaceList collapsed(const mesh::QuadMesh& mesh, mesh::HalfEdgeId h);
FaceList split(const mesh::QuadMesh& mesh, const std::vector<mesh::FaceId>& sector, mesh::HalfEdgeId first,
               mesh::HalfEdgeId last);

// Whether the faces are a simple, manifold mesh on all of `vertices` (without `gone`, if >= 0) that has the boundary
// cycle and the Euler characteristic of `before`. The mesh itself, if so.
struct LegalResult {
  bool legal = false;
  mesh::QuadMesh mesh;
  std::vector<int> name;  // of each vertex in `mesh`, the gap closed
};
LegalResult is_legal_result(const mesh::QuadMesh& before, const FaceList& faces, int vertices, int gone);

// The boundary as a cycle of vertices, from the least one.
std::vector<int> boundary_cycle(const mesh::QuadMesh& mesh);

// A torus of columns x rows quads, and the sphere of the cube.
mesh::QuadMesh torus(int columns, int rows);
mesh::QuadMesh cube();
// A regular grid of columns x rows quads, with its root at a corner.
mesh::Region grid(int columns, int rows);

// Of every vertex slot, in the cube [-1, 1)^3.
mesh::Positions random_positions(const mesh::QuadMesh& mesh, std::mt19937& random);
// How many irregular vertices there are of each valence.
std::map<int, int> irregular_valences(const mesh::QuadMesh& mesh);

}  // namespace requad::tests
