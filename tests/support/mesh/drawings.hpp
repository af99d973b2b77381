// What a drawing of a region must be, looked at by other means than mesh/geometry/drawing.hpp does.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "mesh/topology/region.hpp"

namespace requad::tests {

// Of a simple polygon; positive if it is counter-clockwise.
double area(const std::vector<Eigen::Vector2d>& polygon);

// Draws the region and fails the test unless the boundary is outline(), no quad is turned over or lies on another, and
// every angle's sine is more than this. The areas of the quads are all positive and add up to that of the boundary; an
// angle of less than 180 degrees is told by the sign of its turn.
void check_drawing(const mesh::Region& region, double least_sine);

}  // namespace requad::tests
