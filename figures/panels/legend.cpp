#include "figures/panels/legend.hpp"

#include <algorithm>

#include "mesh/pictures/mesh_picture.hpp"

namespace requad::figures {

namespace {

constexpr double kSymbol = 22;  // times the unit of symbols

Polyline rectangle(Point at, double width, double height) {
  const Point across(width / 2, 0), up(0, height / 2);
  return {at - across - up, at + across - up, at + across + up, at - across + up};
}

}  // namespace

LegendEntry LegendEntry::line(std::string words, const Stroke& stroke) {
  return {std::move(words), [stroke](Canvas& canvas, Point at, double unit) {
            canvas.stroke({{at - Point(unit * kSymbol / 2, 0), at + Point(unit * kSymbol / 2, 0)}}, stroke);
          }};
}

LegendEntry LegendEntry::face(std::string words, Colour colour) {
  return {std::move(words), [colour](Canvas& canvas, Point at, double unit) {
            canvas.polygon(rectangle(at, 14 * unit, 9 * unit), colour, Stroke{canvas.palette().line, 0.5});
          }};
}

LegendEntry LegendEntry::mark(std::string words, int valence) {
  return {std::move(words),
          [valence](Canvas& canvas, Point at, double unit) { mark_vertex(canvas, at, valence, unit * kMarkRadius); }};
}

LegendEntry LegendEntry::faint(std::string words) {
  return {
      std::move(words), [](Canvas& canvas, Point at, double unit) {
        canvas.polygon(rectangle(at, 14 * unit, 9 * unit), canvas.palette().paper, Stroke{canvas.palette().faint, 0.9});
      }};
}

LegendEntry LegendEntry::star(std::string words, Colour colour) {
  return {std::move(words),
          [colour](Canvas& canvas, Point at, double unit) { mark_star(canvas, at, 5 * unit, colour); }};
}

void paint_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, Point top, double width) {
  if (!canvas.style().captions) return;
  const double em = canvas.em(), unit = std::max(1.0, em / 10), gap = 1.6 * em;
  const double before_words = kSymbol * unit + 0.5 * em;
  const auto width_of = [&](const LegendEntry& entry) { return before_words + canvas.width_of(entry.words); };
  Point middle = top - Point(0, 8 * unit);
  for (std::size_t first = 0; first < entries.size();) {
    std::size_t last = first;
    double sum = -gap;
    while (last < entries.size() && (last == first || sum + gap + width_of(entries[last]) <= width))
      sum += gap + width_of(entries[last++]);
    double x = middle.x() - sum / 2;
    for (; first < last; ++first) {
      entries[first].symbol(canvas, {x + kSymbol * unit / 2, middle.y()}, unit);
      canvas.caption({x + before_words, middle.y() - 0.27 * em}, entries[first].words, Anchor::left);
      x += width_of(entries[first]) + gap;
    }
    middle.y() -= 15 * unit;
  }
}

}  // namespace requad::figures
