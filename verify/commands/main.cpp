// requad-verify: checks the claims of the paper by running every pair move on every configuration.

#include <algorithm>
#include <filesystem>
#include <iostream>

#include <unistd.h>

#include "mesh/files/write_obj.hpp"
#include "mesh/program/options.hpp"
#include "verify/campaign.hpp"
#include "verify/certificate.hpp"
#ifdef REQUAD_MPI
#include "verify/commands/distributed.hpp"
#endif
#include "verify/report.hpp"

namespace {

using namespace requad;
using program::Options;
using program::UsageError;

#ifdef REQUAD_MPI
#define REQUAD_MPI_HELP "  mpirun -n 4 requad-verify --hexagon 3..20 --journal run.journal --json report.json\n"
#else
#define REQUAD_MPI_HELP ""
#endif

constexpr const char* kHelp =
    R"(requad-verify: checks the claims of "Connectivity Editing for Quadrilateral Meshes" by computer

  requad-verify [--claim ID]... [ranges]
  requad-verify check DIR   checks certificates again, by a program that shares no code with what made them

  --claim ID               check this claim only; may be repeated (default: all; --list names them)
  --digon A..B             side lengths of regular digons with a 3-3 pair (default 3..24)
  --hexagon A..B           side lengths of regular hexagons with a 5-5 pair (default 3..12)
  --quad-perimeter A..B    perimeters of convex regions with a 3-5 pair, all sides (default 8..24)
  --other-perimeter A..B   perimeters of non-regular digons and hexagons, all sides (default 4..24)
  --method NAME            how configurations are found; may be repeated (default: all three)
                             moves   every pair move from one configuration on, until nothing is new
                             search  every filling of the boundary, without any theorem
                             walk    all configurations visited on one mesh and identified by their separatrices: alone,
                                     for digons up to side 2000 and hexagons up to 1000
  --journal FILE           keeps the result of each region; a run that was killed goes on where it stopped
  --failures DIR           where the mesh of a violation is written as OBJ (default .)
  --certificate DIR        writes every configuration, every edge with its script, and the counts, for `check`
  --html FILE|-            the report as one self-contained page
  --list                   the claims, with what each check compares
  --proofs                 the proofs for all sizes, step by step, of the claims that linear algebra decides
  --json FILE|-  --threads N  --quiet  --help  --version

Exit code: 0 all claims hold, 1 one fails, 2 bad arguments, 3 a claim had no instance in these ranges.

Examples:
  requad-verify
  requad-verify --claim T2 --digon 3..40
  requad-verify --claim T2 --digon 3..8 --certificate proof && requad-verify check proof
  requad-verify --claim T4 --claim N1 --quad-perimeter 10..30 --json report.json
  requad-verify --claim T2 --method walk --digon 1000
  requad-verify --hexagon 3..20 --journal run.journal --json report.json
)" REQUAD_MPI_HELP;

program::Range lengths(const Options& options, const char* name, program::Range fallback, std::int64_t least,
                       std::int64_t most) {
  if (!options.has(name)) return fallback;
  const std::string option = std::string("--") + name;
  const program::Range range = program::parse_range(options.text(name), option);
  if (range.first < least || range.last > most) {
    throw UsageError(option + ": " + options.text(name) + " is not within " + std::to_string(least) + ".." +
                     std::to_string(most));
  }
  return range;
}

// The claims asked for; all, but for those that have no use for the methods that were asked for.
std::vector<const verify::Claim*> select(const Options& options, const std::set<verify::Method>& methods) {
  std::vector<const verify::Claim*> selected;
  if (!options.has("claim")) {
    for (const verify::Claim& claim : verify::claims()) {
      if (std::any_of(claim.methods.begin(), claim.methods.end(),
                      [&](verify::Method m) { return methods.count(m) > 0; }))
        selected.push_back(&claim);
    }
    return selected;
  }
  for (const std::string& id : options.list("claim")) {
    const auto& all = verify::claims();
    const auto it = std::find_if(all.begin(), all.end(), [&](const verify::Claim& c) { return c.id == id; });
    if (it == all.end()) throw UsageError("--claim: '" + id + "' is not a claim; see --list");
    if (std::find(selected.begin(), selected.end(), &*it) == selected.end()) selected.push_back(&*it);
  }
  return selected;
}

// The proofs of these claims in full. Done if all of them go through, and undecided if none has one.
int print_proofs(const std::vector<const verify::Claim*>& claims) {
  int code = program::kUndecided;
  for (const verify::Claim* claim : claims) {
    const auto proof = theory::proof_of(claim->id);
    if (!proof) continue;
    std::cout << (code == program::kUndecided ? "" : "\n") << verify::proof_text(*proof);
    if (code == program::kUndecided || !proof->proved())
      code = proof->proved() ? program::kDone : program::kCheckFailed;
  }
  if (code == program::kUndecided) std::cout << "no proof for all sizes: instances only\n";
  return code;
}

// Each violating mesh goes to a file that its claim names.
void write_violations(const verify::CampaignResult& result, const std::string& folder) {
  for (const verify::ClaimResult& c : result.claims) {
    if (!c.violation || !c.violation->mesh) continue;
    const std::string path = folder + "/violation-" + c.claim->id + ".obj";
    try {
      program::write_text(path, mesh::obj_text(*c.violation->mesh, {c.claim->id + ": " + c.violation->what}));
      std::cerr << "requad-verify: the violating mesh of " << c.claim->id << " is in " << path << '\n';
    } catch (const UsageError& error) {
      std::cerr << "requad-verify: " << error.what() << '\n';  // the claim fails all the same
    }
  }
}

// Hands over to requad-verify-check, which lies beside this program and shares no code with it.
int check(const std::vector<std::string>& words, const char* self) {
  if (words.size() != 2) throw UsageError("check: expected one folder");
  std::error_code error;
  const std::filesystem::path running = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string checker =
      ((error ? std::filesystem::path(self) : running).parent_path() / "requad-verify-check").string();
  program::restore_signals();
  execl(checker.c_str(), checker.c_str(), words[1].c_str(), static_cast<char*>(nullptr));
  throw UsageError("check: " + checker + " can not be started");
}

std::set<verify::Method> methods_of(const Options& options) {
  using enum verify::Method;
  if (!options.has("method")) return {moves, search, walk};
  std::set<verify::Method> methods;
  for (const std::string& text : options.list("method")) {
    const auto all = {moves, search, walk};
    const auto it = std::find_if(all.begin(), all.end(), [&](verify::Method m) { return text == verify::name(m); });
    if (it == all.end()) throw UsageError("--method: '" + text + "' is not one of moves, search, walk");
    methods.insert(*it);
  }
  return methods;
}

#ifdef REQUAD_MPI
using Processes = verify::Processes;
#else
// This process alone.
struct Processes {
  Processes(int&, char**&) {}
  bool leads() const { return true; }
  bool alone() const { return true; }
  void hand_out(const std::vector<std::size_t>&, std::size_t, const verify::Done&) {}
  void work(const std::function<verify::CaseResult(std::size_t)>&) {}
};
#endif

int main_body(int argc, char** argv, Processes& processes) {
  const Options options(
      argc, argv,
      {{"list", "proofs"},
       {"digon", "hexagon", "quad-perimeter", "other-perimeter", "failures", "certificate", "journal"},
       {"claim", "method"},
       {"html"}});
  const auto leaves = [&] { return !processes.leads(); };  // what is printed is printed once
  if (leaves() && (options.has("help") || options.has("version") || options.has("list") || options.has("proofs") ||
                   !options.words().empty()))
    return program::kDone;
  if (program::answered(options, "requad-verify", REQUAD_VERSION, kHelp)) return program::kDone;
  if (!options.words().empty() && options.words().front() == "check") return check(options.words(), argv[0]);
  if (!options.words().empty()) throw UsageError("unexpected argument '" + options.words().front() + "'; see --help");
  if (options.has("list")) {
    for (const verify::Claim& c : verify::claims()) {
      std::cout << c.id << "  " << c.statement << " [" << c.where << "]\n     compares: " << c.compares << "\n";
    }
    return program::kDone;
  }
  const std::set<verify::Method> methods = methods_of(options);
  const std::vector<const verify::Claim*> selected = select(options, methods);
  if (options.has("proofs")) return print_proofs(selected);
  const std::string failures = options.text("failures", ".");
  std::error_code unknown;
  if (!std::filesystem::is_directory(failures, unknown))
    throw UsageError("--failures: " + failures + " is not a folder");
  verify::Ranges ranges;
  const bool walks_alone = methods == std::set<verify::Method>{verify::Method::walk};
  ranges.digon = lengths(options, "digon", ranges.digon, 3, walks_alone ? 2000 : 100);
  ranges.hexagon = lengths(options, "hexagon", ranges.hexagon, 3, walks_alone ? 1000 : 40);
  ranges.quad_perimeter = lengths(options, "quad-perimeter", ranges.quad_perimeter, 4, 100);
  ranges.other_perimeter = lengths(options, "other-perimeter", ranges.other_perimeter, 4, 40);

  if (options.has("certificate") && (ranges.digon.last > 100 || ranges.hexagon.last > 40))
    throw UsageError("--certificate: digons beyond side 100 and hexagons beyond 40 can be walked, but not certified");
  std::set<verify::Family> families;
  for (const verify::Claim* claim : selected) families.insert(claim->families.begin(), claim->families.end());
  const bool quiet = options.quiet();
  const verify::CaseList list = verify::list_cases(ranges, families);
  if (leaves()) {
    processes.work([&](std::size_t i) { return verify::run_case(list.cases[i], selected, methods); });
    return program::kDone;
  }
  options.require_outputs();
  if (options.has("certificate")) program::require_folder(options.text("certificate"));
  verify::Running running;
  running.threads = options.threads();
  running.quiet = quiet;
  std::optional<verify::Journal> journal;
  if (options.has("journal")) {
    const std::string name =
        verify::campaign_name(program::version_and_build(REQUAD_VERSION), selected, ranges, methods);
    journal.emplace(options.text("journal"), name, list.cases.size(), selected.size());
    running.journal = &*journal;
  }
  if (!processes.alone()) {
    running.distribute = [&](const std::vector<std::size_t>& todo, const verify::Done& done) {
      processes.hand_out(todo, selected.size(), done);
    };
  }
  const verify::CampaignResult result = verify::run_campaign(selected, list, methods, running);

  const std::string json_path = options.text("json");
  program::Outputs outputs;
  if (!json_path.empty()) outputs.add(json_path, verify::report_json(result, ranges).dump() + "\n");
  if (options.has("html")) outputs.add(options.text("html"), verify::report_html(result, ranges));
  outputs.commit();
  if (!quiet && json_path != "-" && !options.on_stdout("html")) std::cout << verify::report_text(result, ranges);
  write_violations(result, failures);
  if (options.has("certificate")) {
    const int written = verify::write_certificates(options.text("certificate"), list.cases, quiet);
    if (!quiet && json_path != "-") std::cout << written << " certificates in " << options.text("certificate") << '\n';
  }
  if (result.passed()) return program::kDone;
  const bool failed =
      std::any_of(result.claims.begin(), result.claims.end(), [](const auto& c) { return c.violation.has_value(); });
  return failed ? program::kCheckFailed : program::kUndecided;
}

}  // namespace

int main(int argc, char** argv) {
  Processes processes(argc, argv);
  // An argument that is wrong is wrong for all: one line, not one from each.
  if (!processes.leads()) std::cerr.rdbuf(nullptr);
  return program::run("requad-verify", [&] { return main_body(argc, argv, processes); });
}
