// Polygon meshes in OBJ and OFF files, and the way from there to a quad mesh.
//
// What is read
//   OBJ   `v` and `f` lines; corners as v, v/vt, v//vn or v/vt/vn, counted from 1 or, negative, back from the last
//         vertex so far. Everything else (normals, texture coordinates, groups, materials, lines, curves) is skipped.
//         A vertex's fourth and further numbers (weight, colour) must be numbers and are dropped.
//   OFF   the text format, one vertex or face in a line, indices from 0; also NOFF, COFF, STOFF, whose further numbers,
//         like the colours of faces, are dropped.
// The name's ending says which it is, and the first word must agree. See text_scanner.hpp for lines and comments.
//
// Laws
//   F1  Vertices and faces come in the file's order, a face's corners in its line's order from its first.
//   F2  A file that is read has at least one face; each has at least three corners, which differ and exist;
//       coordinates are within 1e70 of 0.
//   F3  Anything else is one line "file:line: reason", a FileError; so is a file that can not be read.
//   F4  Memory is proportional to the file's size, whatever a header promises.
// Why not tinyobjloader: it takes a malformed number for 0 and does not know in which line it stood (laws F2, F3).
// Cost: O(size); about half a second for a million quads, and as much again to make a quad mesh of them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/files/file_error.hpp"
#include "mesh/geometry/measures.hpp"
#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

// Products of four lengths, which geometry takes, are finite still.
constexpr double kLargestCoordinate = 1e70;

struct PolygonMesh {
  std::string name;     // the file, for messages
  int first_index = 1;  // what the file's format calls its first vertex, for messages
  Positions positions;
  std::vector<int> corners;       // vertices, 0-based, of all faces one after the other
  std::vector<std::size_t> ends;  // per face, where its corners end; the next face's begin there
  std::vector<int> lines;         // per face, the line where it starts

  std::size_t face_count() const { return ends.size(); }
  std::span<const int> face(std::size_t f) const {
    const std::size_t begin = f == 0 ? 0 : ends[f - 1];
    return {corners.data() + begin, ends[f] - begin};
  }
  void add_face(std::span<const int> face, int line) {
    corners.insert(corners.end(), face.begin(), face.end());
    ends.push_back(corners.size());
    lines.push_back(line);
  }
};

PolygonMesh read_polygon_mesh(const std::string& path);
// The same for a text at hand; `name` stands for it in messages.
PolygonMesh parse_obj(std::string_view text, const std::string& name);
PolygonMesh parse_off(std::string_view text, const std::string& name);

// Why the faces, of any number of corners, are no oriented manifold, as "file:line: reason", the line of a face; "" if
// they are one. Reasons: an edge with three faces or more; faces of an orientable surface that are not oriented alike;
// a one-sided surface (a Moebius band); a vertex whose faces form more than one fan. O(E log E).
std::string manifold_problem(const PolygonMesh& mesh);

// Cuts each n-gon into n quads: one round each corner, which is the quad's first. Vertices: the given ones, untouched,
// then an edge's midpoint for each edge in the order in which faces first come to it, then each face's mean of corners.
// V' = V + E + F, F' = sum of n. Lines are kept. O(E log E).
PolygonMesh subdivide(const PolygonMesh& mesh);

// A quad mesh with positions.
struct Surface {
  QuadMesh mesh;
  Positions positions;           // by vertex slot
  std::vector<int> file_vertex;  // by vertex slot: the vertex of the polygon mesh, 0-based
  std::vector<int> from_file;    // by vertex of the polygon mesh: the slot, or -1 if no face has it
  int dropped = 0;               // vertices that no face has: a QuadMesh has none such
  int file_vertices = 0;         // how many the file has: the first of from_file, which has more if it was subdivided
};

// Vertices that no face has are dropped, the others keep their order; face i is FaceId(i) with its first corner first.
// Throws FileError, one line as in F3: a face that is no quad, or the manifold_problem().
Surface to_quad_mesh(const PolygonMesh& mesh);

// From the file to the mesh: what a program does with a file it is given.
Surface read_surface(const std::string& path, bool subdivided);

}  // namespace requad::mesh
