// requad-enumerate search: every filling of a boundary, by exhaustive search.

#include "enumerate/commands/arguments.hpp"
#include "enumerate/commands/commands.hpp"
#include "theory/joined.hpp"

namespace requad::enumerate {

namespace {

using nlohmann::ordered_json;
using program::Options;
using program::UsageError;

std::vector<int> side_lengths(const Options& options) {
  std::vector<int> sides = required_ints(options, "sides");
  for (const int side : sides) {
    if (side < 1) throw UsageError("--sides: side " + std::to_string(side) + " is below 1");
  }
  return sides;
}

// A description of the search that tells the runs of a journal apart.
std::string run_text(const Options& options, const std::vector<int>& sides, const SearchProblem& problem,
                     const SearchLimits& limits) {
  std::string text = (sides.empty() ? "search, interior quads " + theory::joined(problem.interior_quads, ",")
                                    : "search, sides " + theory::joined(sides, ",")) +
                     "; irregular " + theory::joined(problem.irregular, ",");
  if (limits.faces) text += "; faces up to " + std::to_string(*limits.faces);
  if (options.has("list")) text += "; with signatures";
  return text;
}

ordered_json summary_of(const Options& options, const std::vector<int>& sides, const SearchProblem& problem,
                        const CountedSearch& found) {
  const bool complete = found.outcome.complete();
  ordered_json json{{"sides", sides}, {"irregular", problem.irregular}};
  if (!options.has("sides")) json["interior_quads"] = problem.interior_quads;
  // A search that was stopped has a lower bound instead of a count. The numbers up to a face limit are exact even so.
  json["count"] = complete ? ordered_json(found.outcome.count) : ordered_json(nullptr);
  if (!complete) json["at_least"] = found.outcome.count;
  json["complete"] = complete;
  json["by_faces"] = ordered_json::object();
  for (const auto& [faces, count] : found.outcome.by_faces) json["by_faces"][std::to_string(faces)] = count;
  json["orbits"] = complete
                       ? ordered_json{{"rotations", found.orbits.rotations}, {"reflections", found.orbits.reflections}}
                       : ordered_json(nullptr);
  json["states"] = found.outcome.states;
  if (options.has("list")) json["fillings"] = found.signatures;
  return json;
}

std::string text_of(const CountedSearch& found) {
  const bool complete = found.outcome.complete();
  std::string text = complete ? "count " + std::to_string(found.outcome.count) + "\n"
                              : "undecided: at least " + std::to_string(found.outcome.count) + "\n";
  for (const auto& [faces, count] : found.outcome.by_faces)
    text += std::to_string(faces) + " faces: " + std::to_string(count) + "\n";
  if (complete) {
    text += "up to rotations " + std::to_string(found.orbits.rotations) + ", and reflections " +
            std::to_string(found.orbits.reflections) + "\n";
  }
  return text + lines_of(found.signatures);
}

int run_search(const Options& options) {
  if (!options.has("sides") && !options.has("interior-quads"))
    throw UsageError("search: expected --sides or --interior-quads");
  SearchProblem problem{{}, irregular_valences(options)};
  std::vector<int> sides;
  if (options.has("sides")) {
    sides = side_lengths(options);
    problem = search_problem(sides, std::move(problem.irregular));
  } else {
    problem.interior_quads = required_ints(options, "interior-quads");
  }
  if (const std::string what = problem_with(problem); !what.empty()) throw UsageError("search: " + what);
  program::Progress progress("states", 0, options.quiet());
  const SearchLimits limits = search_limits(options, progress);
  const std::string why = impossibility(problem);
  if (!why.empty()) report_impossible(why);
  if (why.empty() && may_be_infinite(problem) && !limits.faces && !limits.seconds) {
    throw UsageError(
        "search: these valences can close a tube of any length, so there may be infinitely many fillings; expected "
        "--max-faces or --limit-seconds");
  }
  const CountedSearch found = count_fillings(problem, limits, options.has("list"),
                                             search_journal(options, run_text(options, sides, problem, limits)));
  progress.finish();
  ordered_json summary = summary_of(options, sides, problem, found);
  if (!why.empty()) summary["why"] = why;
  finish(options, summary, text_of(found));
  return found.outcome.complete() ? program::kDone : program::kUndecided;
}

}  // namespace

program::Command search_command() {
  std::vector<program::Option> options{
      program::value("sides", "S1,S2,...", "the lengths of the boundary's sides, counter-clockwise"),
      program::not_with(program::value("interior-quads", "Q1,Q2,...",
                                       "instead of --sides: the number of quads at each boundary vertex"),
                        {"sides"}),
      program::value("max-faces", "F", "leave out fillings of more than F faces"),
  };
  for (program::Option& option : search_options()) options.push_back(std::move(option));
  return {
      .name = "search",
      .usage = {"--sides S1,S2,... --irregular L1,L2,..."},
      .summary = "finds every filling of a boundary with given irregular valences, by exhaustive search",
      .text = R"(A filling is a quad mesh in which the vertices inside that are not regular have
exactly the valences of --irregular. With --irregular '' it is a regular grid.
)",
      .examples = {"requad-enumerate search --sides 6,6,6 --irregular 3,3,5",
                   "requad-enumerate search --sides 10,10,10 --irregular 3,3,5 --journal run.journal --limit-seconds "
                   "3600"},
      .options = std::move(options),
      .run = run_search,
  };
}

}  // namespace requad::enumerate
