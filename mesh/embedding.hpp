// A drawing of a region in the plane.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "mesh/region.hpp"

namespace requad::mesh {

// Positions by vertex slot (zero for deleted ones). The boundary lies on the unit circle's inscribed polygon with one
// straight side for each side of the region; a region with fewer than three sides gets circular arcs instead. Corners are
// spaced by their sides' lengths on the circle. Interior vertices are at the mean of their neighbours (Tutte), solved by
// a sparse Cholesky factorisation. Precondition: region_problem() is "". About O(V^1.5).
std::vector<Eigen::Vector2d> embed(const Region& region);

}  // namespace requad::mesh
