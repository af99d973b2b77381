#include "verify/claims/surfaces.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace requad::verify {

namespace {

// The faces of a mesh without these ones. Vertices keep their numbers.
std::vector<std::array<int, 4>> without(const mesh::QuadMesh& m, const std::vector<std::size_t>& holes) {
  std::vector<std::array<int, 4>> faces = m.compact_faces();
  for (auto it = holes.rbegin(); it != holes.rend(); ++it)
    faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(*it));
  return faces;
}

// Two copies of a mesh, the second one mirrored, joined by a strip of quads along each boundary: a closed surface.
mesh::QuadMesh doubled(const mesh::QuadMesh& m) {
  const int n = m.vertex_count();
  std::vector<std::array<int, 4>> faces = m.compact_faces();
  const std::size_t copied = faces.size();
  for (std::size_t f = 0; f < copied; ++f) {
    const auto [a, b, c, d] = faces[f];
    faces.push_back({d + n, c + n, b + n, a + n});
  }
  for (const mesh::HalfEdgeId h : m.half_edges()) {
    if (!m.is_boundary(h)) continue;
    const int a = m.origin(h).index(), b = m.target(h).index();
    faces.push_back({b, a, a + n, b + n});
  }
  return mesh::QuadMesh::from_faces(2 * n, faces);
}

}  // namespace

std::vector<MadeSurface> surfaces_from(const mesh::Region& region) {
  const mesh::QuadMesh disk = mesh::QuadMesh::from_faces(region.mesh.vertex_count(), region.mesh.compact_faces());
  std::vector<std::size_t> holes;
  std::set<mesh::VertexId> used;
  for (const mesh::FaceId f : disk.faces()) {
    const auto corners = disk.corners(f);
    const bool free = std::none_of(corners.begin(), corners.end(),
                                   [&](mesh::VertexId v) { return disk.is_boundary(v) || used.count(v) > 0; });
    if (!free || holes.size() == 2) continue;
    holes.push_back(static_cast<std::size_t>(f.index()));
    used.insert(corners.begin(), corners.end());
  }
  std::vector<MadeSurface> surfaces;
  for (std::size_t number = 0; number <= holes.size(); ++number) {
    const std::vector<std::size_t> made(holes.begin(), holes.begin() + static_cast<std::ptrdiff_t>(number));
    const int euler = 1 - static_cast<int>(number);
    mesh::QuadMesh open = mesh::QuadMesh::from_faces(disk.vertex_count(), without(disk, made));
    surfaces.push_back({doubled(open), 2 * euler});
    surfaces.push_back({std::move(open), euler});
  }
  return surfaces;
}

}  // namespace requad::verify
