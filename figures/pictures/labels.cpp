#include "figures/pictures/labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

namespace requad::figures {

namespace {

namespace geometry = boost::geometry;
using FlatPoint = geometry::model::d2::point_xy<double>;

// A closed ring, in either direction, or a line.
template <class Shape>
Shape flat(const Polyline& points) {
  Shape shape;
  for (const Point& p : points) geometry::append(shape, FlatPoint(p.x(), p.y()));
  geometry::correct(shape);
  return shape;
}

}  // namespace

void LabelPlaces::add(const Polyline& shape, bool area, double clearance, int weight) {
  Obstacle obstacle{shape, area, clearance, weight, shape.front(), shape.front()};
  for (const Point& p : shape) {
    obstacle.low = obstacle.low.cwiseMin(p);
    obstacle.high = obstacle.high.cwiseMax(p);
  }
  obstacles_.push_back(std::move(obstacle));
}

void LabelPlaces::block(const Polyline& line, double clearance) { add(line, false, clearance); }
void LabelPlaces::block_area(const Polyline& polygon, double clearance) { add(polygon, true, clearance); }

LabelPlaces::Box LabelPlaces::box(const std::string& words, const Place& place, double clearance) const {
  const Words w{place.at, words, canvas_.em(), canvas_.width_of(words), {}, place.anchor, {}};
  const Point room(clearance, clearance);
  return {w.box().first - room, w.box().second + room};
}

bool LabelPlaces::meet(const Obstacle& obstacle, const Box& box) {
  const auto [low, high] =
      std::pair(Point(box.first.array() - obstacle.clearance), Point(box.second.array() + obstacle.clearance));
  if ((low.array() > obstacle.high.array()).any() || (high.array() < obstacle.low.array()).any()) return false;
  const auto rectangle = flat<geometry::model::ring<FlatPoint>>({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
  if (obstacle.area) return geometry::intersects(flat<geometry::model::ring<FlatPoint>>(obstacle.shape), rectangle);
  return geometry::intersects(flat<geometry::model::linestring<FlatPoint>>(obstacle.shape), rectangle);
}

void LabelPlaces::put(const std::string& words, Colour colour, std::span<const Place> places) {
  if (!canvas_.style().labels) return;
  const Place* best = nullptr;
  int least = std::numeric_limits<int>::max();
  for (const Place& place : places) {
    const Box area = box(words, place, 0);
    int met = 0;
    for (const Obstacle& obstacle : obstacles_) met += meet(obstacle, area) ? obstacle.weight : 0;
    if (met >= least) continue;
    best = &place;
    least = met;
    if (met == 0) break;
  }
  const auto [low, high] = box(words, *best, 0);
  constexpr int kLabel = 100;  // the weight of a label, in lines
  add({low, {high.x(), low.y()}, high, {low.x(), high.y()}}, true, 0.15 * canvas_.em(), kLabel);
  canvas_.label(best->at, words, colour, best->anchor);
}

std::vector<LabelPlaces::Place> LabelPlaces::round(const Polyline& polygon, const std::string& words,
                                                   std::span<const double> directions) const {
  const double em = canvas_.em(), step = 0.1 * em;
  Point low = polygon.front(), high = low;
  for (const Point& p : polygon) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Obstacle own{polygon, true, 0.25 * em, 1, low, high};
  const Point centre = (low + high) / 2;
  const Point down(0, 0.27 * em);  // from the middle of the letters to their baseline
  std::vector<Place> places;
  for (const double angle : directions) {
    const Point along(std::cos(angle), std::sin(angle));
    Place place{centre - down};
    while (meet(own, box(words, place, 0))) place.at += step * along;
    for (int i = 0; i < 4; ++i) {
      places.push_back(place);
      place.at += 0.3 * em * along;
    }
  }
  return places;
}

}  // namespace requad::figures
