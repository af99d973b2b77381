// A page to draw on, through Cairo: SVG, PDF and PNG from one description.
//
// Coordinates are points (1/72 inch), x to the right and y upwards; the page is cut to what was drawn. All coordinates
// are rounded to 1/4 point, which keeps files small. The same drawing gives the same bytes.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

struct
    _cairo;  // cairo_t, so that users of this header need no Cairo. NOLINT(bugprone-reserved-identifier): its own name

namespace requad::pictures {

using Point = Eigen::Vector2d;
using Polyline = std::vector<Point>;

struct Colour {
  double red = 0, green = 0, blue = 0;  // 0..1
};
// 0xRRGGBB
constexpr Colour rgb(unsigned value) {
  return {(value >> 16 & 255U) / 255.0, (value >> 8 & 255U) / 255.0, (value & 255U) / 255.0};
}
std::string to_hex(Colour colour);  // "#rrggbb"

struct Stroke {
  Colour colour;
  double width = 0.5;
  std::vector<double> dashes = {};  // lengths on, off, ...; empty: solid
};

enum class Anchor { left, centre, right };

class Canvas {
 public:
  explicit Canvas(_cairo* context) : context_(context) {}

  void fill(const std::vector<Polyline>& polygons, Colour colour);
  void stroke(const std::vector<Polyline>& lines, const Stroke& stroke, bool closed = false);
  void polygon(const Polyline& polygon, std::optional<Colour> fill, const std::optional<Stroke>& stroke);
  void circle(Point centre, double radius, std::optional<Colour> fill, const std::optional<Stroke>& stroke);
  // Part of a circle, counter-clockwise from one angle (radians) to another.
  void arc(Point centre, double radius, double from, double to, const Stroke& stroke);
  // A line with a head at its end.
  void arrow(const Point& from, const Point& to, const Stroke& stroke, double head = 6);
  // UTF-8; "_" sets the next character, or the next ones in braces, lower: "E_1", "e_{12}". `at` is the baseline's
  // left, middle or right; a capital is about 0.7 `size` high.
  void text(Point at, const std::string& words, double size, Colour colour = {}, Anchor anchor = Anchor::centre);

 private:
  void trace(const Polyline& line, bool closed);
  void apply(Colour colour);
  void apply(const Stroke& stroke);
  // Fills and strokes the path, as far as is asked for, and drops it.
  void paint(std::optional<Colour> fill, const std::optional<Stroke>& stroke);

  _cairo* context_;
};

using Paint = std::function<void(Canvas&)>;

// What `paint` draws, on white, as "svg", "pdf" or "png" (144 dots per inch). Paint is called twice: to measure and to
// draw. Throws std::invalid_argument for another format, std::runtime_error if Cairo fails.
std::string render(const Paint& paint, const std::string& format);

}  // namespace requad::pictures
