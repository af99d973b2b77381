// requad-verify without a command: checks claims on many regions, by every pair move on every configuration.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>

#include "mesh/files/write_obj.hpp"
#include "mesh/program/journal_file.hpp"
#include "verify/campaign.hpp"
#include "verify/certificate.hpp"
#include "verify/commands/commands.hpp"
#include "verify/report.hpp"
#include "verify/sentences.hpp"

namespace requad::verify {

namespace {

using program::Options;
using program::UsageError;

std::set<Method> methods_of(const Options& options) {
  const std::vector<std::string> all{"moves", "search", "walk"};
  const std::vector<std::string> chosen = options.choices("method", all, all);
  std::set<Method> methods;
  for (const Method method : {Method::moves, Method::search, Method::walk}) {
    if (std::find(chosen.begin(), chosen.end(), name(method)) != chosen.end()) methods.insert(method);
  }
  return methods;
}

// The claims of --claim; without it all claims that can use one of the methods.
std::vector<const Claim*> select(const Options& options, const std::set<Method>& methods) {
  std::vector<const Claim*> selected;
  if (!options.has("claim")) {
    for (const Claim& claim : claims()) {
      if (std::any_of(claim.methods.begin(), claim.methods.end(), [&](Method m) { return methods.count(m) > 0; }))
        selected.push_back(&claim);
    }
    return selected;
  }
  for (const std::string& id : options.list("claim")) {
    const Claim* const claim = find_claim(id);
    if (claim == nullptr) throw UsageError("--claim: '" + id + "' is not a claim; see --list");
    if (std::find(selected.begin(), selected.end(), claim) == selected.end()) selected.push_back(claim);
  }
  return selected;
}

// Prints the proofs of these claims step by step. Exit code: kDone if all go through, kUndecided if there is none.
int print_proofs(const std::vector<const Claim*>& claims) {
  int code = program::kUndecided;
  for (const Claim* claim : claims) {
    const auto proof = theory::proof_of(claim->id);
    if (!proof) continue;
    std::cout << (code == program::kUndecided ? "" : "\n") << proof_text(*proof);
    if (code == program::kUndecided || !proof->proved())
      code = proof->proved() ? program::kDone : program::kCheckFailed;
  }
  if (code == program::kUndecided) std::cout << "no proof for all sizes: instances only\n";
  return code;
}

// Writes each violating mesh to a file that is named after its claim.
void write_violations(const CampaignResult& result, const std::string& folder) {
  for (const ClaimResult& c : result.claims) {
    if (!c.violation || !c.violation->mesh) continue;
    const std::string path = folder + "/violation-" + c.claim->id + ".obj";
    try {
      program::write_text(path, mesh::obj_text(*c.violation->mesh, {c.claim->id + ": " + c.violation->what}));
      std::cerr << "requad-verify: the violating mesh of " << c.claim->id << " is in " << path << '\n';
    } catch (const UsageError& error) {
      std::cerr << "requad-verify: " << error.what() << '\n';  // the exit code is that of the claim
    }
  }
}

void print_claims() {
  for (const Claim& c : claims()) {
    std::cout << c.id << "  " << c.statement << " [" << c.where << "]\n     compares: " << c.compares
              << "\n     fails if: " << c.fails_if << "\n";
  }
}

// The ranges of side lengths and perimeters. If only walks are asked for, they may be larger: moves keep every mesh.
Ranges ranges_of(const Options& options, const std::set<Method>& methods) {
  const bool walks_alone = methods == std::set<Method>{Method::walk};
  Ranges ranges;
  ranges.digon = options.range("digon", ranges.digon, 3, walks_alone ? 2000 : 100);
  ranges.hexagon = options.range("hexagon", ranges.hexagon, 3, walks_alone ? 1000 : 40);
  ranges.quad_perimeter = options.range("quad-perimeter", ranges.quad_perimeter, 4, 100);
  ranges.other_perimeter = options.range("other-perimeter", ranges.other_perimeter, 4, 40);
  if (options.has("certificate") && (ranges.digon.last > 100 || ranges.hexagon.last > 40))
    throw UsageError("--certificate: digons beyond side 100 and hexagons beyond 40 can be walked, but not certified");
  return ranges;
}

CampaignResult run_selected(const Options& options, const std::vector<const Claim*>& selected,
                            const std::vector<RegionCase>& cases, const Ranges& ranges, const std::set<Method>& methods,
                            Processes& processes) {
  Running running;
  running.threads = options.threads();
  running.quiet = options.quiet();
  std::optional<Journal> journal;
  if (options.has("journal")) {
    const std::string run = campaign_name(program::version_and_build(REQUAD_VERSION), selected, ranges, methods);
    journal.emplace(options.text("journal"), run, cases.size(), selected.size());
    running.journal = &*journal;
  }
  if (!processes.alone()) {
    running.distribute = [&](const std::vector<std::size_t>& todo, const Done& done) {
      processes.hand_out(todo, selected.size(), done);
    };
  }
  return run_campaign(selected, cases, methods, running);
}

void write_reports(const Options& options, const CampaignResult& result, const Ranges& ranges) {
  program::Outputs outputs;
  if (options.has("json")) outputs.add(options.text("json"), report_json(result, ranges).dump() + "\n");
  if (options.has("html")) outputs.add(options.text("html"), report_html(result, ranges));
  outputs.commit();
  if (!options.quiet() && !options.on_stdout("json") && !options.on_stdout("html"))
    std::cout << report_text(result, ranges);
}

int exit_code(const CampaignResult& result) {
  if (result.passed()) return program::kDone;
  const bool failed =
      std::any_of(result.claims.begin(), result.claims.end(), [](const auto& c) { return c.violation.has_value(); });
  return failed ? program::kCheckFailed : program::kUndecided;
}

int campaign(const Options& options, Processes& processes) {
  const bool prints_only = options.has("list") || options.has("proofs") || options.has("sentences");
  if (!processes.leads() && prints_only) return program::kDone;
  if (options.has("list")) {
    options.allow_only("--list", {"list"});
    print_claims();
    return program::kDone;
  }
  if (options.has("sentences")) {
    options.allow_only("--sentences", {"sentences"});
    std::cout << sentences_text();
    return program::kDone;
  }
  if (options.has("proofs")) options.allow_only("--proofs", {"proofs", "claim"});
  const std::set<Method> methods = methods_of(options);
  const std::vector<const Claim*> selected = select(options, methods);
  if (options.has("proofs")) return print_proofs(selected);
  const std::string failures = options.text("failures", ".");
  std::error_code unknown;
  if (!std::filesystem::is_directory(failures, unknown))
    throw UsageError("--failures: " + failures + " is not a folder");
  const Ranges ranges = ranges_of(options, methods);
  std::set<Family> families;
  for (const Claim* claim : selected) families.insert(claim->families.begin(), claim->families.end());
  const std::vector<RegionCase> cases = list_cases(ranges, families);
  if (!processes.leads()) {
    processes.work([&](std::size_t i) { return run_case(cases[i], selected, methods); });
    return program::kDone;
  }
  // Only the process that leads writes files.
  options.require_outputs();
  if (options.has("certificate")) program::require_folder(options.text("certificate"));
  const CampaignResult result = run_selected(options, selected, cases, ranges, methods, processes);
  write_reports(options, result, ranges);
  write_violations(result, failures);
  if (options.has("certificate")) {
    const int written = write_certificates(options.text("certificate"), ranges, families, options.quiet());
    const auto without = std::count_if(
        cases.begin(), cases.end(), [](const RegionCase& region) { return !std::holds_alternative<PairCase>(region); });
    if (without > 0) {
      std::cerr << "requad-verify: certificates are about pairs; " << without
                << " regions with one or three irregular vertices have none\n";
    }
    if (!options.quiet() && !options.on_stdout("json"))
      std::cout << written << " certificates in " << options.text("certificate") << '\n';
  }
  return exit_code(result);
}

}  // namespace

program::Command campaign_command(Processes& processes) {
  return {
      .name = "",
      .usage = {"[--claim ID]... [OPTION]..."},
      .summary = "checks claims on many regions",
      .text = "",
      .examples =
          {
              "requad-verify",
              "requad-verify --claim T2 --digon 3..30",
              "requad-verify --claim T2 --certificate proof && requad-verify check proof",
              "requad-verify --claim T4 --claim N1 --quad-perimeter 10..30 --json report.json",
              "requad-verify --claim T2 --method walk --digon 300",
              "requad-verify --hexagon 3..15 --journal run.journal --json report.json",
#ifdef REQUAD_MPI
              "mpirun -n 4 requad-verify --hexagon 3..15 --journal run.journal --json report.json",
#endif
          },
      .options =
          {
              program::list("claim", "ID", "check this claim only; may be repeated (default: all; --list names them)"),
              program::value("digon", "A..B", "side lengths of regular digons with a 3-3 pair (default 3..24)"),
              program::value("hexagon", "A..B", "side lengths of regular hexagons with a 5-5 pair (default 3..12)"),
              program::value("quad-perimeter", "A..B",
                             "perimeters of convex regions with a 3-5 pair, all sides (default 8..24)"),
              program::value("other-perimeter", "A..B",
                             "perimeters of non-regular digons and hexagons, all sides (default 4..24)"),
              program::list("method", "NAME",
                            "how configurations are found; may be repeated (default: all three)\n"
                            "  moves   every pair move from one configuration on, until nothing is new\n"
                            "  search  every filling of the boundary, without any theorem\n"
                            "  walk    all configurations are visited on one mesh and identified by their "
                            "separatrices; alone, for digons up to side 2000 and hexagons up to 1000"),
              program::value("journal", "FILE",
                             "keep the result of each region in FILE; if a run was killed, the same command "
                             "continues where it stopped"),
              program::value("failures", "DIR", "write the mesh of a violation as OBJ into DIR (default .)"),
              program::value("certificate", "DIR",
                             "write every configuration, every edge with its script, and the counts into DIR, for "
                             "`requad-verify check`"),
              program::output("html", "FILE|-", "write the report as one HTML page that needs no other file"),
              program::flag(
                  "list", "print the claims, with what each check compares and what makes it fail, and check nothing"),
              program::flag("sentences",
                            "print the sentences of the paper that no check can decide, with the reasons, and check "
                            "nothing"),
              program::flag("proofs",
                            "print the proofs for all sizes, step by step, of the claims that linear algebra decides, "
                            "and check no region"),
          },
      .outputs_are_known = false,
      .run = [&processes](const Options& options) { return campaign(options, processes); },
  };
}

}  // namespace requad::verify
