// requad-figures without a command: writes pictures and grids into a folder.

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "figures/commands/commands.hpp"
#include "figures/graph_files.hpp"
#include "figures/pictures/catalogue.hpp"

namespace requad::figures {

namespace {

using nlohmann::ordered_json;
using program::Options;
using program::UsageError;

struct Figure {
  const CatalogueEntry* entry;
  Picture picture;
};

bool is_graph(const std::string& format) { return format == "dot" || format == "graphml"; }

Choices choices_of(const Options& options) {
  Choices choices;
  if (options.has("side")) choices.side = static_cast<int>(options.integer("side", 0, 3, 40));
  if (options.has("pair-region")) {
    const std::vector<std::int64_t> numbers = options.integers("pair-region", 0, 30);
    if (numbers.size() != 4) throw UsageError("--pair-region: expected D1,D2,M,N");
    for (std::size_t i = 0; i < 4; ++i) choices.pair_region[i] = static_cast<int>(numbers[i]);
  }
  if (options.has("sides")) choices.sides = options.integers("sides", 1, 40);
  return choices;
}

// Makes the figures of --figure, in the order of the catalogue. This is done before the first file is written: if one
// of them cannot be made, nothing is written.
std::vector<Figure> make_figures(const std::vector<std::string>& ids, const Choices& choices) {
  std::vector<Figure> figures;
  for (const CatalogueEntry& entry : catalogue()) {
    if (std::find(ids.begin(), ids.end(), entry.id) != ids.end()) figures.push_back({&entry, entry.make(choices)});
  }
  return figures;
}

// Throws UsageError if a requested figure has none of the requested formats.
void require_formats(const std::vector<Figure>& figures, const std::vector<std::string>& formats) {
  for (const Figure& figure : figures) {
    if (!figure.entry->is_grid && std::all_of(formats.begin(), formats.end(), is_graph)) {
      throw UsageError(std::string("--figure ") + figure.entry->id + " is no graph: expected --format svg, pdf or png");
    }
  }
}

std::string file_text(const Picture& picture, const std::string& format) {
  if (format == "dot") return to_dot(*picture.grid);
  if (format == "graphml") return to_graphml(*picture.grid);
  return pictures::render(picture.paint, format);
}

// Files in one folder, and what is reported about each.
class Folder {
 public:
  explicit Folder(std::filesystem::path path) : path_(std::move(path)) {}

  void add(const std::string& name, std::string text, const std::string& title, ordered_json about) {
    const std::string path = (path_ / name).string();
    outputs_.add(path, std::move(text));
    about["file"] = path;
    about["title"] = title;
    files_.push_back(std::move(about));
    text_ += path + ": " + title + "\n";
  }
  void finish(const Options& options) {
    program::finish(options, ordered_json{{"files", files_}}.dump(), text_, std::move(outputs_));
  }

 private:
  std::filesystem::path path_;
  program::Outputs outputs_;
  ordered_json files_ = ordered_json::array();
  std::string text_;
};

void add_figure(Folder& folder, const Figure& figure, const std::string& format) {
  const Picture& picture = figure.picture;
  if (is_graph(format) && !picture.grid) return;
  ordered_json about{{"figure", figure.entry->id}};
  if (picture.grid) {
    about["nodes"] = picture.grid->nodes.size();
    about["edges"] = picture.grid->edges.size();
  }
  folder.add(figure.entry->file() + "." + format, file_text(picture, format),
             picture.grid ? picture.grid->title : figure.entry->title, std::move(about));
}

int write_pictures(const Options& options) {
  namespace fs = std::filesystem;
  std::vector<std::string> all;
  for (const CatalogueEntry& entry : catalogue()) all.emplace_back(entry.id);
  const auto ids = options.choices("figure", all, all);
  const auto formats = options.choices("format", {"svg", "pdf", "png", "dot", "graphml"}, {"svg", "dot"});
  const Choices choices = choices_of(options);
  const std::string path = options.text("output", ".");
  program::require_folder(path);
  // --json may name a file in this folder, which need not exist yet.
  const fs::path list = fs::path(options.text("json")).lexically_normal();
  if (list.parent_path() != (fs::path(path) / "").lexically_normal().parent_path()) options.require_outputs();
  const std::vector<Figure> figures = make_figures(ids, choices);
  if (options.has("format") && options.has("figure")) require_formats(figures, formats);

  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw UsageError(path + ": " + error.message());
  Folder folder(path);
  for (const Figure& figure : figures) {
    for (const std::string& format : formats) add_figure(folder, figure, format);
  }
  if (options.has("page")) folder.add("README.md", gallery_page(), "Gallery", ordered_json::object());
  folder.finish(options);
  return program::kDone;
}

}  // namespace

program::Command pictures_command() {
  return {
      .name = "",
      .usage = {"[--figure ID]... [--format F]... [-o DIR]"},
      .summary = "writes figures into a folder",
      .text = R"(Figures:
  2 3 4 5 6 7 8   operations before and after
  10              3-3 pairs in regular digons of side L and L-1; each node shows
                  the mesh of its configuration
  11              5-5 pairs in regular hexagons of side L and L-1, as half cubes
  12              a 3-5 pair in a region, as a grid
  13 14           turns, smallest regions, separatrices, strips and sides
  dual-10 dual-11 the two grids over each other
  unfolded-11     the half cube laid flat
  hexagon         the grid of any hexagon
  octagon         the (L-1)^2 places of a single v8
10, 11, 12, dual-10, dual-11, unfolded-11 and hexagon are graphs.
)",
      .examples =
          {
              "requad-figures -o pictures",
              "requad-figures --figure 11 --side 8 --format svg",
              "requad-figures --figure 10 --format dot && neato -n2 -Tpng figure-10.dot > figure-10.png",
              "requad-figures --figure hexagon --sides 3,4,5,4,3,5 --format pdf",
          },
      .options =
          {
              program::list("figure", "ID", "which figure; may be repeated (default: all)"),
              program::list("format", "F",
                            "svg, pdf or png; for graphs also dot or graphml; may be repeated (default: svg, and dot "
                            "for graphs)"),
              program::value("output,o", "DIR", "the folder to write to (default .)"),
              program::value("side", "L",
                             "the side length, 3..40 (default 6; 5 for unfolded-11, 4 for octagon); the time of a "
                             "picture grows as L^4 or faster"),
              program::value("pair-region", "D1,D2,M,N",
                             "for figure 12: R_alpha is D1 x D2, the grid M x N (default 2,1,4,3)"),
              program::value("sides", "E1,...,E6", "for the hexagon (default 4,5,4,4,5,4)"),
              program::flag("page", "write DIR/README.md too, a page with all figures, their captions and commands"),
          },
      .outputs_are_known = false,
      .run = write_pictures,
  };
}

}  // namespace requad::figures
