// Files of drawings: SVG, PDF and PNG by Cairo, and TikZ for papers that LaTeX sets.
//
// A page is white and cropped to the drawing. The same drawing gives the same bytes.
#pragma once

#include <optional>
#include <string>

#include "mesh/pictures/canvas.hpp"

namespace requad::pictures {

struct Page {
  Style style = {};
  // The width of the page in points (1/72 inch). The drawing is scaled until it has this width; letters and lines keep
  // the sizes of the style. If none is asked for, a unit of the drawing is a point.
  std::optional<double> width = {};
  std::string title = {};        // of the SVG and the PDF
  std::string description = {};  // of the SVG: what the figure shows, in words
  bool real_text = false;        // an SVG with letters as text, which can be searched and edited, not as outlines
  double resolution = 144;       // of a PNG, in dots per inch
};

// The drawing as "svg", "pdf", "png" or "tikz". Calls `paint` once, or about ten times if the page has a width.
// Throws std::invalid_argument for another format and for a page that is too narrow for the words of the drawing, and
// std::runtime_error if Cairo fails.
std::string render(const Paint& paint, const std::string& format, const Page& page = {});

}  // namespace requad::pictures
