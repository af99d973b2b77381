// requad-figures --explorer: one HTML file in which a reader walks through the configurations of a region.

#include <algorithm>
#include <utility>

#include "figures/commands/commands.hpp"
#include "figures/explorer/explorer.hpp"
#include "mesh/program/layout.hpp"
#include "theory/counts.hpp"

namespace requad::figures {

namespace {

using nlohmann::ordered_json;
using program::UsageError;

int explorer(const program::Options& options) {
  const std::string pair = options.required("pair", "3-3, 5-5 or 3-5");
  const auto type = theory::pair_type(pair);
  if (!type || !theory::has_exact_count(*type)) throw UsageError("--pair: '" + pair + "' is not one of 3-3, 5-5, 3-5");
  const theory::IntegerVector sides = theory::to_vector(
      program::parse_integers(options.required("sides", "side lengths as in --sides 6,6"), "--sides"));
  if (const std::string problem = theory::RegionShape::problem(*type, sides); !problem.empty())
    throw UsageError("--sides: " + problem);
  const theory::RegionShape shape(*type, sides);
  if (const std::string problem = explorer_problem(shape); !problem.empty()) throw UsageError("--sides: " + problem);
  const std::string path = options.text("output", "explorer.html");
  program::require_writable(path);

  const enumerate::Exploration found = enumerate::explore_all(shape, theory::Apex::with);
  const ordered_json data = explorer_data(found);
  const std::string page = explorer_page(data);

  const auto& claims = data["claims"];
  const auto held = std::count_if(claims.begin(), claims.end(),
                                  [](const auto& claim) { return claim["holds"].template get<bool>(); });
  const auto merged = std::count_if(found.nodes.begin(), found.nodes.end(), [](const enumerate::FoundNode& node) {
    return node.reading.configuration.merged();
  });
  const std::int64_t pairs = std::ssize(found.nodes) - merged;
  const auto moves = data["moves"].size();
  const ordered_json summary{{"file", path},     {"bytes", page.size()}, {"configurations", pairs},
                             {"merged", merged}, {"moves", moves},       {"claims", claims}};
  const std::string text = path + ": " + program::counted(pairs, "configuration") +
                           (merged > 0 ? " and the merged one, " : ", ") + std::to_string(moves) + " moves, " +
                           std::to_string(held) + " of " + std::to_string(claims.size()) + " claims hold, " +
                           std::to_string((page.size() + 1023) / 1024) + " kB\n";
  program::Outputs outputs;
  outputs.add(path, page);
  program::finish(options, summary.dump(), text, std::move(outputs));
  return static_cast<std::size_t>(held) == claims.size() ? program::kDone : program::kCheckFailed;
}

}  // namespace

program::Command explorer_command() {
  return {
      .name = "--explorer",
      .usage = {"--sides S1,S2,... --pair 3-3|5-5|3-5"},
      .summary = "writes one HTML file in which the configurations of a region and their moves can be walked through",
      .text =
          "The file needs no server and no network. The region may have 150 configurations.\n"
          "explorer.html#2,1 opens it at the configuration (2,1).\n",
      .examples = {"requad-figures --explorer --sides 6,6,6,6,6,6 --pair 5-5 -o explorer.html"},
      .options =
          {
              program::value("sides", "S1,S2,...", "the lengths of the region's sides, counter-clockwise"),
              program::value("pair", "3-3|5-5|3-5", "the valences of the pair"),
              program::output("output,o", "FILE", "the HTML file to write, or - (default explorer.html)",
                              {{"html", {"html", "htm"}}}),
          },
      .run = explorer,
  };
}

}  // namespace requad::figures
