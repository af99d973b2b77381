// The list of all figures. Each entry says what its figure shows, and makes it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "figures/grid_figure.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/pictures/canvas.hpp"

namespace requad::figures {

using namespace pictures;

// What a user may choose. What is not chosen has the gallery's value.
struct Choices {
  std::optional<int> side;                            // of regular regions
  std::optional<std::array<int, 4>> pair_region;      // d1, d2, M, N of figure 12
  std::optional<std::vector<theory::Integer>> sides;  // of the hexagon
  struct Mesh {
    std::string name;  // for files: "spot"
    std::shared_ptr<const mesh::Surface> surface;
  };
  std::optional<Mesh> mesh;          // that is reduced
  std::optional<std::string> curve;  // the JSON of bench/shape
};

struct Picture {
  Paint paint;
  std::optional<GridFigure> grid;  // for DOT and GraphML
};

struct CatalogueEntry {
  const char* id;     // "1", ..., "19", "dual-10", ...: what --figure takes
  const char* paper;  // the paper's figure, or ""
  const char* title;
  const char* caption;  // Markdown, one paragraph, which holds for all sizes
  bool is_grid;
  bool has_labels;     // whether it has labels (mesh/pictures/canvas.hpp)
  const char* choice;  // what of Choices it takes, as an option of requad-figures: "side", ..., or ""
  int usual_side;      // if it takes a side
  std::function<Picture(const Choices&, int side)> maker;

  // Throws std::invalid_argument if there is no such region.
  Picture make(const Choices& choices) const { return maker(choices, choices.side.value_or(usual_side)); }
  // The name of its files without the extension: "figure-2", "dual-10"; with the size unless that is the usual one:
  // "figure-10-side-8".
  std::string file(const Choices& choices = {}) const;
  // The file of one of its grids alone, if it has several.
  std::string file(const Grid& grid) const;
};
const std::vector<CatalogueEntry>& catalogue();

// The gallery as a page in Markdown: the SVG of each entry, its caption and the command that makes it. With screenshots, the
// page ends with explorer.png and editor.png.
std::string gallery_page(bool with_screenshots);

}  // namespace requad::figures
