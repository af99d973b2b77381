// A campaign checks claims on many regions in parallel. Its results do not depend on the number of threads.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "theory/proofs/proofs.hpp"
#include "verify/case_list.hpp"
#include "verify/case_result.hpp"
#include "verify/journal.hpp"

namespace requad::verify {

struct FamilyTotal {
  std::int64_t regions = 0;
  std::int64_t checks = 0;
};

struct ClaimResult {
  const Claim* claim = nullptr;
  std::int64_t instances = 0;  // regions judged
  std::set<Method> methods;    // those that were used
  std::map<Family, FamilyTotal> totals;
  nlohmann::ordered_json table = nlohmann::ordered_json::array();
  double seconds = 0;                  // of judging, summed over threads
  std::optional<Violation> violation;  // the first in the order of the cases
  std::optional<RegionCase> violating_region;
  std::optional<theory::Proof> proof;  // for every size, where linear algebra decides the claim
};

// Adds the proof to the instances. A proof that does not go through makes the claim fail.
void attach_proof(ClaimResult& result, std::optional<theory::Proof> proof);

struct CampaignResult {
  std::vector<ClaimResult> claims;
  std::map<Family, std::int64_t> empty;
  double study_seconds = 0;  // of exploring, summed over threads
  bool passed() const;
};

// Runs the cases in `todo`, in any order and in any process, and hands the result of each to `done` once.
using Done = std::function<void(std::size_t, CaseResult)>;
using Distribute = std::function<void(const std::vector<std::size_t>& todo, const Done& done)>;

struct Running {
  int threads = 0;  // of this process; 0: all cores
  bool quiet = false;
  Journal* journal = nullptr;  // its results are taken over, all others are added to it
  Distribute distribute = {};  // if given, replaces the threads of this process
};

// Runs the claims on the cases. The result depends on neither `running` nor the order in which cases end, but for
// seconds.
CampaignResult run_campaign(const std::vector<const Claim*>& selected, const CaseList& list,
                            const std::set<Method>& methods, const Running& running);

// The campaign in one line. Two runs may share a journal iff their lines are equal.
std::string campaign_name(const std::string& version, const std::vector<const Claim*>& selected, const Ranges& ranges,
                          const std::set<Method>& methods);

}  // namespace requad::verify
