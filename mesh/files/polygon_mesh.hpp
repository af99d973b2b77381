// A mesh of polygons as a file describes it: positions and faces, not yet checked to be a surface.
//
// Terms, for everything in this room
//   face       a list of three or more different vertices, its corners, in order. Neighbours in the list, and the last
//              and the first, are joined by an edge.
//   fan        faces round one vertex of which each shares an edge at that vertex with the next.
//   manifold   no edge has more than two faces, and the faces at each vertex form one fan. Boundaries are allowed.
//   oriented   two faces that share an edge run along it in opposite directions.
//   line       the line of the file in which a face starts. Messages are "file:line: reason".
// From a file to a quad mesh: read_polygons.hpp reads a PolygonMesh; subdivide() makes quads of its faces, if that is
// asked for; surface.hpp makes a QuadMesh of it, or says why it is none.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/files/attributes.hpp"
#include "mesh/geometry/measures.hpp"

namespace requad::mesh {

struct PolygonMesh {
  std::string name;     // the file, for messages
  int first_index = 1;  // the number that the file's format gives its first vertex, for messages
  Positions positions;
  std::vector<int> corners;       // vertices, 0-based, of all faces one after the other
  std::vector<std::size_t> ends;  // by face: where its corners end and those of the next face begin
  std::vector<int> lines;         // by face: the line in which it starts
  std::vector<int> same_as;       // by vertex: the one with which it was welded (welding.hpp); empty if none was
  Attributes attributes;

  std::size_t face_count() const { return ends.size(); }
  std::span<const int> face(std::size_t f) const {
    return {corners.data() + first_corner(f), ends[f] - first_corner(f)};
  }
  // Where the corners of face f begin in `corners`.
  std::size_t first_corner(std::size_t f) const { return f == 0 ? 0 : ends[f - 1]; }
  void add_face(std::span<const int> face, int line) {
    corners.insert(corners.end(), face.begin(), face.end());
    ends.push_back(corners.size());
    lines.push_back(line);
  }
  // What the file calls vertex v.
  std::string vertex_name(int v) const { return std::to_string(v + first_index); }
};

// Why the faces do not form an oriented manifold, as "file:line: reason" with the line of a face; "" if they do.
// Reasons: a face that stands twice; an edge with three faces or more; faces of an orientable surface that are not
// oriented alike; a one-sided surface (a Moebius band); a vertex whose faces form more than one fan. O(E log E).
std::string manifold_problem(const PolygonMesh& mesh);

// Cuts each n-gon into n quads, one at each corner, which becomes the quad's first corner. The vertices are the given
// ones, untouched; then the midpoint of each edge, in the order in which the faces first come to it; then the mean of
// the corners of each face. V' = V + E + F, and F' is the sum of all n. A quad has the line and the state of its face.
// Values and colours of new vertices are means, and tags of edges hold for both halves. O(E log E).
PolygonMesh subdivide(const PolygonMesh& mesh);

}  // namespace requad::mesh
