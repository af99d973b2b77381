// A drawing as a list of what is painted, from the back to the front. Canvas writes it; page.hpp makes files of it.
//
// Coordinates are in units of the drawing, x to the right and y upwards. On a page, a unit is `scale` points.
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "mesh/pictures/style.hpp"

namespace requad::pictures {

using Point = Eigen::Vector2d;
using Polyline = std::vector<Point>;

struct Stroke {
  Colour colour;
  double width = 0.5;
  std::vector<double> dashes = {};  // lengths: on, off, ...; a solid line if empty
};

enum class Anchor { left, centre, right };

// Lines, or the outlines of an area.
struct Shape {
  std::vector<Polyline> lines;
  bool closed = false;
  std::optional<Colour> fill = {};
  std::optional<Stroke> stroke = {};
};

// A part of a circle, counter-clockwise between two angles in radians.
struct Arc {
  Point centre;
  double radius;
  double from = 0, to = 2 * std::numbers::pi;
  std::optional<Colour> fill = {};
  std::optional<Stroke> stroke = {};

  bool whole() const { return to - from >= 2 * std::numbers::pi; }
};

// UTF-8 text. "_" lowers the next character, or the characters in the braces that follow: "E_1", "e_{12}".
struct Words {
  Point at;  // the left end, the middle or the right end of the baseline
  std::string text;
  double size;   // a capital is about 0.7 of it high
  double width;  // from the left to the right end
  Colour colour;
  Anchor anchor = Anchor::centre;
  std::optional<Colour> halo = {};  // a rim round the letters, on top of what is behind

  // Lower left and upper right corner of what the words take up.
  std::pair<Point, Point> box() const;
};

struct WordPart {
  std::string text;
  bool lowered = false;
};
std::vector<WordPart> parts_of(const std::string& text);
inline constexpr double kLoweredSize = 0.7;  // of lowered characters, in sizes of the others
inline constexpr double kLoweredBy = 0.2;
inline constexpr double kHalo = 0.22;  // width of a halo on either side, in sizes of the letters

using Item = std::variant<Shape, Arc, Words>;

struct Drawing {
  std::vector<Item> items;
  double grid = 0.25;  // coordinates on a page are multiples of this many points, a power of 2
};

}  // namespace requad::pictures
