#include <cmath>
#include <numbers>

#include "figures/panels/labels.hpp"
#include "figures/panels/legend.hpp"
#include "figures/pictures/grid_picture.hpp"

namespace requad::figures {

namespace {

using std::numbers::pi;

constexpr int kPieces = 48;  // of a curve

// A move between two levels: from one radius and angle to another. The radius changes evenly. The angle changes in
// between, so that the curve meets both circles at right angles and is not taken for a part of them.
Polyline between_levels(double inner, double first, double outer, double last) {
  Polyline curve;
  for (int i = 0; i <= kPieces; ++i) {
    const double t = static_cast<double>(i) / kPieces;
    const double turned = first + t * t * (3 - 2 * t) * (last - first);
    curve.emplace_back((inner + t * (outer - inner)) * Point(std::cos(turned), std::sin(turned)));
  }
  return curve;
}

}  // namespace

Paint paint_dual(const GridFigure& figure) {
  return [figure](Canvas& canvas) {
    const double level_height = std::max(54.0, 2.6 * canvas.em());
    const int quadrants = figure.grids.at(0).shape.type().rotation_count();
    const auto angle = [quadrants](const theory::Configuration& c) {
      const auto level = static_cast<double>(c.d1() + c.d2());
      return 2 * pi * (0.25 - (c.p - static_cast<double>(c.d2()) / level) / quadrants);
    };
    const auto stroke_of = [&](const Grid& grid) {
      return Stroke{grid.colour(canvas.palette()), 1.6,
                    grid.parity == Parity::odd ? std::vector<double>{5, 3.5} : std::vector<double>{}};
    };
    double radius = 0;
    for (const GridEdge& edge : figure.edges) {
      const GridNode& from = figure.nodes[static_cast<std::size_t>(edge.from)];
      const Stroke stroke = stroke_of(figure.grids[static_cast<std::size_t>(from.grid)]);
      // An edge within a level is an arc. On level 1 of a digon it is a whole circle.
      const theory::Integer inner = edge.before.d1() + edge.before.d2(), outer = edge.after.d1() + edge.after.d2();
      double first = angle(edge.before), last = angle(edge.after);
      radius = std::max({radius, level_height * static_cast<double>(inner), level_height * static_cast<double>(outer)});
      if (inner == outer) {
        const double width = 2 * pi / (static_cast<double>(inner) * quadrants);
        // Labels of neighbouring quadrants differ by whole turns.
        if (last < first) std::swap(first, last);
        if (last - first > 1.5 * width) std::swap(first, last);
        canvas.arc(Point::Zero(), level_height * static_cast<double>(inner), first, first + width, stroke);
        continue;
      }
      if (edge.before.merged()) first = last;
      if (edge.after.merged()) last = first;
      last = first + std::remainder(last - first, 2 * pi);
      canvas.stroke({between_levels(level_height * static_cast<double>(inner), first,
                                    level_height * static_cast<double>(outer), last)},
                    stroke);
    }
    for (const GridNode& node : figure.nodes) {
      const Grid& grid = figure.grids[static_cast<std::size_t>(node.grid)];
      const Point centre = level_height * Point(node.at[0], node.at[1]);
      const Colour colour = grid.colour(canvas.palette());
      if (!canvas.style().labels) {
        canvas.circle(centre, 3.5, colour, {});
        continue;
      }
      const Point half(0.3 * canvas.em() + canvas.width_of(node.label) / 2, 0.75 * canvas.em());
      canvas.polygon(
          {centre - half, centre + Point(half.x(), -half.y()), centre + half, centre + Point(-half.x(), half.y())},
          canvas.palette().paper, Stroke{colour, 1});
      canvas.label(centre - Point(0, 0.36 * canvas.em()), node.label, colour);
    }
    std::vector<LegendEntry> entries;
    for (const Grid& grid : figure.grids)
      entries.push_back(LegendEntry::line("side " + std::to_string(grid.shape.longest()), stroke_of(grid)));
    paint_legend(canvas, entries, {0, -radius - 1.6 * canvas.em()}, 2 * radius);
  };
}

}  // namespace requad::figures
