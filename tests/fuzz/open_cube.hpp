// The mesh to which scripts and lists of features are applied: a cube without its top, with four quads on each side.
#pragma once

#include "mesh/files/read_polygons.hpp"
#include "mesh/files/surface.hpp"

namespace requad::fuzz {

inline const mesh::Surface& open_cube() {
  static const mesh::Surface surface = mesh::to_quad_mesh(
      mesh::subdivide(mesh::parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                                      "f 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n",
                                      "cube")));
  return surface;
}

}  // namespace requad::fuzz
