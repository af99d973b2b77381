#include "mesh/files/surface.hpp"

#include "mesh/files/welding.hpp"
#include "mesh/text/text_scanner.hpp"

namespace requad::mesh {

Surface to_quad_mesh(PolygonMesh m) {
  Surface s;
  s.file_vertices = static_cast<int>(m.positions.size());
  s.from_file.assign(m.positions.size(), -1);
  for (const int v : m.corners) s.from_file[static_cast<std::size_t>(v)] = 0;
  for (std::size_t v = 0; v < m.positions.size(); ++v) {
    if (v < m.same_as.size() && m.same_as[v] != static_cast<int>(v)) continue;
    if (s.from_file[v] < 0) {
      ++s.dropped;
      s.unused.push_back(m.positions[v]);
      continue;
    }
    s.from_file[v] = static_cast<int>(s.positions.size());
    s.positions.push_back(m.positions[v]);
    s.file_vertex.push_back(static_cast<int>(v));
  }
  std::vector<std::array<int, 4>> faces;
  faces.reserve(m.face_count());
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::span<const int> face = m.face(f);
    if (face.size() != 4) {
      TextScanner::fail(m.name, m.lines[f],
                        "a face has " + std::to_string(face.size()) +
                            " corners; expected a quad (subdividing makes quads of any polygons)");
    }
    std::array<int, 4>& quad = faces.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) quad[k] = s.from_file[static_cast<std::size_t>(face[k])];
  }
  try {
    s.mesh = QuadMesh::from_faces(static_cast<int>(s.positions.size()), faces);
  } catch (const MeshError& error) {
    const std::string problem = manifold_problem(m);
    throw FileError(problem.empty() ? m.name + ": " + error.what() : problem);
  }
  for (std::size_t v = 0; v < m.same_as.size(); ++v)
    s.from_file[v] = s.from_file[static_cast<std::size_t>(m.same_as[v])];
  s.attributes = std::move(m.attributes);
  return s;
}

Surface to_surface(PolygonMesh polygons, bool subdivided, bool welded) {
  if (welded) weld(polygons);
  if (!subdivided) return to_quad_mesh(std::move(polygons));
  try {
    Surface s = to_quad_mesh(subdivide(polygons));
    s.file_vertices = static_cast<int>(polygons.positions.size());
    return s;
  } catch (const FileError&) {
    if (const std::string problem = manifold_problem(polygons); !problem.empty()) throw FileError(problem);
    throw;
  }
}

}  // namespace requad::mesh
