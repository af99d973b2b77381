#include "verify/campaign.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "mesh/program/run/errors.hpp"
#include "mesh/program/run/progress.hpp"
#include "mesh/threads/threads.hpp"
#include "theory/counts.hpp"

namespace requad::verify {

bool CampaignResult::passed() const {
  return std::all_of(claims.begin(), claims.end(),
                     [](const ClaimResult& c) { return !c.violation && c.instances > 0; });
}

void attach_proof(ClaimResult& result, std::optional<theory::Proof> proof) {
  if (proof && !proof->proved() && !result.violation) {
    const std::string step = proof->failure();
    result.violation =
        Violation{"the proof for " + proof->range + " fails: " + (step.empty() ? "it computes nothing" : step), "", "",
                  std::nullopt};
  }
  result.proof = std::move(proof);
}

std::string campaign_name(const std::string& version, const std::vector<const Claim*>& selected, const Ranges& ranges,
                          const std::set<Method>& methods) {
  std::string name = "requad-verify " + version + " claims";
  std::set<Family> families;
  for (const Claim* claim : selected) {
    name += " " + claim->id;
    families.insert(claim->families.begin(), claim->families.end());
  }
  const auto span = [&name](const char* what, program::Range r) {
    name += std::string("; ") + what + " " + std::to_string(r.first) + ".." + std::to_string(r.last);
  };
  span("digon", ranges.digon);
  span("hexagon", ranges.hexagon);
  span("quad-perimeter", ranges.quad_perimeter);
  span("other-perimeter", ranges.other_perimeter);
  name += "; methods";
  for (const Method method : methods) name += std::string(" ") + verify::name(method);
  return name;
}

namespace {

// The results of the cases. A case that is still to be run has none.
using Results = std::vector<std::optional<CaseResult>>;

// Counts regions or, if walks are asked for, the configurations they visit: a walk of one region can take long.
class CampaignProgress {
 public:
  CampaignProgress(const std::vector<RegionCase>& cases, bool by_configurations, bool quiet)
      : cases_(cases),
        by_configurations_(by_configurations),
        all_(std::max(1.0, by_configurations ? static_cast<double>(all_steps()) : cost_estimate(cases))),
        progress_(by_configurations ? "configurations" : "regions", all_steps(), quiet) {}

  void was_done_before(std::size_t i) { progress_.was_done(steps(i), share(i)); }
  void is_done(std::size_t i) {
    if (!by_configurations_) progress_.advance(1, share(i));
  }
  enumerate::WalkProgress while_walking() {
    if (!by_configurations_) return {};
    return [this](std::int64_t configurations) {
      progress_.advance(configurations, static_cast<double>(configurations) / all_);
    };
  }
  void finish() { progress_.finish(); }

 private:
  std::int64_t steps(std::size_t i) const {
    if (!by_configurations_) return 1;
    const auto* const pair = std::get_if<PairCase>(&cases_[i]);
    return pair != nullptr ? theory::exact_count(pair->shape) : 0;
  }
  double share(std::size_t i) const {
    return (by_configurations_ ? static_cast<double>(steps(i)) : cost_estimate(cases_[i])) / all_;
  }
  std::int64_t all_steps() const {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < cases_.size(); ++i) sum += steps(i);
    return sum;
  }

  const std::vector<RegionCase>& cases_;
  bool by_configurations_;
  double all_;  // the work of all cases
  program::Progress progress_;
};

void take_from_journal(Journal& journal, Results& results, CampaignProgress& progress) {
  for (auto& [i, result] : journal.results()) {
    results[i] = std::move(result);
    progress.was_done_before(i);
  }
  journal.results().clear();
}

// The cases without a result. The costliest come first, so that none of them is left for the end.
std::vector<std::size_t> still_to_do(const std::vector<RegionCase>& cases, const Results& results) {
  std::vector<std::size_t> todo;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i]) todo.push_back(i);
  }
  std::stable_sort(todo.begin(), todo.end(), [&cases](std::size_t a, std::size_t b) {
    return cost_estimate(cases[a]) > cost_estimate(cases[b]);
  });
  return todo;
}

// Adds the judgements of one case to the totals of the claims. Moves tables' rows and violations out of the result.
void add_up(const RegionCase& region, CaseResult& result, CampaignResult& campaign) {
  campaign.study_seconds += result.study_seconds;
  for (const auto& [method, seconds] : result.method_seconds) campaign.method_seconds[method] += seconds;
  RegionTotal& regions = campaign.regions[family_of(region)];
  ++regions.regions;
  if (result.fillings) {
    ++regions.searched;
    if (*result.fillings == 0) ++regions.empty;
  }
  for (ClaimJudgement& judged : result.judgements) {
    Judgement& j = judged.judgement;
    ClaimResult& total = campaign.claims[judged.claim];
    total.seconds += judged.seconds;
    ++total.instances;
    FamilyTotal& family = total.totals[family_of(region)];
    ++family.regions;
    family.checks += j.checks;
    if (!j.row.is_null()) total.table.push_back(std::move(j.row));
    total.violated += j.violation ? 1 : 0;
    if (j.violation && !total.violation) {
      total.violation = std::move(j.violation);
      total.predicted = std::move(j.predicted);
      total.found = std::move(j.found);
      total.violating_region = region;
    }
  }
}

void prove(ClaimResult& total) {
  try {
    attach_proof(total, theory::proof_of(total.claim->id));
  } catch (const std::exception& error) {
    if (program::is_exhaustion(error)) throw;
    total.violation =
        Violation{std::string("the proof for all sizes breaks off: ") + error.what(), "", "", std::nullopt};
  }
}

}  // namespace

CampaignResult run_campaign(const std::vector<const Claim*>& selected, const std::vector<RegionCase>& cases,
                            const std::set<Method>& methods, const Running& running) {
  Results results(cases.size());
  const bool walks_alone = methods == std::set<Method>{Method::walk};
  CampaignProgress progress(cases, walks_alone && !running.distribute, running.quiet);
  if (running.journal != nullptr) take_from_journal(*running.journal, results, progress);

  const std::vector<std::size_t> todo = still_to_do(cases, results);
  const Done done = [&](std::size_t i, CaseResult result) {
    if (running.journal != nullptr) running.journal->append(i, result);
    results[i] = std::move(result);
    progress.is_done(i);
  };
  if (running.distribute) {
    running.distribute(todo, done);
  } else {
    const enumerate::WalkProgress walking = progress.while_walking();
    threads::run_on_threads(todo.size(), running.threads, [&](std::size_t i) {
      done(todo[i], run_case(cases[todo[i]], selected, methods, walking));
    });
  }
  progress.finish();

  CampaignResult campaign;
  for (const Claim* claim : selected) {
    ClaimResult& total = campaign.claims.emplace_back();
    total.claim = claim;
    std::set_intersection(methods.begin(), methods.end(), claim->methods.begin(), claim->methods.end(),
                          std::inserter(total.methods, total.methods.begin()));
  }
  for (std::size_t i = 0; i < results.size(); ++i) add_up(cases[i], *results[i], campaign);
  for (ClaimResult& total : campaign.claims) prove(total);
  return campaign;
}

}  // namespace requad::verify
