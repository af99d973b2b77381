// requad-verify without a command: checks claims on many regions, by every pair move on every configuration.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>

#include "mesh/files/write_obj.hpp"
#include "mesh/program/run/journal_file.hpp"
#include "mesh/program/suggestion.hpp"
#include "verify/campaign.hpp"
#include "verify/certificate.hpp"
#include "verify/commands/commands.hpp"
#include "verify/report/html.hpp"
#include "verify/report/report.hpp"

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

bool meets(const std::set<Method>& a, const std::set<Method>& b) {
  return std::any_of(a.begin(), a.end(), [&b](Method method) { return b.count(method) > 0; });
}

// The claims of --claim; without it all claims that can use one of the methods.
std::vector<const Claim*> selected_claims(const Options& options, const std::set<Method>& methods) {
  std::vector<const Claim*> selected = named_claims(options);
  if (!options.has("claim"))
    std::erase_if(selected, [&methods](const Claim* claim) { return !meets(claim->methods, methods); });
  return selected;
}

std::set<Family> families_of(const std::vector<const Claim*>& claims) {
  std::set<Family> families;
  for (const Claim* claim : claims) families.insert(claim->families.begin(), claim->families.end());
  return families;
}

// --- options that have no effect -------------------------------------------------------------------------------------

std::string names_of(const std::set<Method>& methods) {
  std::string names;
  for (const Method method : methods) names += (names.empty() ? "" : ", ") + std::string(name(method));
  return names;
}

// Every claim that is named can use one of the methods.
std::string unused_claim(const Options& options) {
  const std::set<Method> methods = methods_of(options);
  for (const Claim* claim : selected_claims(options, methods)) {
    if (!meets(claim->methods, methods))
      return "--claim " + claim->id + " has no effect: its check uses " + names_of(claim->methods);
  }
  return "";
}

// Every method that is named is used by one of the claims.
std::string unused_method(const Options& options) {
  const std::set<Method> methods = methods_of(options);
  std::set<Method> used;
  for (const Claim* claim : selected_claims(options, methods))
    used.insert(claim->methods.begin(), claim->methods.end());
  for (const Method method : methods) {
    if (used.count(method) == 0)
      return std::string("--method ") + name(method) + " has no effect: the checks of these claims use " +
             names_of(used);
  }
  return "";
}

// An option that is about regions of these families: one of the claims is about such regions.
program::Option about(program::Option option, std::set<Family> families) {
  const std::string name = "--" + option.long_name();
  return program::only_if(std::move(option), [name, families = std::move(families)](const Options& options) {
    for (const Family family : families_of(selected_claims(options, methods_of(options)))) {
      if (families.count(family) > 0) return std::string();
    }
    return name + " has no effect: these claims are not about such regions";
  });
}

// --- the run ---------------------------------------------------------------------------------------------------------

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

void write_reports(const Options& options, const CampaignResult& result, const Ranges& ranges,
                   const RunDescription& run) {
  program::Outputs outputs;
  if (options.has("json")) outputs.add(options.text("json"), report_json(result, ranges).dump() + "\n");
  if (options.has("html")) outputs.add(options.text("html"), report_html(result, ranges, run));
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

int campaign(const Options& options, const std::string& command_line, Processes& processes) {
  const auto start = std::chrono::steady_clock::now();
  const std::set<Method> methods = methods_of(options);
  const std::vector<const Claim*> selected = selected_claims(options, methods);
  const std::string failures = options.text("failures", ".");
  std::error_code unknown;
  if (!std::filesystem::is_directory(failures, unknown))
    throw UsageError("--failures: " + failures + " is not a folder");
  const Ranges ranges = ranges_of(options, methods);
  const std::set<Family> families = families_of(selected);
  const std::vector<RegionCase> cases = list_cases(ranges, families);
  if (!processes.leads()) {
    processes.work([&](std::size_t i) { return run_case(cases[i], selected, methods); });
    return program::kDone;
  }
  // Only the process that leads writes files.
  options.require_outputs();
  if (options.has("certificate")) program::require_folder(options.text("certificate"));
  const CampaignResult result = run_selected(options, selected, cases, ranges, methods, processes);
  write_reports(options, result, ranges, describe_run(program::version_and_build(REQUAD_VERSION), command_line, start));
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

std::vector<const Claim*> named_claims(const Options& options) {
  std::vector<const Claim*> named;
  if (!options.has("claim")) {
    for (const Claim& claim : claims()) named.push_back(&claim);
  }
  for (const std::string& id : options.list("claim")) {
    const Claim* const claim = find_claim(id);
    if (claim == nullptr) {
      std::vector<std::string> ids;
      for (const Claim& known : claims()) ids.push_back(known.id);
      throw UsageError("--claim: '" + id + "' is not a claim" + program::did_you_mean(id, ids) + "; see --list");
    }
    if (std::find(named.begin(), named.end(), claim) == named.end()) named.push_back(claim);
  }
  return named;
}

program::Command campaign_command(Processes& processes, std::string command_line) {
  return {
      .name = "",
      .usage = {"[--claim ID]... [OPTION]..."},
      .summary = "checks claims on many regions",
      .text = "",
      .examples =
          {
              "requad-verify",
              "requad-verify --claim T2 --digon 3..30",
              "requad-verify --claim T2 --certificate proof",
              "requad-verify --claim T4 --claim N1 --quad-perimeter 10..30 --json report.json",
              "requad-verify --claim T2 --method walk --digon 300",
              "requad-verify --hexagon 3..15 --journal run.journal --json report.json",
#ifdef REQUAD_MPI
              "mpirun -n 4 requad-verify --hexagon 3..15 --journal run.journal --json report.json",
#endif
          },
      .options =
          {
              program::only_if(
                  program::list("claim", "ID",
                                "check this claim only; may be repeated (default: all; --list names them)"),
                  unused_claim),
              about(program::value("digon", "A..B", "side lengths of regular digons with a 3-3 pair (default 3..24)"),
                    {Family::regular_digon}),
              about(
                  program::value("hexagon", "A..B", "side lengths of regular hexagons with a 5-5 pair (default 3..12)"),
                  {Family::regular_hexagon}),
              about(program::value("quad-perimeter", "A..B",
                                   "perimeters of convex regions with a 3-5 pair, all sides (default 8..24)"),
                    {Family::quad}),
              about(program::value("other-perimeter", "A..B",
                                   "perimeters of non-regular digons and hexagons, all sides, and of regions without a "
                                   "pair (default 4..24)"),
                    {Family::other_digon, Family::other_hexagon, Family::single_vertex, Family::three_vertices}),
              program::only_if(
                  program::list("method", "NAME",
                                "how configurations are found; may be repeated (default: all three)\n"
                                "  moves   every pair move from one configuration on, until nothing is new\n"
                                "  search  every filling of the boundary, without any theorem\n"
                                "  walk    all configurations are visited on one mesh and identified by their "
                                "separatrices; alone, for digons up to side 2000 and hexagons up to 1000"),
                  unused_method),
              program::journal("keep the result of each region in FILE; if a run was killed, the same command "
                               "continues where it stopped"),
              program::folder("failures", "DIR", "write the mesh of a violation as OBJ into DIR (default .)"),
              about(program::folder("certificate", "DIR",
                                    "write every configuration, every edge with its script, and the counts into DIR, "
                                    "for `requad-verify check`"),
                    certified_families()),
              program::output("html", "FILE|-", "write the report as one HTML page that needs no other file",
                              {{"html", {"html", "htm"}}}),
          },
      .outputs_are_known = false,
      .run = [&processes, command_line = std::move(command_line)](
                 const Options& options) { return campaign(options, command_line, processes); },
  };
}

}  // namespace requad::verify
