#include "figures/grid_figure.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "enumerate/graphs/grid_drawing.hpp"
#include "theory/joined.hpp"

namespace requad::figures {

namespace {

using enumerate::Exploration;
using enumerate::FoundMove;
using theory::Configuration;
using theory::PairType;
using theory::RegionShape;

using Position = std::array<double, 2>;
using PositionOf = std::function<Position(const Configuration&)>;

theory::GridPoint grid_point_of(PairType type, const Configuration& labelling) {
  return theory::grid_point(type, type.symmetric() ? labelling : theory::canonical(type, labelling));
}

std::string signed_text(theory::Integer x) { return (x < 0 ? "" : "+") + std::to_string(x); }

GridEdge edge_of(PairType type, int from, int to, const FoundMove& move) {
  using Kind = mesh::BasicOperation::Kind;
  const theory::GridPoint before = grid_point_of(type, move.before.value()),
                          after = grid_point_of(type, move.after.value());
  GridEdge edge{from,
                to,
                mesh::name(move.move.step),
                "(" + signed_text(after.m - before.m) + "," + signed_text(after.n - before.n) + ")",
                *move.before,
                *move.after};
  for (const mesh::BasicOperation& operation : move.script) {
    ++(operation.kind == Kind::split ? edge.splits : operation.kind == Kind::collapse ? edge.collapses : edge.flips);
  }
  return edge;
}

// The frame that gives a labelling. A segment has two labellings.
const mesh::PairFrame& frame_of(const enumerate::Reading& reading, const Configuration& labelling) {
  const auto found = std::find_if(reading.frames.begin(), reading.frames.end(),
                                  [&](const auto& f) { return f.labelling == labelling; });
  return (found == reading.frames.end() ? reading.frames.front() : *found).frame;
}

// Adds a found grid to a figure. `position` is where a labelling lies. Two labellings of one configuration that lie at
// two positions become a node and its copy. An edge joins the labellings before and after a move.
void add_grid(GridFigure& figure, const Exploration& found, const std::string& prefix, const PositionOf& position,
              bool upside_down = false) {
  const PairType type = found.shape.type();
  const int grid = static_cast<int>(figure.grids.size());
  const auto first = static_cast<int>(figure.nodes.size());
  const Configuration& any = found.nodes.at(0).reading.configuration;
  const Parity parity = !type.symmetric() ? Parity::none : (any.d1() + any.d2()) % 2 == 0 ? Parity::even : Parity::odd;
  figure.grids.push_back({found.shape, parity, upside_down});
  const enumerate::GridDrawing drawing = enumerate::grid_drawing(found, position);
  for (const enumerate::GridSpot& spot : drawing.spots) {
    const auto& node = found.nodes[static_cast<std::size_t>(spot.node)];
    figure.nodes.push_back({prefix + std::to_string(figure.nodes.size()), theory::label(type, spot.labelling), spot.at,
                            grid, spot.same_as < 0 ? -1 : first + spot.same_as, spot.labelling, node.region,
                            frame_of(node.reading, spot.labelling), node.signature});
  }
  for (const enumerate::GridLine& line : drawing.lines)
    figure.edges.push_back(edge_of(type, first + line.from, first + line.to, *line.move));
}

// The side of a regular region, and the next smaller side if a region with that side holds a pair.
std::vector<int> two_lengths(int length) {
  if (length < 3) {
    throw std::invalid_argument("a regular region of side " + std::to_string(length) +
                                " holds no pair; the least side is 3");
  }
  return length == 3 ? std::vector<int>{3} : std::vector<int>{length, length - 1};
}

std::string sides_text(int length) {
  std::string text;
  for (const int l : two_lengths(length)) text += (text.empty() ? "" : " and ") + std::to_string(l);
  return text;
}

void add_regular(GridFigure& figure, PairType type, int length, const PositionOf& position, bool upside_down = false) {
  add_grid(figure, enumerate::explore_all(RegionShape::regular(type, length), theory::Apex::with),
           "L" + std::to_string(length) + "_", position, upside_down);
}

}  // namespace

GridFigure figure_10(int length) {
  GridFigure figure{"Configurations of a 3-3 pair in regular digons of side " + sides_text(length), {}, {}, {}};
  for (const int l : two_lengths(length)) {
    add_regular(figure, theory::kDigon, l,
                [](const Configuration& c) { return enumerate::grid_position(theory::kDigon, c); });
  }
  return figure;
}

GridFigure figure_11(int length) {
  GridFigure figure{"Configurations of a 5-5 pair in regular hexagons of side " + sides_text(length), {}, {}, {}};
  const auto projected = [](const Configuration& c) { return enumerate::grid_position(theory::kHexagon, c); };
  add_regular(figure, theory::kHexagon, length, projected);
  if (length == 3) return figure;
  // The grids are triangles with radii L - 2 and L - 3. Their bases are level with the tops of each other, and their
  // slanting sides kGap apart.
  constexpr double kGap = 1.1;
  const double y = (length - 1) / 2.0;
  const double x = (length - 2.5 + kGap - y / 2) * 2 / std::numbers::sqrt3;
  const auto turned = [=](const Configuration& c) -> Position {
    const Position at = projected(c);
    return {x - at[0], y - at[1]};
  };
  add_regular(figure, theory::kHexagon, length - 1, turned, true);
  return figure;
}

GridFigure figure_12(int d1, int d2, int m, int n) {
  if (d1 < 0 || d2 < 0 || d1 + d2 == 0 || m < 1 || n < 1) {
    throw std::invalid_argument("a 3-5 region needs d1, d2 >= 0, not both 0, and M, N >= 1");
  }
  const PairType type = theory::kQuad;
  Configuration first;
  first.parameters = {d1 > 0 ? d1 : d2, d1 > 0 ? d2 : 0, theory::IntegerVector::Ones(4)};
  first.parameters.e(2) = m;  // e1 + e3 = M + 1, e2 + e4 = N + 1
  first.parameters.e(3) = n;
  const RegionShape shape(type, theory::region_sides(type, first));
  GridFigure figure{
      "Configurations of a 3-5 pair in a region with sides " + theory::joined(shape.sides(), " "), {}, {}, {}};
  add_grid(figure, enumerate::explore_all(shape, theory::Apex::without), "n",
           [type](const Configuration& c) { return enumerate::grid_position(type, theory::canonical(type, c)); });
  return figure;
}

GridFigure hexagon_figure(const std::vector<theory::Integer>& sides) {
  GridFigure figure{"Configurations of a 5-5 pair in a hexagon with sides " + theory::joined(sides, " "), {}, {}, {}};
  const RegionShape shape(theory::kHexagon, theory::to_vector(sides));
  if (theory::parameter_set(shape).empty()) {
    throw std::invalid_argument("a hexagon with these sides holds no 5-5 pair");
  }
  add_grid(figure, enumerate::explore_all(shape, theory::Apex::with), "n",
           [](const Configuration& c) { return enumerate::grid_position(theory::kHexagon, c); });
  return figure;
}

GridFigure unfolded_figure(int length) {
  two_lengths(length);
  GridFigure figure{
      "The half cube of the regular hexagon of side " + std::to_string(length) + ", laid flat", {}, {}, {}};
  add_regular(figure, theory::kHexagon, length, [](const Configuration& c) {
    return enumerate::position_on_axes(c, std::numbers::pi / 2, std::numbers::pi / 2);
  });
  return figure;
}

GridFigure dual_figure(PairType type, int length) {
  if (!type.symmetric()) throw std::invalid_argument("dual grids are those of two equal irregular vertices");
  GridFigure figure{
      "Two grids that are dual: a " + type.name() + " pair in regions of side " + sides_text(length), {}, {}, {}};
  const int quadrants = type.rotation_count();
  for (const int l : two_lengths(length)) {
    add_regular(figure, type, l, [quadrants](const Configuration& c) -> Position {
      if (c.merged()) return {0, 0};
      const double level = static_cast<double>(c.d1() + c.d2());
      const double part = (c.p - static_cast<double>(c.d2()) / level) / quadrants;
      return {level * std::sin(2 * std::numbers::pi * part), level * std::cos(2 * std::numbers::pi * part)};
    });
  }
  return figure;
}

}  // namespace requad::figures
