// Inline SVG for the HTML report. Colours and widths come from the page's style sheet, by class, so that a picture
// follows the page into dark mode and onto paper.
//
// Coordinates are y upwards, in units that are pixels where the page has room for the picture. They are rounded to one
// decimal. The picture is cropped to what is drawn.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace requad::verify {

using Point = Eigen::Vector2d;
using Polyline = std::vector<Point>;

// Text for HTML and for SVG.
std::string escaped(const std::string& text);

enum class Anchor { start, middle, end };
enum class Ends { open, closed };

class Svg {
 public:
  // All lines are one path. `css` is the class here and below.
  void path(const std::string& css, const std::vector<Polyline>& lines, Ends ends = Ends::open);
  void circle(const std::string& css, const Point& centre, double radius);
  // A line of text, `size` units high, with its middle at the height of `at`.
  void text(const std::string& css, const Point& at, const std::string& words, double size,
            Anchor anchor = Anchor::middle);
  // What is drawn until close() is one group with this class.
  void open(const std::string& css);
  void close();

  // The whole picture, with this class. Readers who do not see it get the description. Precondition: something is drawn.
  std::string element(const std::string& css, const std::string& description) const;

 private:
  void cover(const Point& low, const Point& high);

  std::string body_;
  bool is_empty_ = true;
  Point low_ = Point::Zero(), high_ = Point::Zero();
};

}  // namespace requad::verify
