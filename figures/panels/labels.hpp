// Places for labels where they cover nothing.
//
// Lines, areas and the labels that are already there block the page. A label goes to the first place on its list that is
// free; if none is, to the one where it covers least. It covers a line rather than another label.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

class LabelPlaces {
 public:
  struct Place {
    Point at;
    Anchor anchor = Anchor::centre;
  };

  explicit LabelPlaces(Canvas& canvas) : canvas_(canvas) {}

  // Blocks a line, or the inside of a polygon. `clearance`: how far a label stays away.
  void block(const Polyline& line, double clearance = 0);
  void block_area(const Polyline& polygon, double clearance = 0);
  void block_point(const Point& at, double radius) { block({at, at}, radius); }

  // Draws a label. O(places * obstacles). Precondition: there is a place.
  void put(const std::string& words, Colour colour, std::span<const Place> places);

  // Places round a convex polygon: for each direction, an angle in radians, the nearest one to the polygon from its
  // centre, and a few that are further away. They are sorted by direction.
  std::vector<Place> round(const Polyline& polygon, const std::string& words, std::span<const double> directions) const;

 private:
  struct Obstacle {
    Polyline shape;
    bool area;
    double clearance;
    int weight;
    Point low, high;
  };
  using Box = std::pair<Point, Point>;

  Box box(const std::string& words, const Place& place, double clearance) const;
  static bool meet(const Obstacle& obstacle, const Box& box);
  void add(const Polyline& shape, bool area, double clearance, int weight = 1);

  Canvas& canvas_;
  std::vector<Obstacle> obstacles_;
};

}  // namespace requad::figures
