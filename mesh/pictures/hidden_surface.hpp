// Hidden surface removal for pictures that are made of polygons: SVG and PDF as well as PNG.
//
// Terms
//   facet    A quad as it is seen: corners on the page, each with a depth (the larger, the nearer), all in points. Its
//            surface is two triangles.
//   piece    What is painted at once: a facet, or a convex part of one of its triangles.
//
// Method. Pieces are painted from the back to the front, in an order that is decided pair by pair: where two triangles
// overlap on the page, their depths over the overlap say which is in front. (An order by the depths of their middles
// fails where long facets lie beside short ones.) A triangle that passes through another one is cut along the line
// where they meet. Facets that overlap in a circle are cut until the circle is broken. Facets that are nowhere the
// nearest are dropped first, by a depth buffer; nothing else depends on a raster.
//
// Limits
//   - The points of the depth buffer are 1/4 point apart. A facet that shows only between them is missing.
//   - An overlap of less than 1e-4 square points decides nothing, and nor do depths that differ by less than 1e-4
//     points.
//   - Circles that six rounds of halving do not break are painted by the depths of the pieces' middles.
// Costs. O(n log n + overlaps) for n facets of similar sizes, and 16 values of a depth buffer for each square point.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Core>

namespace requad::pictures {

struct Facet {
  std::array<Eigen::Vector3d, 4> corners;  // x and y on the page, and the depth
  int diagonal = 0;                        // the corner where the diagonal of the triangles starts: 0 or 1
};

struct Piece {
  struct Corner {
    Eigen::Vector2d at;
    int side;  // of the facet, 0..3, on which the line to the next corner lies; -1 if it is a diagonal or a cut
  };
  int facet = 0;                // index
  bool front = true;            // whether the facet's corners run counter-clockwise here, as seen
  std::vector<Corner> outline;  // counter-clockwise
};

class HiddenSurface {
 public:
  explicit HiddenSurface(const std::vector<Facet>& facets);
  ~HiddenSurface();
  HiddenSurface(HiddenSurface&&) noexcept;
  HiddenSurface& operator=(HiddenSurface&&) noexcept;

  // What is to be painted, in the order of painting. The same facets give the same pieces.
  const std::vector<Piece>& pieces() const;
  // Whether pieces lie before the point, by more than 1/100 point, and do not just touch it. About O(1).
  bool covers(const Eigen::Vector3d& point) const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace requad::pictures
