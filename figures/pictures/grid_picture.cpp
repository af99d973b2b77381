#include "figures/pictures/grid_picture.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>

#include "figures/panels/labels.hpp"
#include "figures/panels/legend.hpp"
#include "mesh/geometry/drawing.hpp"
#include "mesh/pictures/mesh_picture.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::figures {

namespace {

using std::numbers::pi;

constexpr double kStar = 5;  // radius

Stroke grid_stroke(const Canvas& canvas, const Grid& grid) {
  return {grid.colour(canvas.palette()), 1.6,
          grid.parity == Parity::odd ? std::vector<double>{5, 3.5} : std::vector<double>{}};
}

// The room for the mesh at a node, and the least distance between neighbours: so large that a label has room between
// them. In units.
struct Sizes {
  double width, height, spacing;
};
Sizes sizes(theory::PairType type, double em) {
  if (type == theory::kDigon) return {158, 84, std::max(104.0, 86 + 1.8 * em)};
  if (type == theory::kHexagon) return {78, 78, std::max(108.0, 78 + 2.2 * em)};
  return {112, 106, std::max(130.0, 106 + 2.4 * em)};
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

// A grid with the mesh of each node, drawn around the origin.
class GridPicture {
 public:
  explicit GridPicture(const GridFigure& figure) : figure_(figure), type_(figure.grids.at(0).shape.type()) {
    const Sizes size = sizes(type_, 0);
    for (const GridNode& node : figure.nodes) {
      mesh::Region region = node.region;
      region.root = lowest_side(node, type_);
      // A hexagon stands on a corner, so that the segment of (x,0,p) lies along the axis of its node.
      const double angle = (type_ == theory::kHexagon ? pi / 2 : 0) + (grid_of(node).upside_down ? pi : 0);
      const MeshPicture probe(region, Point::Zero(), 1, angle);
      const Point extent = probe.high() - probe.low();
      pictures_.emplace_back(region, Point::Zero(), std::min(size.width / extent.x(), size.height / extent.y()), angle);
    }
  }

  void paint(Canvas& canvas) const {
    const double spacing = sizes(type_, canvas.style().labels ? canvas.em() : 0).spacing;
    const auto at = [&](int node) {
      const GridNode& n = figure_.nodes[static_cast<std::size_t>(node)];
      return Point(spacing * Point(n.at[0], n.at[1]));
    };
    LabelPlaces places(canvas);
    for (const GridEdge& edge : figure_.edges) {
      const Polyline line{at(edge.from), at(edge.to)};
      canvas.stroke({line}, grid_stroke(canvas, grid_of(figure_.nodes[static_cast<std::size_t>(edge.from)])));
      places.block(line, std::max(2.0, 0.25 * canvas.em()));
    }
    std::vector<MeshPicture> moved;
    Point low = Point::Zero(), high = low;
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      moved.push_back(pictures_[i].moved(at(static_cast<int>(i))));
      paint_node(canvas, places, figure_.nodes[i], moved.back());
      low = i == 0 ? moved[i].low() : Point(low.cwiseMin(moved[i].low()));
      high = i == 0 ? moved[i].high() : Point(high.cwiseMax(moved[i].high()));
    }
    constexpr std::array directions{-1.2, -1.94, -0.9,  -2.24, 1.2,  1.94,  0.9,
                                    2.24, -0.5,  -2.64, 0.5,   2.64, -1.57, 1.57};
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const GridNode& node = figure_.nodes[i];
      std::string words = node.label;
      if (node.same_as >= 0) words += " = " + figure_.nodes[static_cast<std::size_t>(node.same_as)].label;
      places.put(words, node.same_as >= 0 ? canvas.palette().faint_ink : grid_of(node).colour(canvas.palette()),
                 places.round(moved[i].outline(), words, directions));
    }
    paint_legend(canvas, legend(canvas), {(low.x() + high.x()) / 2, low.y() - 2.2 * canvas.em()}, high.x() - low.x());
  }

 private:
  const Grid& grid_of(const GridNode& node) const { return figure_.grids[static_cast<std::size_t>(node.grid)]; }

  void paint_node(Canvas& canvas, LabelPlaces& places, const GridNode& node, const MeshPicture& picture) const {
    const bool copy = node.same_as >= 0;
    picture.background(canvas, canvas.palette().paper);
    places.block_area(picture.outline(), 1);
    if (copy) {
      picture.edges(canvas, canvas.palette().faint, 0.45);
      picture.faint_irregular(canvas);
      return;
    }
    picture.faces(canvas, mesh::ring(picture.mesh(), node.frame), canvas.palette().ring);
    picture.faces(canvas, mesh::grid(picture.mesh(), node.frame).value(), canvas.palette().pair);
    picture.edges(canvas, canvas.palette().line, 0.45);
    if (!type_.symmetric()) paint_stars(canvas, places, node, picture);
    picture.irregular(canvas);
  }

  void paint_stars(Canvas& canvas, LabelPlaces& places, const GridNode& node, const MeshPicture& picture) const {
    const std::vector<mesh::HalfEdgeId> out = mesh::outward(picture.mesh(), node.frame);
    for (std::size_t i = 0; i < 2; ++i) {
      const Colour colour = i == 0 ? canvas.palette().first_star : canvas.palette().second_star;
      const auto path = mesh::trace(picture.mesh(), out[i]).path;
      const Point end = picture.at(picture.mesh().target(path.back()));
      picture.path(canvas, path, {canvas.palette().side, 1.3, {2, 2.4}});
      mark_star(canvas, end, kStar, colour);
      places.block_point(end, kStar);
    }
  }

  std::vector<LegendEntry> legend(const Canvas& canvas) const {
    const Palette& palette = canvas.palette();
    std::vector<LegendEntry> entries;
    for (const Grid& grid : figure_.grids) {
      const std::string side = "side " + std::to_string(grid.shape.longest());
      entries.push_back(LegendEntry::line(grid.parity == Parity::none ? "a move"
                                          : figure_.grids.size() > 1  ? "a move, " + side
                                                                      : "a move",
                                          grid_stroke(canvas, grid)));
    }
    for (const int valence : std::set<int>{type_.l1, type_.l2})
      entries.push_back(LegendEntry::mark("v" + std::to_string(valence), valence));
    const auto has_quads = [](const GridNode& n) { return n.configuration.d1() * n.configuration.d2() > 0; };
    if (std::any_of(figure_.nodes.begin(), figure_.nodes.end(), has_quads))
      entries.push_back(LegendEntry::face("R_{α}, the grid between them", palette.pair));
    entries.push_back(LegendEntry::face("the smallest convex region around it", palette.ring));
    if (!type_.symmetric()) {
      entries.push_back(LegendEntry::star("m from the corner on the lower left", palette.second_star));
      entries.push_back(LegendEntry::star("n from that corner", palette.first_star));
    }
    if (std::any_of(figure_.nodes.begin(), figure_.nodes.end(), [](const GridNode& n) { return n.same_as >= 0; }))
      entries.push_back(LegendEntry::faint("drawn once more: (0,x) is (x,0)"));
    return entries;
  }

  GridFigure figure_;
  theory::PairType type_;
  std::vector<MeshPicture> pictures_;
};

}  // namespace

Paint paint_grid(const GridFigure& figure) {
  return [picture = std::make_shared<const GridPicture>(figure)](Canvas& canvas) { picture->paint(canvas); };
}

}  // namespace requad::figures
