#include "figures/panels/labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace requad::figures {

namespace {

using Rectangle = std::pair<Point, Point>;

// Whether a segment, which may be a point, meets a rectangle.
bool segment_meets(const Point& a, const Point& b, const Rectangle& box) {
  double from = 0, to = 1;
  for (int k = 0; k < 2; ++k) {
    const double d = b[k] - a[k];
    if (std::abs(d) < 1e-12) {
      if (a[k] < box.first[k] || a[k] > box.second[k]) return false;
      continue;
    }
    const double s = (box.first[k] - a[k]) / d, t = (box.second[k] - a[k]) / d;
    from = std::max(from, std::min(s, t));
    to = std::min(to, std::max(s, t));
  }
  return from <= to;
}

bool contains(const Polyline& polygon, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
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
  const Polyline& shape = obstacle.shape;
  for (std::size_t i = obstacle.area ? 0 : 1; i < shape.size(); ++i) {
    if (segment_meets(shape[i == 0 ? shape.size() - 1 : i - 1], shape[i], {low, high})) return true;
  }
  return obstacle.area && contains(shape, (low + high) / 2);
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
