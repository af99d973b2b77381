// Lists of ids in order, each id once.
#pragma once

#include <algorithm>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::web {

template <class Id>
void sort_once(std::vector<Id>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

// The faces at those of the vertices that are live.
inline std::vector<mesh::FaceId> faces_round(const mesh::QuadMesh& m, const std::vector<mesh::VertexId>& vertices) {
  std::vector<mesh::FaceId> faces;
  for (const mesh::VertexId v : vertices) {
    if (m.is_live(v)) m.for_each_out(v, [&](mesh::HalfEdgeId h) { faces.push_back(mesh::QuadMesh::face(h)); });
  }
  sort_once(faces);
  return faces;
}

}  // namespace requad::web
