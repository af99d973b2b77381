// Checks a mesh file that is accepted: laws files-1 and files-2 (read_polygons.hpp), and files-5 (write_obj.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/files/read_polygons.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace requad::fuzz {

inline bool same_bits(const mesh::Positions& a, const mesh::Positions& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](const auto& p, const auto& q) { return mesh::same_bits(p, q); });
}

inline void check_polygons(const mesh::PolygonMesh& m) {
  require(m.face_count() > 0, "a mesh without a face");
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    const std::set<int> corners(m.face(f).begin(), m.face(f).end());
    require(corners.size() >= 3 && corners.size() == m.face(f).size(), "a face of less than three different corners");
    require(*corners.begin() >= 0 && *corners.rbegin() < static_cast<int>(m.positions.size()), "no such vertex");
  }
  for (const auto& p : m.positions) require(p.cwiseAbs().maxCoeff() <= mesh::kLargestCoordinate, "a large coordinate");
}

inline void check_surface(const mesh::Surface& s) {
  require(mesh::validate(s.mesh).empty(), "the mesh is not valid");
  const mesh::Surface again =
      mesh::to_quad_mesh(mesh::parse_obj(mesh::obj_text(s.mesh, s.positions), "what was written"));
  require(again.mesh == s.mesh && same_bits(again.positions, s.positions), "what was written reads differently");
}

// `parse` is parse_obj or parse_off.
template <class Parse>
void try_reader(std::string_view text, Parse&& parse) {
  mesh::PolygonMesh polygons;
  if (!accepts([&] { polygons = parse(text, "file"); })) return;
  check_polygons(polygons);
  for (const bool subdivided : {false, true}) {
    mesh::Surface surface;
    if (accepts([&] { surface = mesh::to_quad_mesh(subdivided ? mesh::subdivide(polygons) : polygons); })) {
      require(mesh::manifold_problem(polygons).empty(), "a mesh of polygons that are no manifold");
      check_surface(surface);
    }
  }
}

}  // namespace requad::fuzz
