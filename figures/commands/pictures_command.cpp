// requad-figures without a command: writes pictures and grids into a folder.

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "figures/commands/commands.hpp"
#include "figures/graph_files.hpp"
#include "figures/pictures/catalogue.hpp"
#include "figures/pictures/paper_pictures.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/pictures/page_options.hpp"
#include "mesh/program/run/progress.hpp"
#include "mesh/text/text_scanner.hpp"

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

std::vector<std::string> chosen_ids(const Options& options) {
  std::vector<std::string> all;
  for (const CatalogueEntry& entry : catalogue()) all.emplace_back(entry.id);
  return options.choices("figure", all, all);
}

// An option that is one of Choices: one of the figures takes it.
program::Option for_figures(program::Option option) {
  const std::string name = option.long_name();
  return program::only_if(std::move(option), [name](const Options& options) {
    const std::vector<std::string> ids = chosen_ids(options);
    const auto takes_it = [&](const CatalogueEntry& entry) {
      return entry.choice == name && std::find(ids.begin(), ids.end(), entry.id) != ids.end();
    };
    const bool taken = std::any_of(catalogue().begin(), catalogue().end(), takes_it);
    return taken ? std::string() : "--" + name + " has no effect on these figures";
  });
}

// The text of a file that bench/shape has written. Throws UsageError.
std::string curve_text(const std::string& path) {
  std::string text = mesh::read_text(path);
  try {
    if (parse_curves(text).empty()) throw UsageError("--curve: " + path + " has no curves");
  } catch (const nlohmann::json::exception&) {
    throw UsageError("--curve: " + path + " has no curves; expected a file that `bench/shape --curve` has written");
  }
  return text;
}

Choices choices_of(const Options& options) {
  Choices choices;
  if (options.has("side")) choices.side = static_cast<int>(options.integer("side", 0, 3, 40));
  if (options.has("pair-region")) {
    const std::vector<std::int64_t> numbers = options.integers("pair-region", 0, 30);
    if (numbers.size() != 4) throw UsageError("--pair-region: expected D1,D2,M,N");
    choices.pair_region.emplace();
    for (std::size_t i = 0; i < 4; ++i) (*choices.pair_region)[i] = static_cast<int>(numbers[i]);
  }
  if (options.has("sides")) choices.sides = options.integers("sides", 1, 40);
  if (options.has("mesh")) {
    const std::string path = options.text("mesh");
    mesh::Surface surface = mesh::read_surface(path, false);
    if (surface.mesh.face_count() == 0) throw UsageError("--mesh: " + path + " has no face");
    choices.mesh = {path == "-" ? "mesh" : std::filesystem::path(path).stem().string(),
                    std::make_shared<mesh::Surface>(std::move(surface))};
  }
  if (options.has("curve")) choices.curve = curve_text(options.text("curve"));
  return choices;
}

// Makes the figures of --figure, in the order of the catalogue. This is done before the first file is written: if one
// of them cannot be made, nothing is written.
std::vector<Figure> make_figures(const std::vector<std::string>& ids, const Choices& choices, bool quiet) {
  std::vector<Figure> figures;
  program::Progress progress("figures", std::ssize(ids), quiet);
  for (const CatalogueEntry& entry : catalogue()) {
    if (std::find(ids.begin(), ids.end(), entry.id) == ids.end()) continue;
    figures.push_back({&entry, entry.make(choices)});
    progress.advance();
  }
  return figures;
}

// Throws UsageError if a requested figure has none of the requested formats.
void require_formats(const std::vector<Figure>& figures, const std::vector<std::string>& formats) {
  for (const Figure& figure : figures) {
    if (!figure.entry->is_grid && std::all_of(formats.begin(), formats.end(), is_graph)) {
      throw UsageError(std::string("--figure ") + figure.entry->id +
                       " is no graph: expected --format svg, pdf, png or tikz");
    }
  }
}

std::string title_of(const Figure& figure) {
  return figure.picture.grid ? figure.picture.grid->title : figure.entry->title;
}

std::string file_text(const Figure& figure, const std::string& format, pictures::Page page) {
  if (format == "dot") return to_dot(*figure.picture.grid);
  page.title = title_of(figure);
  page.description = figure.entry->caption;
  return pictures::render(figure.picture.paint, format, page);
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

ordered_json sizes_of(const Figure& figure, const GridFigure& grid) {
  return {{"figure", figure.entry->id}, {"nodes", grid.nodes.size()}, {"edges", grid.edges.size()}};
}

const std::vector<program::Format>& picture_formats() {
  static const std::vector<program::Format> all{{"svg", {"svg"}},       {"pdf", {"pdf"}},
                                                {"png", {"png"}},       {"tikz", {"tex", "tikz"}},
                                                {"dot", {"dot", "gv"}}, {"graphml", {"graphml", "xml"}}};
  return all;
}

std::string extension(const std::string& format) {
  const auto& all = picture_formats();
  return "." + std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.name == format; })->extensions[0];
}

// What is written of each figure, and how.
struct Request {
  Choices choices;
  pictures::Page page;
};

// GraphML has one graph a file: figure-10-side-6.graphml, figure-10-side-5.graphml.
void add_graphs(Folder& folder, const Figure& figure, const Choices& choices) {
  const GridFigure& all = *figure.picture.grid;
  for (std::size_t i = 0; i < all.grids.size(); ++i) {
    const GridFigure grid = grid_alone(all, i);
    const std::string name = all.grids.size() > 1 ? figure.entry->file(grid.grids[0]) : figure.entry->file(choices);
    folder.add(name + extension("graphml"), to_graphml(grid), all.title, sizes_of(figure, grid));
  }
}

void add_figure(Folder& folder, const Figure& figure, const std::string& format, const Request& request) {
  const Picture& picture = figure.picture;
  if (is_graph(format) && !picture.grid) return;
  if (format == "graphml") return add_graphs(folder, figure, request.choices);
  folder.add(figure.entry->file(request.choices) + extension(format), file_text(figure, format, request.page),
             title_of(figure),
             picture.grid ? sizes_of(figure, *picture.grid) : ordered_json{{"figure", figure.entry->id}});
}

// Whether -o names one file: "-", or a name with the end of a format. Otherwise it names a folder.
bool is_one_file(const Options& options) {
  const std::string name = options.text("output");
  const auto& formats = picture_formats();
  return name == "-" || std::any_of(formats.begin(), formats.end(), [&name](const program::Format& format) {
           return program::has_extension(format, program::extension_of(name));
         });
}

std::vector<std::string> chosen_formats(const Options& options) {
  if (is_one_file(options)) {
    const std::vector<std::string> asked = options.list("format");
    return {options.format("output", asked.empty() ? "" : asked.front()).name};
  }
  return options.choices("format", {"svg", "pdf", "png", "tikz", "dot", "graphml"}, {"svg", "dot"});
}

bool has_labels(const Options& options) {
  const std::vector<std::string> ids = chosen_ids(options);
  return std::any_of(catalogue().begin(), catalogue().end(), [&ids](const CatalogueEntry& entry) {
    return entry.has_labels && std::find(ids.begin(), ids.end(), entry.id) != ids.end();
  });
}

// Writes one figure, or for GraphML one graph, to the file of -o.
int write_one_picture(const Options& options) {
  const std::vector<std::string> ids = chosen_ids(options), asked = options.list("format");
  if (ids.size() != 1 || asked.size() > 1)
    throw UsageError("-o " + options.text("output") + " is one file; expected one --figure and one format");
  const std::string format = chosen_formats(options).front();
  const pictures::Page page = page_of(options);
  options.require_outputs();
  program::require_writable(options.text("output"));
  Figure figure = make_figures(ids, choices_of(options), options.quiet()).front();
  require_formats({figure}, {format});
  if (format == "graphml" && figure.picture.grid->grids.size() > 1)
    throw UsageError("-o " + options.text("output") + ": this figure has " +
                     std::to_string(figure.picture.grid->grids.size()) +
                     " graphs, and each has a file of its own; expected a folder");
  program::Outputs outputs;
  outputs.add(options.text("output"),
              format == "graphml" ? to_graphml(*figure.picture.grid) : file_text(figure, format, page));
  const ordered_json about{{"figure", ids.front()}, {"file", options.text("output")}, {"title", figure.entry->title}};
  program::finish(options, ordered_json{{"files", {about}}}.dump(),
                  options.text("output") + ": " + figure.entry->title + "\n", std::move(outputs));
  return program::kDone;
}

int write_pictures(const Options& options) {
  if (is_one_file(options)) return write_one_picture(options);
  namespace fs = std::filesystem;
  const std::vector<std::string> ids = chosen_ids(options);
  const std::vector<std::string> formats = chosen_formats(options);
  const Request request{choices_of(options), page_of(options)};
  const std::string path = options.text("output", ".");
  program::require_folder(path);
  // --json may name a file in this folder, which need not exist yet.
  const fs::path list = fs::path(options.text("json")).lexically_normal();
  if (list.parent_path() != (fs::path(path) / "").lexically_normal().parent_path()) options.require_outputs();
  const std::vector<Figure> figures = make_figures(ids, request.choices, options.quiet());
  if (options.has("format") && options.has("figure")) require_formats(figures, formats);

  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw UsageError(path + ": " + error.message());
  Folder folder(path);
  program::Progress progress("files", std::ssize(figures) * std::ssize(formats), options.quiet());
  for (const Figure& figure : figures) {
    for (const std::string& format : formats) {
      add_figure(folder, figure, format, request);
      progress.advance();
    }
  }
  progress.finish();
  if (options.has("page")) {
    const bool shots = fs::exists(fs::path(path) / "explorer.png") && fs::exists(fs::path(path) / "editor.png");
    folder.add("README.md", gallery_page(shots), "Gallery", ordered_json::object());
  }
  folder.finish(options);
  return program::kDone;
}

program::Option folder_or_file() {
  program::Option option = program::folder("output,o", "DIR|FILE",
                                           "the folder to write to (default .), or the file for a single figure, "
                                           "whose format its end says; - for standard output");
  option.formats = picture_formats();
  return option;
}

}  // namespace

program::Command pictures_command() {
  std::vector<program::Option> options{
      program::list("figure", "ID", "which figure; may be repeated (default: all)"),
      program::list(
          "format", "F",
          "svg, pdf, png or tikz (.tex, for LaTeX); for graphs also dot or graphml; may be repeated (default: "
          "svg, and dot for graphs)"),
      folder_or_file(),
      for_figures(program::value("side", "L",
                                 "the side length, 3..40 (default 6; 5 for unfolded-11, 4 for octagon); the time of a "
                                 "picture grows as L^4 or faster")),
      for_figures(program::value("pair-region", "D1,D2,M,N",
                                 "for figure 12: R_alpha is D1 x D2, the grid M x N (default 2,1,4,3)")),
      for_figures(program::value("sides", "E1,...,E6", "for the hexagon (default 4,5,4,4,5,4)")),
      for_figures(program::input("curve", "FILE", "for deviation: other curves, as `bench/shape --curve` writes them")),
      for_figures(program::input("mesh", "IN",
                                 "for figure 19: the mesh to reduce, an OBJ or OFF file of quads; takes as "
                                 "long as `requad-edit reduce`")),
  };
  for (program::Option& option : page_options(chosen_formats, has_labels)) options.push_back(std::move(option));
  options.push_back(program::only_if(
      program::flag("page",
                    "write DIR/README.md too, a page with all figures, their captions and commands, and with\n"
                    "explorer.png and editor.png if DIR has them"),
      [](const Options& given) {
        return is_one_file(given) ? std::string("--page has no effect where -o names one file") : "";
      }));
  return {
      .name = "",
      .usage = {"[--figure ID]... [--format F]... [-o DIR]"},
      .summary = "writes figures into a folder",
      .text = R"(Figures:
  1 15 19         meshes in space whose irregular vertices cancel
  2 3 4 5 6 7 8   operations before and after
  9               the moves of pairs as arrows on meshes in space
  10              3-3 pairs in regular digons of side L and L-1; each node shows
                  the mesh of its configuration
  11              5-5 pairs in regular hexagons of side L and L-1, as half cubes
  12              a 3-5 pair in a region, as a grid
  13 14           turns, smallest regions, separatrices, strips and sides
  16 17 18        defects of meshes in space, repaired step by step
  dual-10 dual-11 the two grids over each other
  unfolded-11     the half cube laid flat
  hexagon         the grid of any hexagon
  deviation       irregular vertices against deviation, as bench/shape measured
  octagon         the (L-1)^2 places of a single v8
10, 11, 12, dual-10, dual-11, unfolded-11 and hexagon are graphs.
)",
      .examples =
          {
              "requad-figures -o pictures",
              "requad-figures --figure 11 --side 8 -o figure.pdf",
              "requad-figures --figure 12 --width 85mm --palette print -o figure.pdf",
              "requad-figures --figure 14 --width 504pt --format tikz",
              "requad-figures --figure 10 --format dot && neato -n2 -Tpng figure-10.dot > figure-10.png",
              "requad-figures --figure 19 --mesh mesh/examples/figure-1.obj -o stages.pdf",
              "requad-figures --figure hexagon --sides 3,4,5,4,3,5 --format pdf",
          },
      .options = std::move(options),
      .outputs_are_known = false,
      .run = write_pictures,
  };
}

}  // namespace requad::figures
