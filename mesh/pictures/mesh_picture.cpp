#include "mesh/pictures/mesh_picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/geometry/drawing.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::pictures {

using mesh::FaceId;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::VertexId;

Colour valence_colour(int valence) {
  switch (valence) {
    case 2: return ink::kPurple;
    case 3: return ink::kBlue;
    case 5: return ink::kOrange;
    default: return ink::kRed;
  }
}

void mark_vertex(Canvas& canvas, Point at, int valence, double radius) {
  Polyline shape;
  const int corners = std::max(valence, 3);
  if (valence == 2) {
    shape = {at + Point(radius, 0), at + Point(0, 0.62 * radius), at - Point(radius, 0), at - Point(0, 0.62 * radius)};
  } else {
    for (int i = 0; i < corners; ++i) {
      const double angle = std::numbers::pi * (0.5 + 2.0 * i / corners);
      shape.emplace_back(at + radius * Point(std::cos(angle), std::sin(angle)));
    }
  }
  canvas.polygon(shape, valence_colour(valence), Stroke{ink::kBlack, 0.1 * radius});
}

void mark_star(Canvas& canvas, Point at, double radius, Colour colour) {
  Polyline star;
  for (int i = 0; i < 10; ++i) {
    const double angle = std::numbers::pi * (0.5 + i / 5.0);
    star.emplace_back(at + (i % 2 == 0 ? radius : 0.42 * radius) * Point(std::cos(angle), std::sin(angle)));
  }
  canvas.polygon(star, colour, Stroke{ink::kBlack, 0.1 * radius});
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

void MeshPicture::crosses(Canvas& canvas, std::span<const FaceId> faces, Colour colour, bool upright) const {
  std::vector<Polyline> lines;
  for (const FaceId f : faces) {
    const auto c = mesh().corners(f);
    const Point centre = middle(f);
    for (std::size_t k = 0; k < 2; ++k) {
      const Point end = upright ? Point((at(c[k]) + at(c[k + 1])) / 2) : at(c[k]);
      const Point other = upright ? Point((at(c[k + 2]) + at(c[(k + 3) % 4])) / 2) : at(c[k + 2]);
      lines.push_back({centre + 0.5 * (end - centre), centre + 0.5 * (other - centre)});
    }
  }
  canvas.stroke(lines, {colour, 0.9});
}

void MeshPicture::made(Canvas& canvas, std::span<const FaceId> f) const {
  faces(canvas, f, ink::kYellow);
  crosses(canvas, f, rgb(0x6b6200), true);
}

void MeshPicture::deleted(Canvas& canvas, std::span<const FaceId> f) const {
  faces(canvas, f, ink::kPaleRed);
  crosses(canvas, f, rgb(0x7a2000), false);
}

void MeshPicture::edges(Canvas& canvas, double width, Colour colour) const {
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

void MeshPicture::path(Canvas& canvas, std::span<const HalfEdgeId> half_edges, const Stroke& stroke) const {
  if (half_edges.empty()) return;
  Polyline line{at(mesh().origin(half_edges.front()))};
  for (const HalfEdgeId h : half_edges) line.push_back(at(mesh().target(h)));
  canvas.stroke({line}, stroke);
}

void MeshPicture::irregular(Canvas& canvas, double radius) const {
  for (const VertexId v : mesh::irregular_vertices(mesh())) mark_vertex(canvas, at(v), mesh().valence(v), radius);
}

}  // namespace requad::pictures
