#include "verify/report/svg.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace requad::verify {

namespace {

constexpr double kMargin = 8;
constexpr double kLetter = 0.6;  // the width of a letter, in its size: an estimate, since the page chooses the font

std::string number(double x) {
  const double rounded = std::round(10 * x) / 10;
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), rounded == 0 ? 0 : rounded).ptr;
  return {text.data(), end};
}

std::string attribute(const char* name, double value) { return std::string(" ") + name + "=\"" + number(value) + '"'; }

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c;
    }
  }
  return result;
}

void Svg::cover(const Point& low, const Point& high) {
  low_ = is_empty_ ? low : low_.cwiseMin(low);
  high_ = is_empty_ ? high : high_.cwiseMax(high);
  is_empty_ = false;
}

void Svg::path(const std::string& css, const std::vector<Polyline>& lines, Ends ends) {
  body_ += "<path class=\"" + css + "\" d=\"";
  for (const Polyline& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      cover(line[i], line[i]);
      body_ += (i == 0 ? "M" : "L") + number(line[i].x()) + " " + number(-line[i].y());
    }
    if (ends == Ends::closed) body_ += 'Z';
  }
  body_ += "\"/>";
}

void Svg::circle(const std::string& css, const Point& centre, double radius) {
  cover(centre.array() - radius, centre.array() + radius);
  body_ += "<circle class=\"" + css + '"' + attribute("cx", centre.x()) + attribute("cy", -centre.y()) +
           attribute("r", radius) + "/>";
}

void Svg::text(const std::string& css, const Point& at, const std::string& words, double size, Anchor anchor) {
  const double width = kLetter * size * static_cast<double>(words.size());
  const double left = at.x() - (anchor == Anchor::start ? 0 : anchor == Anchor::middle ? width / 2 : width);
  cover({left, at.y() - size / 2}, {left + width, at.y() + size / 2});
  const char* const anchors[] = {"start", "middle", "end"};
  // A capital is about 0.7 of the size high.
  body_ += "<text class=\"" + css + '"' + attribute("x", at.x()) + attribute("y", -at.y() + 0.35 * size) +
           attribute("font-size", size) + " text-anchor=\"" + anchors[static_cast<int>(anchor)] + "\">" +
           escaped(words) + "</text>";
}

void Svg::open(const std::string& css) { body_ += "<g class=\"" + css + "\">"; }

void Svg::close() { body_ += "</g>"; }

std::string Svg::element(const std::string& css, const std::string& description) const {
  const Point size = high_ - low_ + Point::Constant(2 * kMargin);
  return "<svg class=\"" + css + "\" role=\"img\" aria-label=\"" + escaped(description) + "\" viewBox=\"" +
         number(low_.x() - kMargin) + ' ' + number(-high_.y() - kMargin) + ' ' + number(size.x()) + ' ' +
         number(size.y()) + '"' + attribute("width", size.x()) + attribute("height", size.y()) + '>' + body_ + "</svg>";
}

}  // namespace requad::verify
