// Selections of the editor's session, and its surfaces, for tests.
#pragma once

#include <string>

#include "mesh/files/write_obj.hpp"
#include "mesh/web/session.hpp"
#include "tests/support/programs.hpp"

namespace requad::tests {

inline mesh::Surface surface_of(const std::string& path) { return web::Session::read(slurp(path), path, false); }
// The surface of a region in the plane.
inline mesh::Surface surface_of(const mesh::Region& region) {
  return web::Session::read(mesh::obj_text(region), "region.obj", false);
}

inline web::Selection one_vertex(mesh::VertexId v) { return {web::Selection::Kind::vertex, v, {}, {}}; }
inline web::Selection a_pair(mesh::VertexId a, mesh::VertexId b) { return {web::Selection::Kind::pair, a, b, {}}; }
inline web::Selection an_edge(mesh::VertexId a, mesh::VertexId b) { return {web::Selection::Kind::edge, a, b, {}}; }
inline web::Selection a_quad(mesh::FaceId f) { return {web::Selection::Kind::quad, {}, {}, f}; }

}  // namespace requad::tests
