#include "verify/report/mesh_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "mesh/geometry/drawing.hpp"

namespace requad::verify {

using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::VertexId;

namespace {

// A regular polygon that stands on its lower side; a rhombus for valence 2.
Polyline polygon(const Point& centre, int corners, double radius) {
  using std::numbers::pi;
  if (corners == 2)
    return {centre + Point(0.8 * radius, 0), centre + Point(0, 1.3 * radius), centre - Point(0.8 * radius, 0),
            centre - Point(0, 1.3 * radius)};
  const double reach = corners == 3 ? 1.3 * radius : 1.1 * radius;
  Polyline points;
  for (int i = 0; i < corners; ++i) {
    const double angle = pi / 2 + 2 * pi * i / corners;
    points.push_back(centre + reach * Point(std::cos(angle), std::sin(angle)));
  }
  return points;
}

}  // namespace

MeshDrawing::MeshDrawing(const mesh::Region& region, const Point& centre, const Point& room, double angle)
    : region_(region), at_(mesh::draw(region)) {
  const Eigen::Rotation2D<double> turn(angle);
  const std::vector<HalfEdgeId> loop = mesh::boundary_loop(region.mesh, region.root);
  Point low = turn * at_[region.mesh.origin(loop.front()).slot()], high = low;
  for (Point& p : at_) p = turn * p;
  for (const HalfEdgeId h : loop) {
    low = low.cwiseMin(at_[region.mesh.origin(h).slot()]);
    high = high.cwiseMax(at_[region.mesh.origin(h).slot()]);
  }
  const double scale = (room.array() / (high - low).array()).minCoeff();
  const Point middle = (low + high) / 2;
  for (Point& p : at_) p = centre + scale * (p - middle);
  low_ = centre.y() - scale * (high.y() - low.y()) / 2;
}

void MeshDrawing::draw(Svg& svg, const std::vector<mesh::FaceId>& alpha, double mark) const {
  const QuadMesh& m = region_.mesh;
  const auto at = [&](VertexId v) { return at_[v.slot()]; };
  Polyline outline;
  for (const HalfEdgeId h : mesh::boundary_loop(m, region_.root)) outline.push_back(at(m.origin(h)));
  std::vector<Polyline> quads, edges;
  for (const mesh::FaceId f : alpha) {
    Polyline& quad = quads.emplace_back();
    for (const VertexId v : m.corners(f)) quad.push_back(at(v));
  }
  for (const mesh::FaceId f : m.faces()) {
    for (int k = 0; k < 4; ++k) {
      const HalfEdgeId h = QuadMesh::half_edge(f, k);
      if (!m.is_boundary(h) && m.twin(h).index() > h.index()) edges.push_back({at(m.origin(h)), at(m.target(h))});
    }
  }
  svg.open("mesh");
  svg.path("ground", {outline}, Ends::closed);
  if (!quads.empty()) svg.path("alpha", quads, Ends::closed);
  svg.path("edges", edges);
  svg.path("rim", {outline}, Ends::closed);
  for (const VertexId v : mesh::irregular_vertices(m)) {
    const int valence = m.valence(v);
    svg.path("vertex v" + std::to_string(std::min(valence, 6)), {polygon(at(v), valence, mark)}, Ends::closed);
  }
  svg.close();
}

}  // namespace requad::verify
