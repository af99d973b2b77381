// requad-figures: the paper's figures from computed meshes.

#include <algorithm>
#include <filesystem>
#include <iostream>

#include <boost/program_options.hpp>

#include "figures/graphviz.hpp"
#include "mesh/program.hpp"

namespace {

namespace po = boost::program_options;
using namespace requad;
using program::UsageError;

constexpr const char* kHelp = R"(requad-figures: the configuration grids of the paper, from meshes that pair moves made

  requad-figures [--figure N]... [--format dot|svg|pdf|png]... [-o DIR]

  --figure 10|11|12   which figure; may be repeated (default: all)
      10   3-3 pairs in regular digons of side L and L-1, a rotated grid; even sides red, odd sides blue;
           (0,x) is drawn dashed: it is the same configuration as (x,0)
      11   5-5 pairs in regular hexagons of side L and L-1, half cubes in projection
      12   a 3-5 pair in a region, a grid
  --side L            side length for figures 10 (default 8) and 11 (default 6)
  --pair-region D1,D2,M,N   for figure 12: R_alpha is D1 x D2, the grid M x N (default 2,1,4,3)
  --format F          dot, svg, pdf or png; may be repeated (default: dot and svg)
  -o DIR              folder for the files figure-N.F (default .)
  --quiet  --help  --version

Examples:
  requad-figures -o pictures
  requad-figures --figure 11 --side 8 --format svg
  requad-figures --figure 10 --format dot && neato -n2 -Tpng figure-10.dot > figure-10.png
)";

int main_body(int argc, char** argv) {
  po::options_description all;
  all.add_options()("help,h", "")("version", "")("quiet,q", "")("threads", po::value<std::string>())(
      "figure", po::value<std::vector<std::string>>())("format", po::value<std::vector<std::string>>())(
      "side", po::value<std::string>())("pair-region", po::value<std::string>()->default_value("2,1,4,3"))(
      "output,o", po::value<std::string>()->default_value("."))("words", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("words", -1);
  po::variables_map options;
  try {
    using Style = po::command_line_style::style_t;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional)
                  .style(Style::unix_style & ~Style::allow_guessing).run(), options);
  } catch (const po::error& error) {
    throw UsageError(std::string(error.what()) + "; see --help");
  }
  if (options.count("help") != 0) {
    std::cout << kHelp;
    return program::kDone;
  }
  if (options.count("version") != 0) {
    std::cout << "requad-figures " REQUAD_VERSION "\n";
    return program::kDone;
  }
  if (options.count("words") != 0) {
    throw UsageError("unexpected argument '" + options["words"].as<std::vector<std::string>>().front() + "'; see --help");
  }
  const auto list = [&options](const char* name, std::vector<std::string> fallback, const std::vector<std::string>& known) {
    if (options.count(name) == 0) return fallback;
    auto chosen = options[name].as<std::vector<std::string>>();
    for (const std::string& word : chosen) {
      if (std::find(known.begin(), known.end(), word) == known.end()) {
        std::string expected;
        for (const std::string& k : known) expected += (expected.empty() ? "" : ", ") + k;
        throw UsageError(std::string("--") + name + ": '" + word + "' is not one of " + expected);
      }
    }
    return chosen;
  };
  const auto numbers = list("figure", {"10", "11", "12"}, {"10", "11", "12"});
  const auto formats = list("format", {"dot", "svg"}, {"dot", "svg", "pdf", "png"});
  const auto side = [&options](int fallback) {
    if (options.count("side") == 0) return fallback;
    const std::int64_t length = program::parse_integer(options["side"].as<std::string>(), "--side");
    if (length < 3 || length > 200) throw UsageError("--side: " + std::to_string(length) + " is not in 3..200");
    return static_cast<int>(length);
  };
  const auto shape = program::parse_integers(options["pair-region"].as<std::string>(), "--pair-region");
  if (shape.size() != 4) throw UsageError("--pair-region: expected D1,D2,M,N");
  for (const std::int64_t x : shape) {
    if (x < 0 || x > 200) throw UsageError("--pair-region: " + std::to_string(x) + " is not in 0..200");
  }
  const std::string folder = options["output"].as<std::string>();
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
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw UsageError(folder + ": " + error.message());
  for (std::size_t i = 0; i < made.size(); ++i) {
    const figures::GridFigure& figure = made[i];
    const std::string& number = numbers[i];
    for (const std::string& format : formats) {
      const std::string path = (std::filesystem::path(folder) / ("figure-" + number + "." + format)).string();
      program::write_text(path, format == "dot" ? figures::to_dot(figure) : figures::render(figure, format));
      if (options.count("quiet") == 0) std::cout << path << ": " << figure.title << "\n";
    }
  }
  return program::kDone;
}

}  // namespace

int main(int argc, char** argv) {
  return program::run("requad-figures", [argc, argv] { return main_body(argc, argv); });
}
