#include "enumerate/commands/arguments.hpp"

#include <algorithm>
#include <iostream>
#include <utility>

#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/drawing.hpp"
#include "mesh/program/run/journal_file.hpp"
#include "theory/counts.hpp"

namespace requad::enumerate {

using program::Options;
using program::UsageError;
using theory::IntegerVector;
using theory::PairType;

std::vector<program::Option> pair_region_options() {
  return {
      program::value("sides", "S1,S2,...", "the lengths of the region's sides, counter-clockwise"),
      program::value("pair", "L1-L2", "the valences of the pair: 3-3, 5-5 or 3-5"),
  };
}

PairType required_pair(const Options& options) {
  const std::string text = options.required("pair", "two valences, as in --pair 3-5");
  const auto type = theory::pair_type(text);
  if (!type)
    throw UsageError("--pair: '" + text + "' is no pair; expected 3-3, 5-5, 3-5, or two others of 3, 5, 6, ...");
  return *type;
}

void require_moves(PairType type) {
  for (const PairType known : {theory::kDigon, theory::kHexagon, theory::kQuad}) {
    if (type == known) return;
  }
  throw UsageError(
      "--pair: the moves of section 6 are those of 3-3, 5-5 and 3-5 pairs; `requad-enumerate "
      "configurations` lists the configurations of a " +
      type.name() + " pair");
}

void report_impossible(const std::string& why) {
  std::cerr << "requad-enumerate: there is no filling: " << why << '\n';
}

bool reports_odd_boundary(const Options& options) {
  std::int64_t sum = 0;
  for (const std::int64_t side : program::parse_integers(options.text("sides"), "--sides")) {
    if (side < 1 || side > 1'000'000) return false;  // refused elsewhere
    sum += side;
  }
  if (sum % 2 == 0) return false;
  report_impossible("the sides have the odd sum " + std::to_string(sum) +
                    ", and the boundary of a quadrangulated disk is even");
  return true;
}

theory::RegionShape required_shape(const Options& options) {
  const PairType type = required_pair(options);
  const std::string text = options.required("sides", "side lengths as in --sides 9,9");
  IntegerVector sides = theory::to_vector(program::parse_integers(text, "--sides"));
  if (const std::string problem = theory::RegionShape::problem(type, sides); !problem.empty())
    throw UsageError("--sides: " + problem);
  theory::RegionShape shape(type, std::move(sides));
  // An exploration would keep the mesh of every configuration in memory.
  constexpr double kMostQuads = 2e8;
  const auto longest = static_cast<double>(shape.longest());
  const double area = longest * longest / 2;
  const double configurations = longest > 20'000 || !theory::has_exact_count(type)
                                    ? longest * longest / 4
                                    : static_cast<double>(theory::exact_count(shape));
  if (area * std::max(configurations, 1.0) > kMostQuads) {
    throw UsageError("--sides: about " + std::to_string(static_cast<std::int64_t>(configurations)) +
                     " configurations of some " + std::to_string(static_cast<std::int64_t>(area)) +
                     " quads are more than this command keeps in memory");
  }
  return shape;
}

program::Option mesh_output() {
  return program::output("output,o", "FILE", "the OBJ file to write, or -", {{"obj", {"obj"}}});
}

std::vector<program::Option> search_options() {
  return {
      program::value("irregular", "L1,L2,...", "the valences of the irregular vertices; '' for none"),
      program::flag("list", "print a signature of each mesh that is found"),
      program::value("limit-seconds", "S", "stop after S seconds; the exit code is then 3"),
      program::journal(
          "keep in FILE what is found and what is left to do; a run that was killed, or ran out of time, goes on when "
          "the same command is given again"),
  };
}

std::vector<int> irregular_valences(const Options& options) {
  const std::string text = options.required("irregular", "valences as in --irregular 3,3,5, or '' for none");
  return text.empty() ? std::vector<int>{} : required_ints(options, "irregular");
}

SearchLimits search_limits(const Options& options, program::Progress& progress) {
  SearchLimits limits;
  limits.progress = [&progress](std::int64_t states, double share, bool before) {
    before ? progress.was_done(states, share) : progress.advance(states, share);
  };
  limits.threads = options.threads();
  if (options.has("limit-seconds"))
    limits.seconds = static_cast<double>(options.integer("limit-seconds", 0, 1, 10'000'000));
  if (options.has("max-faces")) limits.faces = static_cast<int>(options.integer("max-faces", 0, 1, kMostFaces));
  return limits;
}

std::optional<SearchJournal> search_journal(const Options& options, const std::string& run) {
  if (!options.has("journal")) return std::nullopt;
  return SearchJournal{options.text("journal"),
                       "requad-enumerate " + program::version_and_build(REQUAD_VERSION) + " " + run};
}

std::vector<int> as_ints(const IntegerVector& values) { return {values.begin(), values.end()}; }

std::vector<int> required_ints(const Options& options, const std::string& name) {
  const std::vector<std::int64_t> values = options.integers(name, 0, 100'000);
  std::vector<int> ints;
  for (const std::int64_t value : values) ints.push_back(static_cast<int>(value));
  return ints;
}

std::string lines_of(const std::vector<std::string>& texts) {
  std::string lines;
  for (const std::string& text : texts) lines += text + "\n";
  return lines;
}

void finish(const Options& options, const nlohmann::ordered_json& summary, const std::string& text,
            const mesh::Region* region, const std::string& comment) {
  program::Outputs outputs;
  if (region != nullptr && options.has("output")) {
    const int faces = region->mesh.face_count();
    if (faces > mesh::kMostFacesDrawn) {
      throw UsageError("-o: " + std::to_string(faces) + " faces are more than the " +
                       std::to_string(mesh::kMostFacesDrawn) + " that can be drawn; without -o there is no limit");
    }
    if (faces > mesh::kMostFacesImproved && !options.quiet()) {
      std::cerr << "requad-enumerate: " << faces << " faces are more than the " << mesh::kMostFacesImproved
                << " whose shape is improved: the drawing is Tutte's\n";
    }
    outputs.add(options.text("output"), mesh::obj_text(*region, {comment}));
  }
  program::finish(options, summary.dump(), text, std::move(outputs));
}

}  // namespace requad::enumerate
