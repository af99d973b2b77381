#include "mesh/pictures/canvas.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <regex>
#include <stdexcept>

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

namespace requad::pictures {

namespace {

constexpr double kMargin = 8;          // points around the drawing
constexpr double kPixelsPerPoint = 2;  // of a PNG
constexpr double kLowered = 0.7;       // relative size of text that "_" lowers
constexpr const char* kDate =
    "2011-12-01T00:00:00Z";  // for every PDF, so that its bytes do not depend on the time: the paper's month

struct SurfaceDeleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;
struct ContextDeleter {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Context = std::unique_ptr<cairo_t, ContextDeleter>;

cairo_status_t append(void* text, const unsigned char* data, unsigned int size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(std::string("Cairo: ") + cairo_status_to_string(status));
}

// Cairo's SVG without default values, and without an id that counts the surfaces of the process. Paths stay as they are.
std::string without_noise(const std::string& svg) {
  static const std::regex noise(
      "fill-rule:nonzero;|fill-opacity:1;|stroke-opacity:1;|stroke-miterlimit:10;| id=\"surface[0-9]+\"");
  return std::regex_replace(svg, noise, "");
}

void paint_on(cairo_surface_t* surface, const Paint& paint, double x, double y) {
  const Context context(cairo_create(surface));
  cairo_translate(context.get(), x, y);
  cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context.get(), CAIRO_LINE_CAP_ROUND);
  cairo_select_font_face(context.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_set_font_options(context.get(), options);
  cairo_font_options_destroy(options);
  Canvas canvas(context.get());
  paint(canvas);
  check(cairo_status(context.get()));
}

struct TextPart {
  std::string words;
  bool lowered = false;
};
std::vector<TextPart> parts_of(const std::string& words) {
  std::vector<TextPart> parts{{}};
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] != '_' || i + 1 == words.size()) {
      parts.back().words += words[i];
      continue;
    }
    const std::size_t close = words[i + 1] == '{' ? words.find('}', i) : std::string::npos;
    if (close == std::string::npos) {
      parts.push_back({words.substr(++i, 1), true});
    } else {
      parts.push_back({words.substr(i + 2, close - i - 2), true});
      i = close;
    }
    parts.push_back({});
  }
  return parts;
}

}  // namespace

std::string to_hex(Colour colour) {
  std::array<char, 8> buffer{};
  const auto byte = [](double x) { return static_cast<unsigned>(std::lround(x * 255)) & 255U; };
  std::snprintf(buffer.data(), buffer.size(), "#%02x%02x%02x", byte(colour.red), byte(colour.green), byte(colour.blue));
  return buffer.data();
}

double Canvas::snapped(double x) const { return std::round(x / grid_) * grid_; }

void Canvas::trace(const Polyline& line, bool closed) {
  Polyline points;
  for (const Point& p : line) {
    const Point next(snapped(p.x()), -snapped(p.y()));
    // A point on the line between two others adds nothing. The test is exact, since the coordinates are rounded.
    while (points.size() >= 2) {
      const Point before = points.back() - points[points.size() - 2], after = next - points.back();
      if (before.x() * after.y() != before.y() * after.x() || before.dot(after) <= 0) break;
      points.pop_back();
    }
    points.push_back(next);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    (i == 0 ? cairo_move_to : cairo_line_to)(context_, points[i].x(), points[i].y());
  }
  if (closed) cairo_close_path(context_);
}

void Canvas::apply(Colour colour) { cairo_set_source_rgb(context_, colour.red, colour.green, colour.blue); }

void Canvas::apply(const Stroke& stroke) {
  apply(stroke.colour);
  cairo_set_line_width(context_, stroke.width);
  cairo_set_dash(context_, stroke.dashes.data(), static_cast<int>(stroke.dashes.size()), 0);
}

void Canvas::fill(const std::vector<Polyline>& polygons, Colour colour) {
  if (polygons.empty()) return;
  apply(colour);
  for (const Polyline& polygon : polygons) trace(polygon, true);
  cairo_fill(context_);
}

void Canvas::stroke(const std::vector<Polyline>& lines, const Stroke& stroke, bool closed) {
  if (lines.empty()) return;
  apply(stroke);
  for (const Polyline& line : lines) trace(line, closed);
  cairo_stroke(context_);
}

void Canvas::paint(std::optional<Colour> fill, const std::optional<Stroke>& stroke) {
  if (fill) {
    apply(*fill);
    cairo_fill_preserve(context_);
  }
  if (stroke) {
    apply(*stroke);
    cairo_stroke_preserve(context_);
  }
  cairo_new_path(context_);
}

void Canvas::polygon(const Polyline& polygon, std::optional<Colour> fill, const std::optional<Stroke>& stroke) {
  trace(polygon, true);
  paint(fill, stroke);
}

void Canvas::circle(Point centre, double radius, std::optional<Colour> fill, const std::optional<Stroke>& stroke) {
  cairo_new_sub_path(context_);
  cairo_arc(context_, snapped(centre.x()), -snapped(centre.y()), radius, 0, 2 * std::numbers::pi);
  cairo_close_path(context_);
  paint(fill, stroke);
}

void Canvas::arc(Point centre, double radius, double from, double to, const Stroke& stroke) {
  apply(stroke);
  cairo_new_sub_path(context_);
  cairo_arc_negative(context_, snapped(centre.x()), -snapped(centre.y()), radius, -from, -to);
  cairo_stroke(context_);
}

void Canvas::arrow(const Point& from, const Point& to, const Stroke& stroke, double head) {
  const Point along = (to - from).normalized();
  const Point across(-along.y(), along.x());
  this->stroke({{from, to - 0.7 * head * along}}, stroke);
  polygon({to, to - head * along + 0.45 * head * across, to - head * along - 0.45 * head * across}, stroke.colour, {});
}

void Canvas::text(Point at, const std::string& words, double size, Colour colour, Anchor anchor) {
  const std::vector<TextPart> parts = parts_of(words);
  const auto advance = [this](const TextPart& part, double part_size) {
    cairo_set_font_size(context_, part_size);
    cairo_text_extents_t extents;
    cairo_text_extents(context_, part.words.c_str(), &extents);
    return extents.x_advance;
  };
  double width = 0;
  for (const TextPart& part : parts) width += advance(part, part.lowered ? kLowered * size : size);
  double x = at.x() - (anchor == Anchor::centre ? width / 2 : anchor == Anchor::right ? width : 0);
  apply(colour);
  for (const TextPart& part : parts) {
    if (part.words.empty()) continue;
    const double part_width = advance(part, part.lowered ? kLowered * size : size);
    cairo_move_to(context_, snapped(x), -snapped(at.y() - (part.lowered ? 0.2 * size : 0)));
    cairo_show_text(context_, part.words.c_str());
    x += part_width;
  }
  cairo_new_path(context_);
}

std::string render(const Paint& paint, const std::string& format) {
  const Surface record(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr));
  paint_on(record.get(), paint, 0, 0);
  double x = 0, y = 0, width = 0, height = 0;
  cairo_recording_surface_ink_extents(record.get(), &x, &y, &width, &height);
  x = std::floor(x - kMargin);
  y = std::floor(y - kMargin);
  width = std::ceil(width + 2 * kMargin + 1);
  height = std::ceil(height + 2 * kMargin + 1);
  const Paint on_white = [&](Canvas& canvas) {
    canvas.fill({{{x, -y}, {x + width, -y}, {x + width, -y - height}, {x, -y - height}}}, rgb(0xffffff));
    paint(canvas);
  };
  std::string bytes;
  if (format == "svg" || format == "pdf") {
    const Surface surface((format == "svg" ? cairo_svg_surface_create_for_stream : cairo_pdf_surface_create_for_stream)(
        append, &bytes, width, height));
    if (format == "pdf") {
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, kDate);
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR, "requad");
    }
    paint_on(surface.get(), on_white, -x, -y);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
  } else if (format == "png") {
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width * kPixelsPerPoint),
                                                     static_cast<int>(height * kPixelsPerPoint)));
    cairo_surface_set_device_scale(surface.get(), kPixelsPerPoint, kPixelsPerPoint);
    paint_on(surface.get(), on_white, -x, -y);
    check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  } else {
    throw std::invalid_argument("no such picture format: " + format);
  }
  return format == "svg" ? without_noise(bytes) : bytes;
}

}  // namespace requad::pictures
