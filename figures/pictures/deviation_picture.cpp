// Irregular vertices against deviation, as curves: what bench/shape measures.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "figures/panels/legend.hpp"
#include "figures/pictures/paper_pictures.hpp"
#include "mesh/text/fixed_decimals.hpp"

namespace requad::figures {

namespace {

constexpr double kPlotWidth = 340, kPlotHeight = 210;

// The least of 1, 2 and 5 times a power of ten that cuts the range into at most so many steps.
double tick(double range, int most) {
  const double power = std::pow(10, std::floor(std::log10(range / most)));
  for (const double factor : {1, 2, 5}) {
    if (range / (factor * power) <= most) return factor * power;
  }
  return 10 * power;
}

// A line of dots and dashes, and a mark, for each curve: circle, square, rhombus.
struct Look {
  Colour Palette::*colour;
  std::vector<double> dashes;
  int corners;
  double turned;
};
const std::array<Look, 3>& looks() {
  static const std::array<Look, 3> all{
      {{&Palette::odd, {}, 0, 0}, {&Palette::side, {6, 3}, 4, 0.25}, {&Palette::path, {2, 2}, 4, 0}}};
  return all;
}

void paint_mark(Canvas& canvas, const Look& look, Point at, double radius) {
  const Colour colour = canvas.palette().*look.colour;
  if (look.corners == 0) return canvas.circle(at, 0.85 * radius, colour, {});
  Polyline corners;
  for (int k = 0; k < look.corners; ++k) {
    const double angle = 2 * std::numbers::pi * (k + look.turned * 2) / look.corners;
    corners.push_back(at + radius * Point(std::cos(angle), std::sin(angle)));
  }
  canvas.polygon(corners, colour, {});
}

void paint_axes(Canvas& canvas, const Point& range) {
  const double em = canvas.em();
  const Colour ink = canvas.palette().ink;
  const Stroke thin{canvas.palette().ring, 0.5};
  // Deviations are shown in percent.
  for (const int axis : {0, 1}) {
    const double shown = axis == 0 ? 100 * range[axis] : range[axis];
    const double step = tick(shown, 6);
    for (int k = 0; k * step <= shown * (1 + 1e-9); ++k) {
      const double at = k * step / shown * (axis == 0 ? kPlotWidth : kPlotHeight);
      if (axis == 0) {
        canvas.stroke({{{at, 0}, {at, kPlotHeight}}}, thin);
        canvas.label({at, -1.6 * em}, mesh::short_decimals(k * step, 3) + " %", ink);
      } else {
        canvas.stroke({{{0, at}, {kPlotWidth, at}}}, thin);
        canvas.label({-0.6 * em, at - 0.35 * em}, mesh::short_decimals(k * step, 3), ink, Anchor::right);
      }
    }
  }
  canvas.stroke({{{0, kPlotHeight}, {0, 0}, {kPlotWidth, 0}}}, {ink, 1});
  canvas.label({0, kPlotHeight + 1.1 * em}, "irregular vertices", ink, Anchor::left);
  canvas.label({kPlotWidth / 2, -3 * em}, "Hausdorff distance from the input, over the diagonal", ink);
}

}  // namespace

std::vector<Curve> parse_curves(const std::string& json) {
  std::vector<Curve> curves;
  const nlohmann::json all = nlohmann::json::parse(json);
  for (const auto& [name, points] : all.at("curves").items()) {
    curves.push_back({name, {}});
    for (const auto& point : points)
      curves.back().points.emplace_back(point.at(0).get<double>(), point.at(1).get<double>());
  }
  return curves;
}

Paint paint_deviation(const std::vector<Curve>& curves) {
  return [curves](Canvas& canvas) {
    Point range(1e-6, 1);
    for (const Curve& curve : curves) {
      for (const Point& p : curve.points) range = range.cwiseMax(p);
    }
    range *= 1.03;
    paint_axes(canvas, range);
    std::vector<LegendEntry> legend;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const Look& look = looks().at(i % looks().size());
      Polyline line;
      for (const Point& p : curves[i].points)
        line.emplace_back(p.x() / range.x() * kPlotWidth, p.y() / range.y() * kPlotHeight);
      canvas.stroke({line}, {canvas.palette().*look.colour, 1.4, look.dashes});
      for (const Point& p : line) paint_mark(canvas, look, p, 3.6);
      std::string name = curves[i].name;
      std::replace(name.begin(), name.end(), '_', ' ');  // which would lower the next letter
      legend.push_back({name, [look](Canvas& c, Point at, double unit) {
                          const Point half(10 * unit, 0);
                          c.stroke({{at - half, at + half}}, {c.palette().*look.colour, 1.4, look.dashes});
                          paint_mark(c, look, at, 3.6 * unit);
                        }});
    }
    paint_legend(canvas, legend, {kPlotWidth / 2, -4 * canvas.em()}, kPlotWidth);
  };
}

}  // namespace requad::figures
