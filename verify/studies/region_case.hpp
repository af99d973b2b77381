// A case of a campaign: one convex region and the irregular vertices that it holds.
//
// Terms
//   pair       two irregular vertices of the paper's three types: 3-3, 5-5 or 3-5.
//   vertex     a single irregular vertex of valence k, which is also the number of sides; valence 4 is a regular grid.
//   triple     three irregular vertices, each a v3 or a v5.
//   family     cases that are listed and reported together.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "theory/region_shape.hpp"

namespace requad::verify {

struct PairCase {
  theory::RegionShape shape;
};

struct VertexCase {
  theory::IntegerVector sides;

  int valence() const { return static_cast<int>(sides.size()); }
};

struct TripleCase {
  std::vector<int> valences;  // three, the lesser first
  theory::IntegerVector sides;
};

using RegionCase = std::variant<PairCase, VertexCase, TripleCase>;

enum class Family { regular_digon, regular_hexagon, quad, other_digon, other_hexagon, single_vertex, three_vertices };
const char* name(Family family);  // "regular digons", ...

// Precondition: the shape of a pair is that of a digon, a hexagon or a 3-5 region.
Family family_of(const RegionCase& region);
const theory::IntegerVector& sides_of(const RegionCase& region);
// "5-5 region with sides 3 3 3 3 3 3".
std::string describe(const RegionCase& region);

}  // namespace requad::verify
