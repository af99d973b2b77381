// The list of all figures. Each entry says what its figure shows, and makes it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "figures/grid_figure.hpp"
#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

// What a user may choose. The defaults are those of the gallery.
struct Choices {
  std::optional<int> side;                               // of regular regions
  std::array<int, 4> pair_region{2, 1, 4, 3};            // d1, d2, M, N of figure 12
  std::vector<theory::Integer> sides{4, 5, 4, 4, 5, 4};  // of the hexagon
};

struct Picture {
  Paint paint;
  std::optional<GridFigure> grid;  // for DOT and GraphML
};

struct CatalogueEntry {
  const char* id;     // "2", ..., "14", "dual-10", ...: what --figure takes
  const char* paper;  // the paper's figure, or ""
  const char* title;
  const char* caption;  // Markdown, one paragraph
  bool is_grid;
  const char* choice;  // what of Choices it takes, as an option of requad-figures: "side", "pair-region", "sides" or ""
  std::function<Picture(const Choices&)> make;  // throws std::invalid_argument if there is no such region

  // The name of its files without the extension: "figure-2", "dual-10".
  std::string file() const;
};
const std::vector<CatalogueEntry>& catalogue();

// The gallery as a page in Markdown: the SVG of each entry, its caption and the command that makes it.
std::string gallery_page();

}  // namespace requad::figures
