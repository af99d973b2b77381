#include "figures/commands/explorer_command.hpp"

#include <algorithm>
#include <utility>

#include "figures/explorer/explorer.hpp"

namespace requad::figures {

using program::UsageError;

int explorer_command(const program::Options& options) {
  options.allow_only("--explorer", {"explorer", "sides", "pair", "output"});
  if (!options.has("pair")) throw UsageError("--pair is missing; expected 3-3, 5-5 or 3-5");
  if (!options.has("sides")) throw UsageError("--sides is missing; expected side lengths as in --sides 6,6");
  const auto type = theory::pair_type(options.text("pair"));
  if (!type) throw UsageError("--pair: '" + options.text("pair") + "' is not one of 3-3, 5-5, 3-5");
  const theory::IntegerVector sides = theory::to_vector(program::parse_integers(options.text("sides"), "--sides"));
  if (const std::string problem = theory::RegionShape::problem(*type, sides); !problem.empty())
    throw UsageError("--sides: " + problem);
  const theory::RegionShape shape(*type, sides);
  if (const std::string problem = explorer_problem(shape); !problem.empty()) throw UsageError("--sides: " + problem);
  const std::string path = options.text("output", "explorer.html");
  options.require_outputs({"json", "output"});
  program::require_writable(path);

  const enumerate::Exploration found = enumerate::explore_all(shape, theory::Apex::with);
  const nlohmann::ordered_json data = explorer_data(found);
  const std::string page = explorer_page(data);

  const auto& claims = data["claims"];
  const auto held = std::count_if(claims.begin(), claims.end(),
                                  [](const auto& claim) { return claim["holds"].template get<bool>(); });
  const nlohmann::ordered_json summary{{"file", path},
                                       {"bytes", page.size()},
                                       {"configurations", data["nodes"].size()},
                                       {"moves", data["moves"].size()},
                                       {"claims", claims}};
  const auto nodes = data["nodes"].size();
  const std::string text =
      path + ": " + std::to_string(nodes) + (nodes == 1 ? " configuration, " : " configurations, ") +
      std::to_string(data["moves"].size()) + " moves, " + std::to_string(held) + " of " +
      std::to_string(claims.size()) + " claims hold, " + std::to_string((page.size() + 1023) / 1024) + " kB\n";
  program::Outputs outputs;
  outputs.add(path, page);
  program::finish(options, summary.dump(), text, std::move(outputs));
  return static_cast<std::size_t>(held) == claims.size() ? program::kDone : program::kCheckFailed;
}

}  // namespace requad::figures
