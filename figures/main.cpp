// requad-figures: the paper's figures from computed meshes.

#include <algorithm>
#include <filesystem>
#include <iostream>

#include <nlohmann/json.hpp>

#include "figures/explorer_command.hpp"
#include "figures/graphviz.hpp"
#include "mesh/options.hpp"

namespace {

using namespace requad;
using program::UsageError;

constexpr const char* kHelp = R"(requad-figures: the configuration grids of the paper, from meshes that pair moves made

  requad-figures [--figure N]... [--format dot|svg|pdf|png]... [-o DIR]
  requad-figures --explorer --sides S1,S2,... --pair 3-3|5-5|3-5 [-o FILE.html]

  --figure 10|11|12   which figure; may be repeated (default: all)
      10   3-3 pairs in regular digons of side L and L-1, a rotated grid; even sides red, odd sides blue;
           (0,x) is drawn dashed: it is the same configuration as (x,0)
      11   5-5 pairs in regular hexagons of side L and L-1, half cubes in projection
      12   a 3-5 pair in a region, a grid
  --side L            side length for figures 10 (default 8) and 11 (default 6), 3..40
  --pair-region D1,D2,M,N   for figure 12: R_alpha is D1 x D2, the grid M x N (default 2,1,4,3)
  --format F          dot, svg, pdf or png; may be repeated (default: dot and svg)
  -o DIR              folder for the files figure-N.F (default .)
  --explorer          one HTML file in which the configurations of a region and their moves can be walked through, with
                      no server and no network (default explorer.html); at most 150 configurations
  --json FILE|-       what was written
  --quiet  --help  --version

Examples:
  requad-figures -o pictures
  requad-figures --figure 11 --side 8 --format svg
  requad-figures --explorer --sides 6,6,6,6,6,6 --pair 5-5 -o explorer.html
  requad-figures --figure 10 --format dot && neato -n2 -Tpng figure-10.dot > figure-10.png
)";

std::vector<std::string> choose(const program::Options& options, const char* name, std::vector<std::string> fallback,
                                const std::vector<std::string>& known) {
  if (!options.has(name)) return fallback;
  std::vector<std::string> chosen = options.list(name);
  for (const std::string& word : chosen) {
    if (std::find(known.begin(), known.end(), word) != known.end()) continue;
    std::string expected;
    for (const std::string& k : known) expected += (expected.empty() ? "" : ", ") + k;
    throw UsageError(std::string("--") + name + ": '" + word + "' is not one of " + expected);
  }
  return chosen;
}

int main_body(int argc, char** argv) {
  const program::Options options(argc, argv, {{"explorer"}, {"side", "pair-region", "output,o", "sides", "pair"}, {"figure", "format"}});
  if (program::answered(options, "requad-figures", REQUAD_VERSION, kHelp)) return program::kDone;
  if (!options.words().empty()) throw UsageError("unexpected argument '" + options.words().front() + "'; see --help");
  if (options.has("explorer")) return figures::explorer_command(options);
  for (const char* name : {"sides", "pair"}) {
    if (options.has(name)) throw UsageError(std::string("--") + name + " is of use with --explorer only");
  }
  const auto numbers = choose(options, "figure", {"10", "11", "12"}, {"10", "11", "12"});
  const auto formats = choose(options, "format", {"dot", "svg"}, {"dot", "svg", "pdf", "png"});
  const auto side = [&options](int fallback) { return static_cast<int>(options.integer("side", fallback, 3, 40)); };
  const auto shape = program::parse_integers(options.text("pair-region", "2,1,4,3"), "--pair-region");
  if (shape.size() != 4) throw UsageError("--pair-region: expected D1,D2,M,N");
  for (const std::int64_t x : shape) {
    if (x < 0 || x > 30) throw UsageError("--pair-region: " + std::to_string(x) + " is not in 0..30");
  }
  const std::string folder = options.text("output", ".");
  // All figures before the first file: nothing is written if one of them can not be made.
  std::vector<figures::GridFigure> made;
  for (const std::string& number : numbers) {
    figures::GridFigure figure;
    if (number == "10") figure = figures::figure_10(side(8));
    if (number == "11") figure = figures::figure_11(side(6));
    if (number == "12") {
      figure = figures::figure_12(static_cast<int>(shape[0]), static_cast<int>(shape[1]), static_cast<int>(shape[2]), static_cast<int>(shape[3]));
    }
    made.push_back(std::move(figure));
  }
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw UsageError(folder + ": " + error.message());
  for (std::size_t i = 0; i < made.size(); ++i) {
    const figures::GridFigure& figure = made[i];
    const std::string& number = numbers[i];
    for (const std::string& format : formats) {
      const std::string path = (std::filesystem::path(folder) / ("figure-" + number + "." + format)).string();
      program::write_text(path, format == "dot" ? figures::to_dot(figure) : figures::render(figure, format));
      files.push_back({{"figure", number}, {"file", path}, {"title", figure.title}, {"nodes", figure.nodes.size()}, {"edges", figure.edges.size()}});
      if (!options.quiet() && !options.on_stdout("json")) std::cout << path << ": " << figure.title << "\n";
    }
  }
  if (options.has("json")) program::write_text(options.text("json"), nlohmann::ordered_json{{"files", files}}.dump() + "\n");
  return program::kDone;
}

}  // namespace

int main(int argc, char** argv) {
  return program::run("requad-figures", [argc, argv] { return main_body(argc, argv); });
}
