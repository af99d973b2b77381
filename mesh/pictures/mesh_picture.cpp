#include "mesh/pictures/mesh_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/geometry/drawing.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::pictures {

using mesh::FaceId;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::VertexId;

namespace {

// The corners of a star, the first on top. An inner radius of 0 makes a polygon.
Polyline star(Point at, int points, double radius, double inner) {
  Polyline corners;
  const int count = inner > 0 ? 2 * points : points;
  for (int i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * (0.5 + 2.0 * i / count);
    corners.emplace_back(at + (inner > 0 && i % 2 == 1 ? inner : radius) * Point(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

double distance(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double t = along.squaredNorm() > 0 ? std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

}  // namespace

void mark_vertex(Canvas& canvas, Point at, int valence, double radius) {
  mark_vertex(canvas, at, valence, radius, canvas.palette().valence(valence), canvas.palette().ink);
}

void mark_vertex(Canvas& canvas, Point at, int valence, double radius, Colour fill, Colour outline) {
  Polyline shape;
  if (valence == 2) {
    shape = {at + Point(radius, 0), at + Point(0, 0.62 * radius), at - Point(radius, 0), at - Point(0, 0.62 * radius)};
  } else if (valence < 7) {
    shape = star(at, std::max(valence, 3), radius, 0);
  } else {
    shape = star(at, valence, 1.5 * radius, 0.85 * radius);
  }
  canvas.polygon(shape, fill, Stroke{outline, 0.1 * radius});
}

void mark_star(Canvas& canvas, Point at, double radius, Colour colour) {
  canvas.polygon(star(at, 5, radius, 0.42 * radius), colour, Stroke{canvas.palette().ink, 0.1 * radius});
}

MeshPicture::MeshPicture(mesh::Region region, Point centre, double unit, double angle)
    : region_(std::move(region)), at_(mesh::draw(region_)) {
  Eigen::Matrix2d rotation;
  rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  bool first = true;
  for (const VertexId v : mesh().vertices()) {
    Point& p = at_[v.slot()];
    p = rotation * p * unit + centre;
    low_ = first ? p : Point(low_.cwiseMin(p));
    high_ = first ? p : Point(high_.cwiseMax(p));
    first = false;
  }
}

MeshPicture MeshPicture::moved(const Point& by) const {
  MeshPicture result = *this;
  for (const VertexId v : mesh().vertices()) result.at_[v.slot()] += by;
  result.low_ += by;
  result.high_ += by;
  return result;
}

Point MeshPicture::middle(FaceId f) const {
  Point sum = Point::Zero();
  for (const VertexId v : mesh().corners(f)) sum += at(v);
  return sum / 4;
}

void MeshPicture::faces(Canvas& canvas, std::span<const FaceId> faces, Colour colour) const {
  std::vector<Polyline> quads;
  for (const FaceId f : faces) {
    Polyline quad;
    for (const VertexId v : mesh().corners(f)) quad.push_back(at(v));
    quads.push_back(std::move(quad));
  }
  canvas.fill(quads, colour);
}

// The point of a quad that is furthest from its sides and from the marks of its corners, of 81 points, and how far that
// is.
std::pair<Point, double> MeshPicture::roomiest(FaceId f) const {
  constexpr int kSteps = 10;
  const auto c = mesh().corners(f);
  std::pair<Point, double> best{middle(f), 0};
  for (int i = 1; i < kSteps; ++i) {
    for (int j = 1; j < kSteps; ++j) {
      const double u = static_cast<double>(i) / kSteps, v = static_cast<double>(j) / kSteps;
      const Point p = (1 - v) * ((1 - u) * at(c[0]) + u * at(c[1])) + v * ((1 - u) * at(c[3]) + u * at(c[2]));
      double room = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < 4; ++k) {
        room = std::min(room, distance(p, at(c[k]), at(c[(k + 1) % 4])));
        if (is_irregular(mesh(), c[k])) room = std::min(room, (p - at(c[k])).norm() - mark_radius(c[k]));
      }
      if (room > best.second + 1e-6) best = {p, room};
    }
  }
  return best;
}

void MeshPicture::signs(Canvas& canvas, std::span<const FaceId> faces, Colour colour, double turned) const {
  constexpr double kLongest = 5, kGap = 1;
  std::vector<Polyline> lines;
  for (const FaceId f : faces) {
    const auto [centre, room] = roomiest(f);
    const double arm = std::min(kLongest, std::max(room - kGap, 0.7 * room));
    for (const double angle : {turned, turned + std::numbers::pi / 2}) {
      const Point end = arm * Point(std::cos(angle), std::sin(angle));
      lines.push_back({centre - end, centre + end});
    }
  }
  canvas.stroke(lines, {colour, 0.9});
}

void MeshPicture::made(Canvas& canvas, std::span<const FaceId> f) const {
  faces(canvas, f, canvas.palette().made);
  signs(canvas, f, canvas.palette().made_sign, 0);
}

void MeshPicture::deleted(Canvas& canvas, std::span<const FaceId> f) const {
  faces(canvas, f, canvas.palette().deleted);
  signs(canvas, f, canvas.palette().deleted_sign, std::numbers::pi / 4);
}

void MeshPicture::edges(Canvas& canvas, Colour colour, double width) const {
  std::vector<bool> drawn(static_cast<std::size_t>(mesh().half_edge_capacity()), false);
  std::vector<Polyline> lines;
  for (const HalfEdgeId h : mesh().half_edges()) {
    if (mesh().is_boundary(h) || drawn[h.slot()]) continue;
    const auto forth = mesh::trace(mesh(), h).path;
    const auto back = mesh::trace(mesh(), mesh().twin(h)).path;
    // From the end of `back` through the origin of h to the end of `forth`.
    Polyline line;
    for (auto it = back.rbegin(); it != back.rend(); ++it) line.push_back(at(mesh().target(*it)));
    for (const HalfEdgeId g : forth) line.push_back(at(mesh().target(g)));
    for (const auto* path : {&forth, &back}) {
      for (const HalfEdgeId g : *path) {
        drawn[g.slot()] = true;
        if (!mesh().is_boundary(g)) drawn[mesh().twin(g).slot()] = true;
      }
    }
    lines.push_back(std::move(line));
  }
  canvas.stroke(lines, {colour, width});
  boundary(canvas, {colour, 2 * width});
}

Polyline MeshPicture::outline() const {
  Polyline line;
  for (const HalfEdgeId h : mesh::boundary_loop(mesh(), region_.root)) line.push_back(at(mesh().origin(h)));
  return line;
}

void MeshPicture::background(Canvas& canvas, Colour colour) const { canvas.fill({outline()}, colour); }

void MeshPicture::boundary(Canvas& canvas, const Stroke& stroke) const { canvas.stroke({outline()}, stroke, true); }

Polyline MeshPicture::line(std::span<const HalfEdgeId> half_edges) const {
  if (half_edges.empty()) return {};
  Polyline line{at(mesh().origin(half_edges.front()))};
  for (const HalfEdgeId h : half_edges) line.push_back(at(mesh().target(h)));
  return line;
}

void MeshPicture::path(Canvas& canvas, std::span<const HalfEdgeId> half_edges, const Stroke& stroke) const {
  if (!half_edges.empty()) canvas.stroke({line(half_edges)}, stroke);
}

double MeshPicture::mark_radius(VertexId v) const {
  double radius = kMarkRadius;
  mesh().for_each_out(v,
                      [&](HalfEdgeId h) { radius = std::min(radius, 0.42 * (at(mesh().target(h)) - at(v)).norm()); });
  return radius;
}

void MeshPicture::irregular(Canvas& canvas) const {
  for (const VertexId v : mesh::irregular_vertices(mesh()))
    mark_vertex(canvas, at(v), mesh().valence(v), mark_radius(v));
}

void MeshPicture::faint_irregular(Canvas& canvas) const {
  for (const VertexId v : mesh::irregular_vertices(mesh()))
    mark_vertex(canvas, at(v), mesh().valence(v), mark_radius(v), canvas.palette().paper, canvas.palette().faint_ink);
}

}  // namespace requad::pictures
