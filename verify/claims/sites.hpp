// Sites for single operations: generated neighbourhoods, and what an operation makes of them. Private to this folder.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mesh/topology/basic_operations.hpp"
#include "verify/claims/claims.hpp"

namespace requad::verify {

inline bool is_flip(mesh::BasicOperation::Kind kind) {
  return kind == mesh::BasicOperation::Kind::flip_ccw || kind == mesh::BasicOperation::Kind::flip_cw;
}

struct Performed {
  mesh::BasicOperation operation;
  mesh::QuadMesh mesh;  // afterwards
  std::vector<mesh::VertexId> irregular;
  std::multiset<int> valences;  // of the irregular ones
};
// Precondition: the operation is legal.
Performed performed(const mesh::QuadMesh& mesh, const mesh::BasicOperation& operation);

// A region whose vertex is at least two rings of quads away from the boundary, so that no operation at the vertex comes
// near the boundary. Null if there is none.
const mesh::Region* neighbourhood(const VertexStudy& study);
// The first vertex that lies so deep inside a region; none if there is none.
mesh::VertexId deep_vertex(const mesh::Region& region);

// Places a violation in a region, for for_each_of().
inline auto placed_in(const mesh::Region& region) {
  return [&region](const auto&, std::string what) { return Violation{std::move(what), "", "", region}; };
}

}  // namespace requad::verify
