// Surfaces that are made of a region by cutting out quads and by doubling, and moves on them. Private to this folder.
#pragma once

#include <string>
#include <vector>

#include "mesh/irregular/pair_moves.hpp"
#include "mesh/topology/region.hpp"

namespace requad::verify {

// A surface that is made of a region, with the Euler characteristic that it has by its making.
struct MadeSurface {
  mesh::QuadMesh mesh;
  int euler = 1;
};

// Disks with up to two holes, and their doubles: an annulus, a sphere, a torus, a surface of genus two. A hole is a face
// whose corners lie inside; two holes have no corner in common. A double is two copies, the second one mirrored, joined
// by a strip of quads along each boundary. O(F) for each.
std::vector<MadeSurface> surfaces_from(const mesh::Region& region);

// What claim P6 says of one move on a closed surface, which left `after` and this report: what is wrong, or "".
std::string surface_move_problem(const mesh::QuadMesh& before, const mesh::PairMove& move, const mesh::QuadMesh& after,
                                 const mesh::MoveReport& report);

}  // namespace requad::verify
