// Legends: symbols with their meanings, in lines below a figure.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

struct LegendEntry {
  std::string words;
  // Draws the symbol round a point. It may be 22 times `unit` wide and 10 times high; `unit` grows with the letters.
  std::function<void(Canvas&, Point, double unit)> symbol;

  static LegendEntry line(std::string words, const Stroke& stroke);
  static LegendEntry face(std::string words, Colour colour);
  static LegendEntry mark(std::string words, int valence);
  static LegendEntry faint(std::string words);
  static LegendEntry star(std::string words, Colour colour);
};

// Draws a legend, which is a caption: entries from left to right, in as many lines as `width` needs. They are centred.
// `top` is the middle of the upper rim.
void paint_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, Point top, double width);

}  // namespace requad::figures
