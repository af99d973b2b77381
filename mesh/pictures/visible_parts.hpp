// Triangles of facets as they are seen, parts of them, and a depth buffer. For hidden_surface.cpp alone.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mesh/pictures/hidden_surface.hpp"

namespace requad::pictures {

using Outline = std::vector<Piece::Corner>;

inline constexpr double kNoOverlap = 1e-4;  // square points: an overlap as small as this decides nothing

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }
double area(const Outline& outline);

// The part of a convex polygon where a linear function, given by its values at the corners, is positive.
template <class Function>
Outline clipped(const Outline& outline, Function&& value) {
  Outline part;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Piece::Corner &p = outline[i], &q = outline[(i + 1) % outline.size()];
    const double at_p = value(p.at), at_q = value(q.at);
    if (at_p > 0) part.push_back(p);
    if ((at_p > 0) == (at_q > 0)) continue;
    const Eigen::Vector2d between = p.at + at_p / (at_p - at_q) * (q.at - p.at);
    part.push_back({between, at_p > 0 ? -1 : p.side});
  }
  return part;
}

// A convex part of a triangle of a facet.
struct Part {
  int facet = 0;
  bool front = true;
  bool live = true;
  int sibling = -1;  // the other triangle of the facet, if both can be painted at once
  Outline outline;   // counter-clockwise
  Eigen::Vector2d low, high;
  Eigen::Vector2d gradient;  // of the depth
  double offset = 0;

  double depth(const Eigen::Vector2d& p) const { return gradient.dot(p - outline.front().at) + offset; }
  Eigen::Vector2d middle() const;
  // The same plane over another outline.
  Part over(Outline other) const;
  void measure();  // sets low and high
};

// The triangles of a facet, without those that are seen edge-on. `index`: of the facet.
std::vector<Part> triangles_of(const Facet& facet, int index);

// The depth of the nearest part at each point of a raster.
class DepthBuffer {
 public:
  // Precondition: there is a part.
  explicit DepthBuffer(const std::vector<Part>& parts);

  // Whether the part covers no point of the raster, or is the nearest at one.
  bool shows(const Part& part) const;

 private:
  template <class Visit>
  void visit(const Part& part, Visit&& visit) const;

  Eigen::Vector2d low_;
  std::size_t width_ = 0;
  std::vector<float> depths_;
};

}  // namespace requad::pictures
