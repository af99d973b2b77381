// A mesh as a part of a picture.
#pragma once

#include <vector>

#include "mesh/topology/region.hpp"
#include "verify/report/svg.hpp"

namespace requad::verify {

// The region as mesh::draw() draws it, turned counter-clockwise by an angle in radians, fitted into a box and marked.
class MeshDrawing {
 public:
  MeshDrawing(const mesh::Region& region, const Point& centre, const Point& room, double angle = 0);

  // Draws the mesh with its irregular vertices. The faces `alpha` are R_alpha.
  void draw(Svg& svg, const std::vector<mesh::FaceId>& alpha, double mark) const;
  double low() const { return low_; }  // y of the lower end

 private:
  const mesh::Region& region_;
  std::vector<Point> at_;  // by vertex slot
  double low_ = 0;
};

}  // namespace requad::verify
