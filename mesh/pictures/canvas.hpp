// A page to draw on: SVG, PDF and PNG from one description, by Cairo.
//
// Coordinates are in points (1/72 inch), x to the right and y upwards. They are rounded to 1/4 point, or as round_to()
// says, which keeps files small. The page is cropped to the drawing. The same drawing gives the same bytes.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

// Cairo's cairo_t. Users of this header need no header of Cairo.
struct _cairo;  // NOLINT(bugprone-reserved-identifier): the name that Cairo gives it

namespace requad::pictures {

using Point = Eigen::Vector2d;
using Polyline = std::vector<Point>;

struct Colour {
  double red = 0, green = 0, blue = 0;  // 0..1
};
// The colour 0xRRGGBB.
constexpr Colour rgb(unsigned value) {
  return {(value >> 16 & 255U) / 255.0, (value >> 8 & 255U) / 255.0, (value & 255U) / 255.0};
}
std::string to_hex(Colour colour);  // "#rrggbb"

struct Stroke {
  Colour colour;
  double width = 0.5;               // in points
  std::vector<double> dashes = {};  // lengths in points: on, off, ...; a solid line if empty
};

enum class Anchor { left, centre, right };

class Canvas {
 public:
  // The context must outlive the canvas.
  explicit Canvas(_cairo* context) : context_(context) {}

  // Rounds coordinates from now on to multiples of `points`, a power of 2.
  void round_to(double points) { grid_ = points; }

  void fill(const std::vector<Polyline>& polygons, Colour colour);
  void stroke(const std::vector<Polyline>& lines, const Stroke& stroke, bool closed = false);
  void polygon(const Polyline& polygon, std::optional<Colour> fill, const std::optional<Stroke>& stroke);
  void circle(Point centre, double radius, std::optional<Colour> fill, const std::optional<Stroke>& stroke);
  // Draws a part of a circle, counter-clockwise from one angle to another, in radians.
  void arc(Point centre, double radius, double from, double to, const Stroke& stroke);
  // Draws a line with a head, `head` points long, at its end.
  void arrow(const Point& from, const Point& to, const Stroke& stroke, double head = 6);
  // Draws UTF-8 text. "_" lowers the next character, or the characters in the braces that follow: "E_1", "e_{12}". `at`
  // is the left end, the middle or the right end of the baseline. A capital is about 0.7 `size` high.
  void text(Point at, const std::string& words, double size, Colour colour = {}, Anchor anchor = Anchor::centre);

 private:
  double snapped(double x) const;
  void trace(const Polyline& line, bool closed);
  void apply(Colour colour);
  void apply(const Stroke& stroke);
  // Fills the current path, if there is a colour, strokes it, if there is a stroke, and clears it.
  void paint(std::optional<Colour> fill, const std::optional<Stroke>& stroke);

  _cairo* context_;
  double grid_ = 0.25;
};

using Paint = std::function<void(Canvas&)>;

// The drawing on white as "svg", "pdf" or "png" (144 dots per inch). Calls `paint` twice: to measure and to draw.
// Throws std::invalid_argument for another format and std::runtime_error if Cairo fails.
std::string render(const Paint& paint, const std::string& format);

}  // namespace requad::pictures
