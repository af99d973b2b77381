#include "mesh/pictures/page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>
#include <stdexcept>

#include <boost/crc.hpp>
#include <cairo-pdf.h>
#include <cairo-svg.h>

#include "mesh/pictures/cairo_objects.hpp"
#include "mesh/pictures/layout_on_page.hpp"
#include "mesh/text/fixed_decimals.hpp"

namespace requad::pictures {

namespace {

constexpr double kPointsPerInch = 72;
constexpr double kInchesPerMetre = 1 / 0.0254;
constexpr const char* kDate =
    "2011-12-01T00:00:00Z";  // for every PDF, so that its bytes do not depend on the time: the paper's month

cairo_status_t append(void* text, const unsigned char* data, unsigned int size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(std::string("Cairo: ") + cairo_status_to_string(status));
}

// Paints the items of a drawing, with y downwards.
class Painter {
 public:
  Painter(cairo_t* context, const PlacedDrawing& placed, bool with_words)
      : context_(context), placed_(placed), with_words_(with_words) {}

  void operator()(const Shape& shape) const {
    for (const Polyline& line : shape.lines) {
      const Polyline points = placed_.at(line);
      for (std::size_t i = 0; i < points.size(); ++i)
        (i == 0 ? cairo_move_to : cairo_line_to)(context_, points[i].x(), -points[i].y());
      if (shape.closed) cairo_close_path(context_);
    }
    paint(shape.fill, shape.stroke);
  }

  void operator()(const Arc& arc) const {
    const Point centre = placed_.at(arc.centre);
    cairo_new_sub_path(context_);
    if (arc.whole()) {
      cairo_arc(context_, centre.x(), -centre.y(), placed_.scale * arc.radius, 0, 2 * std::numbers::pi);
      cairo_close_path(context_);
    } else {
      cairo_arc_negative(context_, centre.x(), -centre.y(), placed_.scale * arc.radius, -arc.from, -arc.to);
    }
    paint(arc.fill, arc.stroke);
  }

  void operator()(const Words& words) const {
    if (!with_words_) return;
    const double size = placed_.scale * words.size, width = placed_.scale * words.width;
    const Point at = placed_.at(words.at);
    const double left = words.anchor == Anchor::left ? 0 : words.anchor == Anchor::centre ? width / 2 : width;
    if (words.halo) {
      letters(words, at - Point(left, 0), size, cairo_text_path);
      apply(Stroke{*words.halo, 2 * kHalo * words.size});
      cairo_stroke(context_);
    }
    apply(words.colour);
    letters(words, at - Point(left, 0), size, cairo_show_text);
    cairo_new_path(context_);
  }

 private:
  template <class Show>
  void letters(const Words& words, Point at, double size, Show show) const {
    for (const WordPart& part : parts_of(words.text)) {
      if (part.text.empty()) continue;
      cairo_set_font_size(context_, (part.lowered ? kLoweredSize : 1) * size);
      cairo_text_extents_t extents;
      cairo_text_extents(context_, part.text.c_str(), &extents);
      cairo_move_to(context_, snapped(at.x()), snapped((part.lowered ? kLoweredBy * size : 0) - at.y()));
      show(context_, part.text.c_str());
      at.x() += extents.x_advance;
    }
  }
  double snapped(double x) const { return std::round(x / placed_.drawing.grid) * placed_.drawing.grid; }

  void apply(Colour colour) const { cairo_set_source_rgb(context_, colour.red, colour.green, colour.blue); }
  void apply(const Stroke& stroke) const {
    apply(stroke.colour);
    cairo_set_line_width(context_, placed_.scale * stroke.width);
    std::vector<double> dashes = stroke.dashes;
    for (double& dash : dashes) dash *= placed_.scale;
    cairo_set_dash(context_, dashes.data(), static_cast<int>(dashes.size()), 0);
  }
  // Fills the current path, if there is a colour, strokes it, if there is a stroke, and clears it.
  void paint(const std::optional<Colour>& fill, const std::optional<Stroke>& stroke) const {
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

  cairo_t* context_;
  const PlacedDrawing& placed_;
  bool with_words_;
};

void paint_on(cairo_surface_t* surface, const PlacedDrawing& placed, const std::string& font, bool with_words = true) {
  const Context context(cairo_create(surface));
  cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context.get(), CAIRO_LINE_CAP_ROUND);
  set_font(context.get(), font);
  if (placed.size.x() > 0) {
    cairo_set_source_rgb(context.get(), 1, 1, 1);
    cairo_rectangle(context.get(), 0, 0, placed.size.x(), placed.size.y());
    cairo_fill(context.get());
  }
  cairo_translate(context.get(), -placed.low.x(), placed.low.y() + placed.size.y());
  for (const Item& item : placed.drawing.items) std::visit(Painter(context.get(), placed, with_words), item);
  check(cairo_status(context.get()));
}

// --- SVG -------------------------------------------------------------------------------------------------------------

std::string in_xml(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return result;
}

std::string number(double x) { return mesh::short_decimals(x, 2); }

std::string text_element(const Words& words, const PlacedDrawing& placed) {
  const double size = placed.scale * words.size;
  const Point at = placed.at(words.at) - placed.low;
  std::string element = "<text x=\"" + number(at.x()) + "\" y=\"" + number(placed.size.y() - at.y()) +
                        "\" font-size=\"" + number(size) + "\" fill=\"" + to_hex(words.colour) + "\"";
  if (words.anchor != Anchor::left)
    element += std::string(" text-anchor=\"") + (words.anchor == Anchor::centre ? "middle" : "end") + "\"";
  if (words.halo)
    element += " stroke=\"" + to_hex(*words.halo) + "\" stroke-width=\"" + number(2 * kHalo * size) +
               "\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
  element += ">";
  bool below = false;
  for (const WordPart& part : parts_of(words.text)) {
    if (part.text.empty()) continue;
    const std::string shift = part.lowered == below ? "" : number((part.lowered ? kLoweredBy : -kLoweredBy) * size);
    below = part.lowered;
    if (!part.lowered && shift.empty()) {
      element += in_xml(part.text);
      continue;
    }
    element += "<tspan" + (shift.empty() ? "" : " dy=\"" + shift + "\"") +
               (part.lowered ? " font-size=\"" + number(kLoweredSize * size) + "\"" : "") + ">" + in_xml(part.text) +
               "</tspan>";
  }
  return element + "</text>\n";
}

// Cairo's SVG with a title and a description, without default values, and without an id that counts the surfaces of the
// process. Paths stay as they are. Real text, which Cairo does not write, lies in front of everything else.
std::string finished_svg(const std::string& svg, const PlacedDrawing& placed, const Page& page) {
  static const std::regex noise(
      "fill-rule:nonzero;|fill-opacity:1;|stroke-opacity:1;|stroke-miterlimit:10;| id=\"surface[0-9]+\"");
  std::string result = std::regex_replace(svg, noise, "");
  std::string about;
  if (!page.title.empty()) about += "<title>" + in_xml(page.title) + "</title>\n";
  if (!page.description.empty()) about += "<desc>" + in_xml(page.description) + "</desc>\n";
  result.insert(result.find(">\n", result.find("<svg")) + 2, about);
  if (!page.real_text) return result;
  std::string texts = "<g font-family=\"" + in_xml(page.style.font) + "\">\n";
  for (const Item& item : placed.drawing.items) {
    if (const auto* words = std::get_if<Words>(&item)) texts += text_element(*words, placed);
  }
  return result.insert(result.rfind("</svg>"), texts + "</g>\n");
}

// --- PNG -------------------------------------------------------------------------------------------------------------

// The PNG with its resolution, which Cairo does not write: a chunk pHYs behind the header.
std::string with_resolution(std::string png, double dots_per_inch) {
  const auto dots = static_cast<std::uint32_t>(std::lround(dots_per_inch * kInchesPerMetre));
  const auto bytes = [](std::uint32_t x) {
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(x >> shift & 255U);
    return text;
  };
  const std::string body = "pHYs" + bytes(dots) + bytes(dots) + '\1';  // dots per metre
  boost::crc_32_type crc;
  crc.process_bytes(body.data(), body.size());
  constexpr std::size_t kHeader = 33;  // signature and IHDR
  return png.insert(kHeader, bytes(9) + body + bytes(crc.checksum()));
}

// --- the place on the page -------------------------------------------------------------------------------------------

constexpr double kMargin = 8;      // points around the drawing
constexpr double kSlimMargin = 1;  // the same on a page whose width is asked for
constexpr double kLeastScale = 0.1, kGreatestScale = 40;

struct Extent {
  Point low, size;
};
Extent extent(const PlacedDrawing& placed, const std::string& font) {
  const Surface record(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr));
  paint_on(record.get(), placed, font);
  double x = 0, y = 0, width = 0, height = 0;
  cairo_recording_surface_ink_extents(record.get(), &x, &y, &width, &height);
  return {{x, -y - height}, {width, height}};
}

PlacedDrawing at_scale(const Paint& paint, const Style& style, double scale) {
  Canvas canvas(style, scale);
  paint(canvas);
  return {canvas.drawing(), scale};
}

// The largest scale, nearly, at which the drawing is no wider than this.
PlacedDrawing as_wide_as(const Paint& paint, const Style& style, double width) {
  const auto excess = [&](const PlacedDrawing& p) { return extent(p, style.font).size.x() - width; };
  PlacedDrawing narrow = at_scale(paint, style, kLeastScale);
  double below = excess(narrow);
  if (below > 0) {
    throw std::invalid_argument("a page " + number(width + 2 * kSlimMargin) + " points wide is too narrow for the " +
                                "words of this figure at " + number(style.text) + " points; it needs " +
                                number(std::ceil(below + width + 2 * kSlimMargin)));
  }
  double low = kLeastScale, high = 1, above = 0;
  while ((above = excess(at_scale(paint, style, high))) < 0 && high < kGreatestScale) high *= 2;
  // The width grows almost linearly with the scale, and jumps where words need another line.
  constexpr double kClose = 0.25;  // points
  for (int i = 0; i < 24 && below < -kClose && high - low > 1e-4 * high; ++i) {
    const double guess = low + (high - low) * std::clamp(below / (below - above), 0.02, 0.98);
    const double scale = i % 3 == 2 ? (low + high) / 2 : guess;
    PlacedDrawing tried = at_scale(paint, style, scale);
    const double now = excess(tried);
    if (now > 0) {
      high = scale;
      above = now;
    } else {
      low = scale;
      below = now;
      narrow = std::move(tried);
    }
  }
  return narrow;
}

}  // namespace

Point PlacedDrawing::at(const Point& p) const {
  return {std::round(scale * p.x() / drawing.grid) * drawing.grid,
          std::round(scale * p.y() / drawing.grid) * drawing.grid};
}

Polyline PlacedDrawing::at(const Polyline& line) const {
  Polyline points;
  for (const Point& p : line) {
    const Point next = at(p);
    // The test is exact, since the coordinates are rounded.
    while (points.size() >= 2) {
      const Point before = points.back() - points[points.size() - 2], after = next - points.back();
      if (before.x() * after.y() != before.y() * after.x() || before.dot(after) <= 0) break;
      points.pop_back();
    }
    points.push_back(next);
  }
  return points;
}

PlacedDrawing placed(const Paint& paint, const Page& page) {
  PlacedDrawing result =
      page.width ? as_wide_as(paint, page.style, *page.width - 2 * kSlimMargin) : at_scale(paint, page.style, 1);
  const auto [low, size] = extent(result, page.style.font);
  if (page.width) {
    result.size = {*page.width, std::ceil(size.y() + 2 * kSlimMargin)};
    result.low = low + (size - result.size) / 2;
  } else {
    const Point corner = (low.array() - kMargin).floor();
    const Point above = (low + size).array() + kMargin;
    result.size = (size.array() + 2 * kMargin + 1).ceil();
    result.low = {corner.x(), std::ceil(above.y()) - result.size.y()};
  }
  return result;
}

std::string render(const Paint& paint, const std::string& format, const Page& page) {
  const PlacedDrawing drawing = placed(paint, page);
  const Point size = drawing.size;
  std::string bytes;
  if (format == "tikz") return tikz(drawing, page);
  if (format == "svg") {
    const Surface surface(cairo_svg_surface_create_for_stream(append, &bytes, size.x(), size.y()));
    paint_on(surface.get(), drawing, page.style.font, !page.real_text);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    return finished_svg(bytes, drawing, page);
  }
  if (format == "pdf") {
    const Surface surface(cairo_pdf_surface_create_for_stream(append, &bytes, size.x(), size.y()));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, kDate);
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR, "requad");
    if (!page.title.empty())
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, page.title.c_str());
    paint_on(surface.get(), drawing, page.style.font);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    return bytes;
  }
  if (format == "png") {
    const double dots = page.resolution / kPointsPerInch;
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(size.x() * dots)),
                                                     static_cast<int>(std::ceil(size.y() * dots))));
    check(cairo_surface_status(surface.get()));
    const Context ground(cairo_create(surface.get()));  // also of the pixels that the page fills in part
    cairo_set_source_rgb(ground.get(), 1, 1, 1);
    cairo_paint(ground.get());
    cairo_surface_set_device_scale(surface.get(), dots, dots);
    paint_on(surface.get(), drawing, page.style.font);
    check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
    return with_resolution(std::move(bytes), page.resolution);
  }
  throw std::invalid_argument("no such picture format: " + format);
}

}  // namespace requad::pictures
