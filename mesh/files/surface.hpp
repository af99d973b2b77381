// A quad mesh with positions, and how its vertices correspond to those of the file that it was read from.
#pragma once

#include <string>
#include <vector>

#include "mesh/files/polygon_mesh.hpp"
#include "mesh/geometry/measures.hpp"
#include "mesh/text/file_error.hpp"
#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

struct Surface {
  QuadMesh mesh;
  Positions positions;           // by vertex slot
  std::vector<int> file_vertex;  // by vertex slot: the vertex of the polygon mesh, 0-based
  // By vertex of the polygon mesh: its slot, or that of the vertex with which it was welded; -1 if no face has it.
  std::vector<int> from_file;
  int dropped = 0;             // number of vertices that no face has; a QuadMesh has no such vertices
  Positions unused = {};       // theirs, in the file's order
  Attributes attributes = {};  // of the polygon mesh: its vertices; its faces and corners, which are those of `mesh`
  // Number of vertices in the file. They come first in `from_file`, which is longer if the file's faces were
  // subdivided.
  int file_vertices = 0;
};

// Vertices that no face has are dropped, and the others keep their order. Face i becomes FaceId(i), with its first
// corner first. Throws FileError, "file:line: reason": a face that is not a quad, or the manifold_problem().
// O(F), and O(F log F) for a reason.
Surface to_quad_mesh(PolygonMesh mesh);

// Welds the vertices (welding.hpp) and subdivides the faces if that is asked for, and makes a quad mesh of them. Reasons
// are in terms of the file, which knows none of the new vertices.
Surface to_surface(PolygonMesh mesh, bool subdivided, bool welded = false);
// The same for a file (read_polygons.hpp).
Surface read_surface(const std::string& path, bool subdivided, bool welded = false);

}  // namespace requad::mesh
