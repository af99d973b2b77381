#include "figures/pictures/grid_picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/geometry/drawing.hpp"
#include "mesh/pictures/mesh_picture.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::figures {

namespace {

constexpr double kText = 11;

Stroke grid_stroke(const Grid& grid) {
  return {grid.colour(), 1.6, grid.parity == Parity::odd ? std::vector<double>{5, 3.5} : std::vector<double>{}};
}

Point at(const GridNode& node, double spacing) { return spacing * Point(node.at[0], node.at[1]); }

// The grid unit, and the room for a mesh at a node. All are in points.
struct Sizes {
  double spacing;
  double width;
  double height;
};
Sizes sizes(theory::PairType type) {
  if (type == theory::kDigon) return {104, 158, 84};
  if (type == theory::kHexagon) return {132, 110, 110};
  return {128, 112, 106};
}

// The half-edge at which the drawing starts. A 3-5 region lies as its grid does, with side 1 on the left and side 2
// below.
mesh::HalfEdgeId lowest_side(const GridNode& node, theory::PairType type) {
  mesh::HalfEdgeId h = node.region.root;
  if (type.symmetric()) return h;
  const std::vector<int> sides = mesh::side_lengths(node.region);
  int edges = 0;
  for (int side = 0; side < node.configuration.p; ++side) edges += sides[static_cast<std::size_t>(side) % sides.size()];
  for (int i = 0; i < edges; ++i) h = node.region.mesh.next_on_boundary(h);
  return h;
}

MeshPicture picture_of(const GridNode& node, theory::PairType type, const Sizes& size) {
  mesh::Region region = node.region;
  region.root = lowest_side(node, type);
  // A hexagon stands on a corner, so that the segment of (x,0,p) lies along the axis of its node.
  const double angle = type == theory::kHexagon ? std::numbers::pi / 2 : 0;
  const MeshPicture probe(region, Point::Zero(), 1, angle);
  const Point extent = probe.high() - probe.low();
  return {region, at(node, size.spacing), std::min(size.width / extent.x(), size.height / extent.y()), angle};
}

void paint_stars(Canvas& canvas, const MeshPicture& picture, const GridNode& node) {
  const std::vector<mesh::HalfEdgeId> out = mesh::outward(picture.mesh(), node.frame);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto path = mesh::trace(picture.mesh(), out[i]).path;
    picture.path(canvas, path, {i == 0 ? ink::kOrange : ink::kRed, 1.1, {2, 1.5}});
    mark_star(canvas, picture.at(picture.mesh().target(path.back())), 5, i == 0 ? ink::kYellow : ink::kRed);
  }
}

void paint_node(Canvas& canvas, const GridFigure& figure, const GridNode& node, const Sizes& size) {
  const Grid& grid = figure.grids[static_cast<std::size_t>(node.grid)];
  const MeshPicture picture = picture_of(node, grid.shape.type(), size);
  const bool copy = node.same_as >= 0;
  picture.background(canvas, rgb(0xffffff));
  if (!copy) {
    picture.faces(canvas, mesh::ring(picture.mesh(), node.frame), ink::kGrey);
    picture.faces(canvas, mesh::grid(picture.mesh(), node.frame).value(), ink::kPaleBlue);
  }
  picture.edges(canvas, 0.45, copy ? ink::kFaint : ink::kLine);
  picture.irregular(canvas, 4.6);
  if (!grid.shape.type().symmetric()) paint_stars(canvas, picture, node);
  std::string label = node.label;
  if (copy) label += " = " + figure.nodes[static_cast<std::size_t>(node.same_as)].label;
  const double width = 0.56 * kText * static_cast<double>(label.size());
  const double gap = grid.shape.type().symmetric() ? kText : kText + 4;  // below a star
  const Point below((picture.low().x() + picture.high().x()) / 2, picture.low().y() - gap);
  canvas.polygon({below + Point(-width / 2, -2.5), below + Point(width / 2, -2.5), below + Point(width / 2, kText - 2),
                  below + Point(-width / 2, kText - 2)},
                 rgb(0xffffff), {});
  canvas.text(below, label, kText, grid.colour());
}

}  // namespace

Paint paint_grid(const GridFigure& figure) {
  return [figure](Canvas& canvas) {
    const Sizes size = sizes(figure.grids.at(0).shape.type());
    for (const GridEdge& edge : figure.edges) {
      const GridNode& from = figure.nodes[static_cast<std::size_t>(edge.from)];
      const GridNode& to = figure.nodes[static_cast<std::size_t>(edge.to)];
      canvas.stroke({{at(from, size.spacing), at(to, size.spacing)}},
                    grid_stroke(figure.grids[static_cast<std::size_t>(from.grid)]));
    }
    for (const GridNode& node : figure.nodes) paint_node(canvas, figure, node, size);
  };
}

Paint paint_dual(const GridFigure& figure) {
  return [figure](Canvas& canvas) {
    constexpr double kLevel = 54;  // points between levels
    const int quadrants = figure.grids.at(0).shape.type().rotation_count();
    const auto angle = [quadrants](const theory::Configuration& c) {
      const auto level = static_cast<double>(c.d1() + c.d2());
      return 2 * std::numbers::pi * (0.25 - (c.p - static_cast<double>(c.d2()) / level) / quadrants);
    };
    for (const GridEdge& edge : figure.edges) {
      const GridNode& from = figure.nodes[static_cast<std::size_t>(edge.from)];
      const Stroke stroke = grid_stroke(figure.grids[static_cast<std::size_t>(from.grid)]);
      // Along an edge, radius and angle change evenly, by the smaller of the two angles. An edge within a level is an
      // arc. On level 1 of a digon it is a whole circle.
      const theory::Integer inner = edge.before.d1() + edge.before.d2(), outer = edge.after.d1() + edge.after.d2();
      double first = angle(edge.before), last = angle(edge.after);
      if (inner == outer) {
        const double width = 2 * std::numbers::pi / (static_cast<double>(inner) * quadrants);
        // Labels of neighbouring quadrants differ by whole turns.
        if (last < first) std::swap(first, last);
        if (last - first > 1.5 * width) std::swap(first, last);
        canvas.arc(Point::Zero(), kLevel * static_cast<double>(inner), first, first + width, stroke);
        continue;
      }
      if (edge.before.merged()) first = last;
      if (edge.after.merged()) last = first;
      last = first + std::remainder(last - first, 2 * std::numbers::pi);
      Polyline spiral;
      constexpr int kPieces = 32;
      for (int i = 0; i <= kPieces; ++i) {
        const double t = static_cast<double>(i) / kPieces;
        const double radius = kLevel * (static_cast<double>(inner) * (1 - t) + static_cast<double>(outer) * t);
        const double turned = first + t * (last - first);
        spiral.emplace_back(radius * std::cos(turned), radius * std::sin(turned));
      }
      canvas.stroke({spiral}, stroke);
    }
    for (const GridNode& node : figure.nodes) {
      const Grid& grid = figure.grids[static_cast<std::size_t>(node.grid)];
      const double half = 3 + 0.27 * kText * static_cast<double>(node.label.size());
      const Point centre = at(node, kLevel);
      canvas.polygon({centre + Point(-half, -7.5), centre + Point(half, -7.5), centre + Point(half, 7.5),
                      centre + Point(-half, 7.5)},
                     rgb(0xffffff), Stroke{grid.colour(), 1});
      canvas.text(centre - Point(0, 0.36 * kText), node.label, kText, grid.colour());
    }
  };
}

}  // namespace requad::figures
