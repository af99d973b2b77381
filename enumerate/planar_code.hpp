// Quadrangulations of the sphere as plantri writes them (Brinkmann and McKay), so that its lists can be read from a pipe:
// `plantri -q 10 | requad-enumerate signature - --plantri`.
//
// Two formats. planar_code is binary: ">>planar_code<<", then for each graph the number of its vertices and, for each
// vertex, the neighbours in clockwise order and a 0; vertices are counted from 1. Numbers are bytes, or two bytes each
// after a first byte 0 (the lower byte first, unless the header says " be"). ASCII (plantri -a) has a line for each graph,
// "8 bcde,afg,...": the number of vertices, then the neighbours as letters from a on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::enumerate {

// All graphs of the text, as meshes. Throws mesh::FileError "name: graph 3: reason" for what is neither format, or for a
// graph that is no simple quadrangulation of a surface. O(size log size).
std::vector<mesh::QuadMesh> parse_plantri(std::string_view text, const std::string& name);

}  // namespace requad::enumerate
