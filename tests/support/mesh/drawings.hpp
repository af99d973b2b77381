// Checks drawings of regions, by other means than mesh/geometry/drawing.hpp.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "mesh/topology/region.hpp"

namespace requad::tests {

// The area of a simple polygon; positive if the polygon is counter-clockwise.
double area(const std::vector<Eigen::Vector2d>& polygon);

// Draws the region. Fails the test unless the boundary is outline(), no quad is turned over or lies on another one, and
// the sine of every angle is larger than this. To exclude overlaps, it compares the sum of the quads' areas, all of
// them positive, with the area of the boundary. The sign of the turn at a corner tells angles below 180 degrees from
// others.
void check_drawing(const mesh::Region& region, double least_sine);

}  // namespace requad::tests
