// requad-figures: the paper's figures from computed meshes.

#include <algorithm>
#include <filesystem>
#include <utility>

#include <nlohmann/json.hpp>

#include "figures/commands/explorer_command.hpp"
#include "figures/graph_files.hpp"
#include "figures/pictures/catalogue.hpp"
#include "mesh/program/options.hpp"

namespace {

using namespace requad;
using program::UsageError;

constexpr const char* kHelp = R"(requad-figures: the paper's figures, and some more, from computed meshes

  requad-figures [--figure ID]... [--format svg|pdf|png|dot|graphml]... [-o DIR]
  requad-figures --explorer --sides S1,S2,... --pair 3-3|5-5|3-5 [-o FILE.html]

  --figure ID         which figure; may be repeated (default: all)
      2 3 4 5 6 7 8   operations before and after
      10              3-3 pairs in regular digons of side L and L-1, the mesh of each configuration at its node
      11              5-5 pairs in regular hexagons of side L and L-1, half cubes in projection
      12              a 3-5 pair in a region, a grid
      13 14           turns, smallest regions, separatrices, strips and sides
      dual-10 dual-11 the two grids over each other
      unfolded-11     the half cube laid flat
      hexagon         the grid of any hexagon
      octagon         the (L-1)^2 places of a single v8
  --side L            side length for 10, 11 and the duals (default 6), unfolded-11 (5) and the octagon (4), 3..40; the
                      time of a picture grows as L^4 and more
  --pair-region D1,D2,M,N   for figure 12: R_alpha is D1 x D2, the grid M x N (default 2,1,4,3)
  --sides E1,...,E6   for the hexagon (default 4,5,4,4,5,4)
  --format F          svg, pdf, png for all; dot and graphml for grids: 10 11 12 dual-10 dual-11 unfolded-11 hexagon.
                      May be repeated (default: svg, and dot for grids)
  --page              also write DIR/README.md, a page with all figures, their captions and commands
  -o DIR              folder for the files (default .)
  --explorer          one HTML file in which the configurations of a region and their moves can be walked through, with
                      no server and no network (default explorer.html); at most 150 configurations
  --json FILE|-       what was written
  --quiet  --help  --version

Examples:
  requad-figures -o pictures
  requad-figures --figure 11 --side 8 --format svg
  requad-figures --explorer --sides 6,6,6,6,6,6 --pair 5-5 -o explorer.html
  requad-figures --figure 10 --format dot && neato -n2 -Tpng figure-10.dot > figure-10.png
  requad-figures --figure hexagon --sides 3,4,5,4,3,5 --format pdf
)";

std::vector<std::string> choose(const program::Options& options, const char* name, std::vector<std::string> fallback,
                                const std::vector<std::string>& known) {
  if (!options.has(name)) return fallback;
  std::vector<std::string> chosen;
  for (const std::string& word : options.list(name)) {
    if (std::find(chosen.begin(), chosen.end(), word) == chosen.end()) chosen.push_back(word);
  }
  for (const std::string& word : chosen) {
    if (std::find(known.begin(), known.end(), word) != known.end()) continue;
    std::string expected;
    for (const std::string& k : known) expected += (expected.empty() ? "" : ", ") + k;
    throw UsageError(std::string("--") + name + ": '" + word + "' is not one of " + expected);
  }
  return chosen;
}

int main_body(int argc, char** argv) {
  const program::Options options(
      argc, argv, {{"page", "explorer"}, {"side", "sides", "pair", "pair-region", "output,o"}, {"figure", "format"}});
  if (program::answered(options, "requad-figures", REQUAD_VERSION, kHelp)) return program::kDone;
  if (!options.words().empty()) throw UsageError("unexpected argument '" + options.words().front() + "'; see --help");
  if (options.has("explorer")) return figures::explorer_command(options);
  if (options.has("pair")) throw UsageError("--pair is of use with --explorer only");
  std::vector<std::string> ids;
  for (const figures::CatalogueEntry& entry : figures::catalogue()) ids.emplace_back(entry.id);
  const auto chosen = choose(options, "figure", ids, ids);
  const auto formats = choose(options, "format", {"svg", "dot"}, {"svg", "pdf", "png", "dot", "graphml"});
  figures::Choices choices;
  if (options.has("side")) choices.side = static_cast<int>(options.integer("side", 0, 3, 40));
  const auto shape = program::parse_integers(options.text("pair-region", "2,1,4,3"), "--pair-region");
  if (shape.size() != 4) throw UsageError("--pair-region: expected D1,D2,M,N");
  for (std::size_t i = 0; i < 4; ++i) {
    if (shape[i] < 0 || shape[i] > 30)
      throw UsageError("--pair-region: " + std::to_string(shape[i]) + " is not in 0..30");
    choices.pair_region[i] = static_cast<int>(shape[i]);
  }
  if (options.has("sides")) {
    choices.sides = program::parse_integers(options.text("sides"), "--sides");
    for (const std::int64_t side : choices.sides) {
      if (side < 1 || side > 40) throw UsageError("--sides: " + std::to_string(side) + " is not in 1..40");
    }
  }
  const std::string folder = options.text("output", ".");
  program::require_folder(folder);
  // A list of what was written may go into the folder, which may be new.
  const std::filesystem::path list = std::filesystem::path(options.text("json")).lexically_normal();
  if (list.parent_path() != (std::filesystem::path(folder) / "").lexically_normal().parent_path())
    options.require_outputs();
  // All figures before the first file: nothing is written if one of them can not be made.
  struct Made {
    const figures::CatalogueEntry* entry;
    figures::Picture picture;
  };
  std::vector<Made> made;
  for (const figures::CatalogueEntry& entry : figures::catalogue()) {
    if (std::find(chosen.begin(), chosen.end(), entry.id) != chosen.end())
      made.push_back({&entry, entry.make(choices)});
  }
  const auto is_graph = [](const std::string& format) { return format == "dot" || format == "graphml"; };
  if (options.has("format") && options.has("figure")) {
    for (const Made& m : made) {
      if (!m.entry->is_grid && std::all_of(formats.begin(), formats.end(), is_graph)) {
        throw UsageError(std::string("--figure ") + m.entry->id + " is no graph: expected --format svg, pdf or png");
      }
    }
  }
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw UsageError(folder + ": " + error.message());
  program::Outputs outputs;
  std::string told;
  const auto write = [&](const std::string& name, std::string text, const std::string& title,
                         nlohmann::ordered_json about) {
    const std::string path = (std::filesystem::path(folder) / name).string();
    outputs.add(path, std::move(text));
    about["file"] = path;
    about["title"] = title;
    files.push_back(std::move(about));
    told += path + ": " + title + "\n";
  };
  for (const Made& m : made) {
    for (const std::string& format : formats) {
      if (is_graph(format) && !m.picture.grid) continue;
      nlohmann::ordered_json about{{"figure", m.entry->id}};
      if (m.picture.grid) {
        about["nodes"] = m.picture.grid->nodes.size();
        about["edges"] = m.picture.grid->edges.size();
      }
      write(m.entry->file() + "." + format,
            format == "dot"       ? figures::to_dot(*m.picture.grid)
            : format == "graphml" ? figures::to_graphml(*m.picture.grid)
                                  : pictures::render(m.picture.paint, format),
            m.picture.grid ? m.picture.grid->title : m.entry->title, std::move(about));
    }
  }
  if (options.has("page")) write("README.md", figures::gallery_page(), "Gallery", nlohmann::ordered_json::object());
  program::finish(options, nlohmann::ordered_json{{"files", files}}.dump(), told, std::move(outputs));
  return program::kDone;
}

}  // namespace

int main(int argc, char** argv) {
  return program::run("requad-figures", [argc, argv] { return main_body(argc, argv); });
}
