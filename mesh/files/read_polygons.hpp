// Reads polygon meshes from OBJ and OFF files.
//
// What is read
//   OBJ   `v` and `f` (or `fo`) lines. A corner is v, v/vt, v//vn or v/vt/vn; v is counted from 1, or, if negative,
//         back from the last vertex so far. attributes.hpp says what else is kept. Further numbers of a vertex (weight,
//         colour) must be numbers; they may be NaN.
//   OFF   The text format, with its keyword ([ST][C][N]OFF) or without, indices from 0, and line ends anywhere. What
//         follows a vertex (colours, normals, texture coordinates) or a face (a colour) must be numbers, which are
//         dropped. Many files depart from the format: further numbers without a keyword that says so, several faces on
//         a line. So a text is read in up to four ways (read_off.cpp), and the first that takes every word is right. A
//         refusal is that of the first way: a vertex a line, and colours up to the line's end. Binary OFF is refused.
//   Both  A number that is too small for a double is 0.
// The end of the file's name says which format it is, and the first word must agree. Of a name without such an end, and
// of standard input, the first word decides. text_scanner.hpp says what lines, words and comments are.
//
// Laws
//   files-1  Vertices and faces come in the file's order, and the corners of a face in its line's order.
//   files-2  A mesh that is returned has at least one face. Each face has at least three corners, which differ and
//            exist. Each coordinate is finite and at most kLargestCoordinate in size.
//   files-3  Any other file, and a file that cannot be read, is refused by a FileError, "file:line: reason".
//   files-4  Memory is proportional to the size of the file, whatever a header in it promises.
// Why not tinyobjloader: it takes a malformed number for 0, and it does not know the line (laws files-2 and files-3).
// Cost: O(size); about half a second for a million quads, and as much again to make a quad mesh of them.
#pragma once

#include <string>
#include <string_view>

#include "mesh/files/polygon_mesh.hpp"
#include "mesh/text/file_error.hpp"

namespace requad::mesh {

// By the end of the name, .obj or .off in any case, or by the first word. "-" is standard input.
PolygonMesh read_polygon_mesh(const std::string& path);
// The same for a text in memory, which was a file of this name.
PolygonMesh parse_polygon_mesh(std::string_view text, const std::string& name);
// In one of the formats; `name` stands for the file in messages.
PolygonMesh parse_obj(std::string_view text, const std::string& name);
PolygonMesh parse_off(std::string_view text, const std::string& name);

}  // namespace requad::mesh
