// Lists of ids in order, each id once.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

template <class Id>
void sort_once(std::vector<Id>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

// The faces at those of the vertices that are live.
inline std::vector<FaceId> faces_round(const QuadMesh& m, std::span<const VertexId> vertices) {
  std::vector<FaceId> faces;
  for (const VertexId v : vertices) {
    if (m.is_live(v)) m.for_each_out(v, [&faces](HalfEdgeId h) { faces.push_back(QuadMesh::face(h)); });
  }
  sort_once(faces);
  return faces;
}

}  // namespace requad::mesh
