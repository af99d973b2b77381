// A canvas to draw on, for files of several formats (page.hpp).
//
// Terms
//   unit    of the drawing (drawing.hpp). On a page, a unit is `scale` points.
//   label   words that name something in the drawing; none are drawn if the style has no labels
//   caption words below a panel, and legends; none are drawn if the style has no captions
// Meshes and distances grow with the scale; letters do not, since their size on the page is fixed. A painter that leaves
// room for words therefore asks the canvas how large they are.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh/pictures/drawing.hpp"

namespace requad::pictures {

class Canvas {
 public:
  explicit Canvas(const Style& style, double scale = 1);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  const Style& style() const { return style_; }
  const Palette& palette() const { return style_.palette; }
  // The size of letters, in units.
  double em() const { return style_.text / scale_; }
  // The room between two lines of words, in units.
  double line_height() const { return 1.25 * em(); }
  // How wide words are, in units.
  double width_of(const std::string& words) const;
  // The words in lines that are no wider than this many units, unless a single word is. No line without captions.
  std::vector<std::string> caption_lines(const std::vector<std::string>& words, double width) const;

  // Widths and dashes of strokes are in points as drawn at scale 1 with edges of half a point; Style::line says what
  // they become.
  void fill(const std::vector<Polyline>& polygons, Colour colour);
  void stroke(const std::vector<Polyline>& lines, const Stroke& stroke, bool closed = false);
  void polygon(const Polyline& polygon, std::optional<Colour> fill, const std::optional<Stroke>& stroke);
  void circle(Point centre, double radius, std::optional<Colour> fill, const std::optional<Stroke>& stroke);
  // Draws a part of a circle, counter-clockwise from one angle to another, in radians.
  void arc(Point centre, double radius, double from, double to, const Stroke& stroke);
  // Draws a line with a head, `head` units long, at its end.
  void arrow(const Point& from, const Point& to, const Stroke& stroke, double head = 6);
  // See Words. A label has a halo in the colour of the paper.
  void label(Point at, const std::string& words, Colour colour, Anchor anchor = Anchor::centre);
  void caption(Point at, const std::string& words, Anchor anchor = Anchor::centre);
  // Draws lines of words below each other, centred. `at` is the middle of the first baseline.
  void caption(Point at, const std::vector<std::string>& lines);

  // Rounds coordinates on the page to multiples of this many points, a power of 2.
  void round_to(double points) { drawing_.grid = points; }
  const Drawing& drawing() const { return drawing_; }

 private:
  struct Letters;
  Stroke fitted(const Stroke& stroke) const;
  std::optional<Stroke> fitted(const std::optional<Stroke>& stroke) const;
  void words(Point at, const std::string& words, Colour colour, Anchor anchor, bool halo);

  Style style_;
  double scale_;
  std::unique_ptr<Letters> letters_;
  Drawing drawing_;
};

using Paint = std::function<void(Canvas&)>;

}  // namespace requad::pictures
