// requad-enumerate sphere: all closed quad spheres with given irregular valences.

#include <map>

#include "enumerate/commands/arguments.hpp"
#include "enumerate/commands/commands.hpp"
#include "enumerate/search/spheres.hpp"
#include "theory/joined.hpp"

namespace requad::enumerate {

namespace {

using nlohmann::ordered_json;
using program::Options;
using program::UsageError;

int sphere(const Options& options) {
  options.required("vertices", "a range as in --vertices 8..20");
  const program::Range range = options.range("vertices", {}, 4, kMostFaces);
  const std::vector<int> irregular = irregular_valences(options);
  program::Progress progress("states", 0, options.quiet());
  const std::string run =
      "sphere, irregular " + theory::joined(irregular, ",") + "; vertices up to " + std::to_string(range.last);
  const SphereOutcome found = search_spheres(irregular, static_cast<int>(range.last), search_limits(options, progress),
                                             search_journal(options, run));
  progress.finish();
  const auto in_range = [&](const std::map<int, std::int64_t>& counts) {
    ordered_json json = ordered_json::object();
    for (auto v = range.first; v <= range.last; ++v) {
      const auto it = counts.find(static_cast<int>(v));
      json[std::to_string(v)] = it == counts.end() ? 0 : it->second;
    }
    return json;
  };
  const ordered_json counts = in_range(found.counts), oriented = in_range(found.oriented_counts);
  ordered_json json{{"irregular", irregular},
                    {"counts", counts},
                    {"oriented_counts", oriented},
                    {"complete", found.complete},
                    {"states", found.states}};
  if (!found.complete) json["counts"] = nullptr, json["oriented_counts"] = nullptr, json["at_least"] = counts;
  if (options.has("list")) json["spheres"] = found.signatures;
  std::string text = found.complete ? "" : "undecided: at least\n";
  for (const auto& [v, count] : counts.items()) {
    text += v + " vertices: " + count.dump() + " (" + oriented[v].dump() + " if mirror images differ)\n";
  }
  finish(options, json, options.has("list") ? text + lines_of(found.signatures) : text);
  return found.complete ? program::kDone : program::kUndecided;
}

}  // namespace

program::Command sphere_command() {
  std::vector<program::Option> options{
      program::value("vertices", "A..B", "the numbers of vertices"),
  };
  for (program::Option& option : search_options()) options.push_back(std::move(option));
  return {
      .name = "sphere",
      .usage = {"--irregular L1,L2,... --vertices A..B"},
      .summary = "finds all closed quad spheres with these irregular valences, up to isomorphism",
      .examples = {"requad-enumerate sphere --irregular 3,3,3,3,3,3,3,3 --vertices 8..20"},
      .options = std::move(options),
      .run = sphere,
  };
}

}  // namespace requad::enumerate
