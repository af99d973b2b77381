// Where a drawing lies on its page. For this room alone.
#pragma once

#include <optional>

#include "mesh/pictures/page.hpp"

namespace requad::pictures {

// A drawing with its place on a page: a point p of it lies at scale * p - low, in points, y upwards.
struct PlacedDrawing {
  Drawing drawing;
  double scale = 1;
  Point low = Point::Zero();
  Point size = Point::Zero();  // of the page

  Point at(const Point& p) const;  // rounded to the grid of the drawing
  // The points of a line on the page, without those that lie on the line between two others.
  Polyline at(const Polyline& line) const;
};
PlacedDrawing placed(const Paint& paint, const Page& page);

// The page as a picture for TikZ.
std::string tikz(const PlacedDrawing& placed, const Page& page);

}  // namespace requad::pictures
