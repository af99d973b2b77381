// All figures: what each shows, and how it is made.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "figures/grid_figure.hpp"
#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

// What may be chosen; the defaults are the gallery's.
struct Choices {
  std::optional<int> side;                               // of regular regions
  std::array<int, 4> pair_region{2, 1, 4, 3};            // d1, d2, M, N of figure 12
  std::vector<theory::Integer> sides{4, 5, 4, 4, 5, 4};  // of the hexagon
};

struct Picture {
  Paint paint;
  std::optional<GridFigure> grid;  // what DOT and GraphML are written from
};

struct CatalogueEntry {
  const char* id;     // "2", ..., "14", "dual-10", ...: what --figure takes
  const char* paper;  // the paper's figure, or ""
  const char* title;
  const char* caption;  // Markdown, one paragraph
  bool is_grid;
  std::function<Picture(const Choices&)> make;  // throws std::invalid_argument where there is no such region

  // Of its files, without the ending: "figure-2", "dual-10".
  std::string file() const;
};
const std::vector<CatalogueEntry>& catalogue();

// The gallery as a page in Markdown, with the SVG of each entry and the command that makes it.
std::string gallery_page();

}  // namespace requad::figures
