#include "mesh/pictures/canvas.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/pictures/cairo_objects.hpp"

namespace requad::pictures {

namespace {

constexpr double kUsualLine = 0.5;  // points: the width of edges to which strokes refer
constexpr double kThinnest = 0.2;   // of edges on a page, if no width is asked for

}  // namespace

std::pair<Point, Point> Words::box() const {
  const double left = anchor == Anchor::left ? 0 : anchor == Anchor::centre ? width / 2 : width;
  const bool lowered = parts_of(text).size() > 1;
  return {at - Point(left, (lowered ? 0.34 : 0.22) * size), at + Point(width - left, 0.76 * size)};
}

std::vector<WordPart> parts_of(const std::string& text) {
  std::vector<WordPart> parts{{}};
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '_' || i + 1 == text.size()) {
      parts.back().text += text[i];
      continue;
    }
    const std::size_t close = text[i + 1] == '{' ? text.find('}', i) : std::string::npos;
    if (close == std::string::npos) {
      parts.push_back({text.substr(++i, 1), true});
    } else {
      parts.push_back({text.substr(i + 2, close - i - 2), true});
      i = close;
    }
    parts.push_back({});
  }
  return parts;
}

// Measures letters. They scale evenly, so that one size is enough.
struct Canvas::Letters {
  static constexpr double kSize = 64;
  Surface surface{cairo_recording_surface_create(CAIRO_CONTENT_ALPHA, nullptr)};
  Context context{cairo_create(surface.get())};

  explicit Letters(const std::string& font) {
    set_font(context.get(), font);
    cairo_set_font_size(context.get(), kSize);
  }
  double width(const std::string& text) const {
    double sum = 0;
    for (const WordPart& part : parts_of(text)) {
      cairo_text_extents_t extents;
      cairo_text_extents(context.get(), part.text.c_str(), &extents);
      sum += (part.lowered ? kLoweredSize : 1) * extents.x_advance / kSize;
    }
    return sum;
  }
};

Canvas::Canvas(const Style& style, double scale)
    : style_(style), scale_(scale), letters_(std::make_unique<Letters>(style.font)) {}
Canvas::~Canvas() = default;

double Canvas::width_of(const std::string& words) const { return em() * letters_->width(words); }

std::vector<std::string> Canvas::caption_lines(const std::vector<std::string>& words, double width) const {
  std::vector<std::string> lines;
  if (!style_.captions) return lines;
  for (const std::string& text : words) {
    std::string line;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find(' ', begin + 1), text.size());
      const std::string longer = line + text.substr(begin, end - begin);
      if (line.empty() || width_of(longer) <= width) {
        line = longer;
      } else {
        lines.push_back(line);
        line = text.substr(begin + 1, end - begin - 1);
      }
      begin = end;
    }
    lines.push_back(line);
  }
  return lines;
}

Stroke Canvas::fitted(const Stroke& stroke) const {
  const double factor =
      style_.line > 0 ? style_.line / kUsualLine / scale_ : std::max(1.0, kThinnest / kUsualLine / scale_);
  Stroke result = stroke;
  result.width *= factor;
  for (double& dash : result.dashes) dash *= factor;
  return result;
}
std::optional<Stroke> Canvas::fitted(const std::optional<Stroke>& stroke) const {
  return stroke ? std::optional(fitted(*stroke)) : std::nullopt;
}

void Canvas::fill(const std::vector<Polyline>& polygons, Colour colour) {
  if (!polygons.empty()) drawing_.items.emplace_back(Shape{polygons, true, colour, {}});
}

void Canvas::stroke(const std::vector<Polyline>& lines, const Stroke& stroke, bool closed) {
  if (!lines.empty()) drawing_.items.emplace_back(Shape{lines, closed, {}, fitted(stroke)});
}

void Canvas::polygon(const Polyline& polygon, std::optional<Colour> fill, const std::optional<Stroke>& stroke) {
  drawing_.items.emplace_back(Shape{{polygon}, true, fill, fitted(stroke)});
}

void Canvas::circle(Point centre, double radius, std::optional<Colour> fill, const std::optional<Stroke>& stroke) {
  drawing_.items.emplace_back(Arc{.centre = centre, .radius = radius, .fill = fill, .stroke = fitted(stroke)});
}

void Canvas::arc(Point centre, double radius, double from, double to, const Stroke& stroke) {
  drawing_.items.emplace_back(Arc{centre, radius, from, to, {}, fitted(stroke)});
}

void Canvas::arrow(const Point& from, const Point& to, const Stroke& stroke, double head) {
  const Point along = (to - from).normalized();
  const Point across(-along.y(), along.x());
  this->stroke({{from, to - 0.7 * head * along}}, stroke);
  polygon({to, to - head * along + 0.45 * head * across, to - head * along - 0.45 * head * across}, stroke.colour, {});
}

void Canvas::words(Point at, const std::string& words, Colour colour, Anchor anchor, bool halo) {
  if (words.empty()) return;
  drawing_.items.emplace_back(
      Words{at, words, em(), width_of(words), colour, anchor, halo ? std::optional(palette().paper) : std::nullopt});
}

void Canvas::label(Point at, const std::string& words, Colour colour, Anchor anchor) {
  if (style_.labels) this->words(at, words, colour, anchor, true);
}

void Canvas::caption(Point at, const std::string& words, Anchor anchor) {
  if (style_.captions) this->words(at, words, palette().ink, anchor, false);
}

void Canvas::caption(Point at, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    caption(at, line);
    at.y() -= line_height();
  }
}

}  // namespace requad::pictures
