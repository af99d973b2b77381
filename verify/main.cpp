// requad-verify: checks the claims of the paper by running every pair move on every configuration.

#include <algorithm>
#include <iostream>

#include <boost/program_options.hpp>

#include "mesh/obj.hpp"
#include "mesh/program.hpp"
#include "verify/campaign.hpp"
#include "verify/report.hpp"

namespace {

namespace po = boost::program_options;
using namespace requad;
using program::UsageError;

constexpr const char* kHelp = R"(requad-verify: checks the claims of "Connectivity Editing for Quadrilateral Meshes" by computer

  requad-verify [--claim ID]... [ranges]

  --claim ID               check this claim only; may be repeated (default: all; --list names them)
  --digon A..B             side lengths of regular digons with a 3-3 pair (default 3..24)
  --hexagon A..B           side lengths of regular hexagons with a 5-5 pair (default 3..12)
  --quad-perimeter A..B    perimeters of convex regions with a 3-5 pair, all sides (default 8..24)
  --other-perimeter A..B   perimeters of non-regular digons and hexagons, all sides (default 4..24)
  --method moves           every pair move from one configuration on, until nothing is new (default)
  --failures DIR           where the mesh of a violation is written as OBJ (default .)
  --list                   the claims, with what each check compares
  --json FILE|-  --threads N  --quiet  --help  --version

Exit code: 0 all claims hold, 1 one fails, 2 bad arguments, 3 a claim had no instance in these ranges.

Examples:
  requad-verify
  requad-verify --claim T2 --digon 3..40
  requad-verify --claim T4 --claim N1 --quad-perimeter 10..30 --json report.json
)";

program::Range lengths(const po::variables_map& options, const char* name, program::Range fallback, std::int64_t least) {
  if (options.count(name) == 0) return fallback;
  const std::string option = std::string("--") + name;
  const program::Range range = program::parse_range(options[name].as<std::string>(), option);
  if (range.first < least) throw UsageError(option + ": " + std::to_string(range.first) + " is below " + std::to_string(least));
  if (range.last > 1000) throw UsageError(option + ": " + std::to_string(range.last) + " is above 1000");
  return range;
}

std::vector<const verify::Claim*> select(const po::variables_map& options) {
  std::vector<const verify::Claim*> selected;
  if (options.count("claim") == 0) {
    for (const verify::Claim& claim : verify::claims()) selected.push_back(&claim);
    return selected;
  }
  for (const std::string& id : options["claim"].as<std::vector<std::string>>()) {
    const auto& all = verify::claims();
    const auto it = std::find_if(all.begin(), all.end(), [&](const verify::Claim& c) { return c.id == id; });
    if (it == all.end()) throw UsageError("--claim: '" + id + "' is not a claim; see --list");
    if (std::find(selected.begin(), selected.end(), &*it) == selected.end()) selected.push_back(&*it);
  }
  return selected;
}

// Each violating mesh goes to a file that its claim names.
void write_violations(const verify::CampaignResult& result, const std::string& folder) {
  for (const verify::ClaimResult& c : result.claims) {
    if (!c.violation || !c.violation->mesh) continue;
    const std::string path = folder + "/violation-" + c.claim->id + ".obj";
    mesh::save_region(path, *c.violation->mesh, {c.claim->id + ": " + c.violation->what});
    std::cerr << "requad-verify: the violating mesh of " << c.claim->id << " is in " << path << '\n';
  }
}

int main_body(int argc, char** argv) {
  po::options_description all;
  all.add_options()("help,h", "")("version", "")("quiet,q", "")("list", "")("json", po::value<std::string>())("threads", po::value<std::string>())(
      "claim", po::value<std::vector<std::string>>())("digon", po::value<std::string>())("hexagon", po::value<std::string>())(
      "quad-perimeter", po::value<std::string>())("other-perimeter", po::value<std::string>())(
      "method", po::value<std::vector<std::string>>())("failures", po::value<std::string>()->default_value("."))(
      "words", po::value<std::vector<std::string>>());
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
    std::cout << "requad-verify " REQUAD_VERSION "\n";
    return program::kDone;
  }
  if (options.count("list") != 0) {
    for (const verify::Claim& c : verify::claims()) {
      std::cout << c.id << "  " << c.statement << " [" << c.where << "]\n     compares: " << c.compares << "\n";
    }
    return program::kDone;
  }
  if (options.count("words") != 0) {
    throw UsageError("unexpected argument '" + options["words"].as<std::vector<std::string>>().front() + "'; see --help");
  }
  if (options.count("method") != 0) {
    for (const std::string& method : options["method"].as<std::vector<std::string>>()) {
      if (method != "moves") throw UsageError("--method: '" + method + "' is not a method; expected moves");
    }
  }
  int threads = 0;
  if (options.count("threads") != 0) {
    const std::int64_t wanted = program::parse_integer(options["threads"].as<std::string>(), "--threads");
    if (wanted < 1 || wanted > 1024) throw UsageError("--threads: " + std::to_string(wanted) + " is not in 1..1024");
    threads = static_cast<int>(wanted);
  }
  verify::Ranges ranges;
  ranges.digon = lengths(options, "digon", ranges.digon, 3);
  ranges.hexagon = lengths(options, "hexagon", ranges.hexagon, 3);
  ranges.quad_perimeter = lengths(options, "quad-perimeter", ranges.quad_perimeter, 4);
  ranges.other_perimeter = lengths(options, "other-perimeter", ranges.other_perimeter, 4);

  const std::vector<const verify::Claim*> selected = select(options);
  std::set<verify::Family> families;
  for (const verify::Claim* claim : selected) families.merge(verify::families_of(claim->id));
  const bool quiet = options.count("quiet") != 0;
  const verify::CampaignResult result = verify::run_campaign(selected, verify::list_cases(ranges, families), threads, quiet);

  const std::string json_path = options.count("json") != 0 ? options["json"].as<std::string>() : "";
  if (!json_path.empty()) program::write_text(json_path, verify::report_json(result, ranges).dump() + "\n");
  if (!quiet && json_path != "-") std::cout << verify::report_text(result, ranges);
  write_violations(result, options["failures"].as<std::string>());
  if (result.passed()) return program::kDone;
  const bool failed = std::any_of(result.claims.begin(), result.claims.end(), [](const auto& c) { return c.violation.has_value(); });
  return failed ? program::kCheckFailed : program::kUndecided;
}

}  // namespace

int main(int argc, char** argv) {
  return program::run("requad-verify", [argc, argv] { return main_body(argc, argv); });
}
