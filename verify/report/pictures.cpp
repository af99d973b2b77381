#include "verify/report/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "enumerate/generators.hpp"
#include "enumerate/graphs/grid_drawing.hpp"
#include "mesh/program/layout.hpp"
#include "verify/report/mesh_drawing.hpp"
#include "verify/report/numbers.hpp"
#include "verify/report/svg.hpp"

namespace requad::verify {

using enumerate::Exploration;
using enumerate::FoundNode;
using program::counted;
using theory::Configuration;
using theory::PairType;
using theory::RegionShape;

namespace {

constexpr double kText = 19;  // still readable where a phone shows a picture at half its size

constexpr double kUpright = std::numbers::pi / 2;  // turns a hexagon onto a corner, as in Figure 11

// --- configurations and moves ----------------------------------------------------------------------------------------

// How the graph of a pair's configurations is laid out.
struct GraphLayout {
  RegionShape shape;
  Point unit;  // between grid positions
  Point room;  // for the mesh of a node
  double angle = 0;
  const char* figure;
};

GraphLayout graph_layout(PairType type) {
  if (type == theory::kDigon) return {RegionShape::regular(type, 6), {62, 66}, {112, 72}, 0, "Figure 10"};
  if (type == theory::kHexagon) return {RegionShape::regular(type, 5), {104, 114}, {88, 84}, kUpright, "Figure 11"};
  return {{type, theory::to_vector(std::vector<theory::Integer>{6, 5, 5, 8})}, {150, 140}, {118, 104}, 0, "Figure 12"};
}

Polyline box(const Point& centre, const Point& half) {
  const Point across(half.x(), -half.y());
  return {centre - half, centre + across, centre + half, centre - across};
}

// The region with the side after side p as its first one, which is drawn lowest. So a 3-5 region lies as its grid does.
mesh::Region turned(const FoundNode& node) {
  mesh::Region region = node.region;
  const std::vector<int> sides = mesh::side_lengths(region);
  int edges = 0;
  for (int i = 0; i < node.reading.configuration.p; ++i) edges += sides[static_cast<std::size_t>(i) % sides.size()];
  for (int i = 0; i < edges; ++i) region.root = region.mesh.next_on_boundary(region.root);
  return region;
}

std::vector<mesh::FaceId> alpha_of(const mesh::QuadMesh& m, const enumerate::Reading& reading) {
  if (reading.configuration.merged()) return {};
  return mesh::grid(m, reading.frames.front().frame).value();
}

std::string shape_text(const RegionShape& shape) {
  const char* const kind = shape.type() == theory::kDigon     ? "digon"
                           : shape.type() == theory::kHexagon ? "hexagon"
                                                              : "region with four sides";
  if (shape.type().symmetric() && shape.is_regular())
    return std::string("regular ") + kind + " of side " + std::to_string(shape.longest());
  std::string sides;
  for (const theory::Integer side : shape.sides()) sides += (sides.empty() ? "" : ", ") + std::to_string(side);
  return std::string(kind) + " (" + sides + ")";
}

}  // namespace

Picture graph_picture(PairType type) {
  const GraphLayout layout = graph_layout(type);
  const Exploration found = enumerate::explore_all(layout.shape, theory::Apex::with);
  const enumerate::GridDrawing drawing = enumerate::grid_drawing(found);
  const auto at = [&](int spot) -> Point {
    const enumerate::GridPosition& p = drawing.spots[static_cast<std::size_t>(spot)].at;
    return layout.unit.array() * Point(p[0], p[1]).array();
  };
  Svg svg;
  svg.open("lines");
  for (const enumerate::GridLine& line : drawing.lines) svg.path("line", {{at(line.from), at(line.to)}});
  svg.close();
  int pairs = 0;
  for (std::size_t i = 0; i < drawing.spots.size(); ++i) {
    const enumerate::GridSpot& spot = drawing.spots[i];
    const FoundNode& node = found.nodes[static_cast<std::size_t>(spot.node)];
    const bool is_copy = spot.same_as >= 0;
    const mesh::Region region = type.symmetric() ? node.region : turned(node);
    const MeshDrawing mesh(region, at(static_cast<int>(i)), layout.room, layout.angle);
    svg.open(is_copy ? "node copy" : "node");
    mesh.draw(svg, alpha_of(region.mesh, node.reading), 5.5);
    std::string label = theory::label(type, spot.labelling);
    if (is_copy) label += " = " + theory::label(type, node.reading.configuration);
    const Point below(at(static_cast<int>(i)).x(), mesh.low() - 0.75 * kText);
    const double half = 0.3 * kText * static_cast<double>(label.size());
    svg.path("plate", {box(below, {half, 0.5 * kText})}, Ends::closed);
    svg.text("label", below, label, kText);
    svg.close();
    if (!is_copy && found.holds_pair(spot.node)) ++pairs;
  }
  const bool copies =
      std::any_of(drawing.spots.begin(), drawing.spots.end(), [](const auto& s) { return s.same_as >= 0; });
  const bool merged = pairs < static_cast<int>(found.nodes.size());
  std::string caption = "The " + counted(pairs, "configuration") + " of a " + type.name() + " pair in the " +
                        shape_text(layout.shape) + ", and the " +
                        counted(static_cast<std::int64_t>(drawing.lines.size()), "move") + " between them, as in " +
                        layout.figure + ". ";
  caption += type.symmetric() ? "The label is (d1, d2" + std::string(type.has_third_index() ? ", p)" : ")")
                              : std::string("The label is (m, n)");
  caption += ", and R_alpha is blue.";
  if (merged) caption += " At (0,0) the pair is merged into one vertex.";
  if (copies) caption += " A dashed mesh is the same configuration as the one that it names.";
  return {svg.element("picture graph", caption), caption};
}

// --- regions ---------------------------------------------------------------------------------------------------------

namespace {

constexpr double kFamilyMark = 7;

std::string mesh_svg(const mesh::Region& region, const std::vector<mesh::FaceId>& alpha, double angle,
                     const std::string& what) {
  Svg svg;
  MeshDrawing(region, Point::Zero(), {190, 150}, angle).draw(svg, alpha, kFamilyMark);
  return svg.element("picture example", what);
}

// The configuration with the most square R_alpha.
Picture pair_example(const RegionShape& shape) {
  const std::vector<Configuration> all = theory::parameter_set(shape);
  const auto less = [](const Configuration& a, const Configuration& b) {
    return std::min(a.d1(), a.d2()) < std::min(b.d1(), b.d2());
  };
  const Configuration& c = *std::max_element(all.begin(), all.end(), less);
  const mesh::Region region = enumerate::glue_region(shape.type(), c);
  const std::string what = "A " + shape_text(shape) + " with a " + shape.type().name() + " pair; R_alpha is " +
                           std::to_string(c.d1()) + " x " + std::to_string(c.d2()) + ".";
  return {mesh_svg(region, alpha_of(region.mesh, enumerate::read(region, shape.type())), 0, what), what};
}

RegionShape shape_with(PairType type, std::vector<theory::Integer> sides) { return {type, theory::to_vector(sides)}; }

Picture triple_example() {
  const TripleStudy study = search_triple({{3, 3, 5}, theory::IntegerVector::Constant(3, 6)});
  // The filling whose irregular vertices have the least degree of being neighbours: no edge and no quad joins two.
  const auto joined = [](const mesh::Region& region) {
    int count = 0;
    for (const mesh::FaceId f : region.mesh.faces()) {
      int irregular = 0;
      for (const mesh::VertexId v : region.mesh.corners(f)) {
        const auto all = mesh::irregular_vertices(region.mesh);
        irregular += static_cast<int>(std::count(all.begin(), all.end(), v));
      }
      count += irregular > 1 ? 1 : 0;
    }
    return count;
  };
  const auto& fillings = study.fillings;
  const mesh::Region& region = *std::min_element(fillings.begin(), fillings.end(),
                                                 [&](const auto& a, const auto& b) { return joined(a) < joined(b); });
  const std::string what = "A triangle of side 6 with two v3 and a v5, one of its " +
                           counted(static_cast<std::int64_t>(fillings.size()), "filling") + ".";
  return {mesh_svg(region, {}, 0, what), what};
}

}  // namespace

Picture family_picture(Family family) {
  switch (family) {
    case Family::regular_digon: return pair_example(RegionShape::regular(theory::kDigon, 6));
    case Family::regular_hexagon: return pair_example(RegionShape::regular(theory::kHexagon, 5));
    case Family::quad: return pair_example(shape_with(theory::kQuad, {6, 5, 5, 8}));
    case Family::other_digon: return pair_example(shape_with(theory::kDigon, {5, 9}));
    case Family::other_hexagon: return pair_example(shape_with(theory::kHexagon, {4, 5, 6, 5, 4, 6}));
    case Family::single_vertex: {
      const mesh::Region region = enumerate::glue_vertex(theory::IntegerVector::Constant(5, 2));
      const std::string what = "A pentagon of side 4 with one v5.";
      return {mesh_svg(region, {}, 0, what), what};
    }
    case Family::three_vertices: return triple_example();
  }
  return {};
}

// --- counts ----------------------------------------------------------------------------------------------------------

namespace {

constexpr double kPlotWidth = 540, kPlotHeight = 320;
constexpr double kPlotText = 18;

// The least of 1, 2, 5, 10, 20, 50, ... that is at least x.
std::int64_t round_step(double x) {
  for (std::int64_t power = 1;; power *= 10) {
    for (const std::int64_t step : {power, 2 * power, 5 * power}) {
      if (static_cast<double>(step) >= x) return step;
    }
  }
}

struct Count {
  std::int64_t side = 0;
  std::int64_t predicted = 0;
  std::map<Method, std::int64_t> found;
};

// The regular regions of a theorem's table.
std::vector<Count> regular_counts(const CampaignResult& result, const std::string& id) {
  std::vector<Count> counts;
  for (const ClaimResult& c : result.claims) {
    if (c.claim->id != id) continue;
    for (const auto& row : c.table) {
      if (!row.contains("tau")) continue;
      Count& count = counts.emplace_back(Count{row.at("sides").at(0), row.at("tau"), {}});
      for (const Method method : {Method::moves, Method::search, Method::walk}) {
        if (row.contains(name(method))) count.found[method] = row[name(method)];
      }
    }
  }
  std::sort(counts.begin(), counts.end(), [](const Count& a, const Count& b) { return a.side < b.side; });
  return counts;
}

// A hollow square, a ring and a dot, which can be told apart where all three lie on each other.
void mark(Svg& svg, Method method, const Point& at) {
  switch (method) {
    case Method::moves: svg.path("mark", {box(at, {6, 6})}, Ends::closed); return;
    case Method::search: svg.circle("mark", at, 4.2); return;
    case Method::walk: svg.circle("mark dot", at, 1.9); return;
  }
}

struct Axis {
  std::int64_t first, last, step;
};

void draw_axes(Svg& svg, const Axis& x, const Axis& y, const std::function<Point(double, double)>& at) {
  const auto left = static_cast<double>(x.first), right = static_cast<double>(x.last);
  const auto top = static_cast<double>(y.last);
  for (std::int64_t value = y.first; value <= y.last; value += y.step) {
    const auto level = static_cast<double>(value);
    svg.path("gridline", {{at(left, level), at(right, level)}});
    svg.text("tick", at(left, level) - Point(10, 0), std::to_string(value), kPlotText, Anchor::end);
  }
  for (std::int64_t value = (x.first + x.step - 1) / x.step * x.step; value <= x.last; value += x.step) {
    svg.text("tick", at(static_cast<double>(value), 0) - Point(0, 20), std::to_string(value), kPlotText);
  }
  svg.path("axis", {{at(left, top), at(left, 0), at(right, 0)}});
  svg.text("tick", at(right, 0) - Point(0, 42), "side L of the region", kPlotText, Anchor::end);
  svg.text("tick", at(left, top) + Point(-10, 26), "configurations", kPlotText, Anchor::start);
}

}  // namespace

Picture counts_picture(const CampaignResult& result) {
  struct Series {
    const char* css;
    const char* name;
    std::vector<Count> counts;
  };
  std::vector<Series> all{{"digon", "digons with a 3-3 pair", regular_counts(result, "T2")},
                          {"hexagon", "hexagons with a 5-5 pair", regular_counts(result, "T3")}};
  std::erase_if(all, [](const Series& series) { return series.counts.empty(); });
  if (all.empty()) return {};
  Axis x{all.front().counts.front().side, all.front().counts.back().side, 1}, y{0, 1, 1};
  std::int64_t marks = 0, on_line = 0;
  std::set<Method> methods;
  for (const Series& series : all) {
    x.first = std::min(x.first, series.counts.front().side);
    x.last = std::max(x.last, series.counts.back().side);
    for (const Count& count : series.counts) {
      y.last = std::max(y.last, count.predicted);
      for (const auto& [method, found] : count.found) {
        y.last = std::max(y.last, found);
        methods.insert(method);
        ++marks;
        on_line += found == count.predicted ? 1 : 0;
      }
    }
  }
  if (x.first == x.last) ++x.last;
  y.step = round_step(static_cast<double>(y.last) / 6);
  y.last = (y.last + y.step - 1) / y.step * y.step;
  x.step = round_step(static_cast<double>(x.last - x.first) / 14);
  const auto at = [&](double side, double count) {
    return Point(kPlotWidth * (side - static_cast<double>(x.first)) / static_cast<double>(x.last - x.first),
                 kPlotHeight * count / static_cast<double>(y.last));
  };
  Svg svg;
  draw_axes(svg, x, y, at);
  for (const Series& series : all) {
    svg.open(series.css);
    Polyline line;
    for (const Count& count : series.counts)
      line.push_back(at(static_cast<double>(count.side), static_cast<double>(count.predicted)));
    svg.path("line", {line});
    for (const Count& count : series.counts) {
      for (const auto& [method, found] : count.found)
        mark(svg, method, at(static_cast<double>(count.side), static_cast<double>(found)));
    }
    svg.close();
  }
  // The legend, below the axis.
  double level = -80;
  for (const Series& series : all) {
    svg.open(series.css);
    svg.path("line", {{Point(0, level), Point(40, level)}});
    svg.close();
    svg.text("label", {52, level}, "tau(L), " + std::string(series.name), kPlotText, Anchor::start);
    level -= 26;
  }
  double across = 12;
  for (const Method method : methods) {
    mark(svg, method, {across, level});
    svg.text("label", {across + 16, level}, std::string("found by ") + name(method), kPlotText, Anchor::start);
    across += 180;
  }
  const std::string caption =
      "Configurations in regular regions. Lines: the number that the theorem predicts. Marks: "
      "the number that each method found. " +
      std::to_string(on_line) + " of " + counted(marks, "mark") + (marks == 1 ? " lies" : " lie") + " on the lines.";
  return {svg.element("picture plot", caption), caption};
}

// --- times -----------------------------------------------------------------------------------------------------------

Picture times_picture(const CampaignResult& result) {
  struct Bar {
    std::string css, name;
    double seconds;
  };
  std::vector<Bar> bars;
  double all = 0;
  for (const auto& [method, seconds] : result.method_seconds) bars.push_back({"bar", name(method), seconds});
  double judging = 0;
  for (const ClaimResult& c : result.claims) judging += c.seconds;
  bars.push_back({"bar other", "comparisons", judging});
  for (const Bar& bar : bars) all += bar.seconds;
  const double rest = result.study_seconds + judging - all;
  if (rest > 0) bars.push_back({"bar other", "predictions", rest});
  double most = 1e-9;
  for (const Bar& bar : bars) most = std::max(most, bar.seconds);
  constexpr double kStep = 34, kHalf = 11, kLength = 300;
  Svg svg;
  double level = 0;
  for (const Bar& bar : bars) {
    const double length = std::max(kLength * bar.seconds / most, 1.0);
    svg.text("label", {-12, level}, bar.name, kPlotText, Anchor::end);
    svg.path(bar.css, {box({length / 2, level}, {length / 2, kHalf})}, Ends::closed);
    svg.text("label", {length + 12, level}, seconds_text(bar.seconds), kPlotText, Anchor::start);
    level -= kStep;
  }
  const std::string caption =
      "The time that each method took, added up over all threads. Comparisons: what the checks "
      "did with the results. Predictions: what the theory computed for them.";
  return {svg.element("picture times", caption), caption};
}

}  // namespace requad::verify
