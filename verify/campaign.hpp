// A campaign checks claims on many regions in parallel. The number of threads does not change its results.
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
  std::set<Method> methods;    // used by the check
  std::map<Family, FamilyTotal> totals;
  nlohmann::ordered_json table = nlohmann::ordered_json::array();
  double seconds = 0;                  // spent on judging, summed over threads
  std::int64_t violated = 0;           // regions that violate the claim
  std::optional<Violation> violation;  // the first in the order of the cases
  std::optional<RegionCase> violating_region;
  std::string predicted;  // for the violating region, beside what was found there (claims/claims.hpp)
  std::string found;
  std::optional<theory::Proof> proof;  // for every size, where linear algebra decides the claim
};

// Adds the proof to the instances. A proof that does not go through makes the claim fail.
void attach_proof(ClaimResult& result, std::optional<theory::Proof> proof);

// The regions of a family.
struct RegionTotal {
  std::int64_t regions = 0;
  std::int64_t searched = 0;  // those whose boundary a search filled in every possible way
  std::int64_t empty = 0;     // those for which it found no filling: there moves have nothing to start from
};

struct CampaignResult {
  std::vector<ClaimResult> claims;
  std::map<Family, RegionTotal> regions;
  double study_seconds = 0;      // spent on studies, summed over threads
  MethodSeconds method_seconds;  // the parts of these that each method took
  bool passed() const;
};

// Runs the cases in `todo`, in any order and in any process, and hands the result of each to `done` once.
using Done = std::function<void(std::size_t, CaseResult)>;
using Distribute = std::function<void(const std::vector<std::size_t>& todo, const Done& done)>;

struct Running {
  int threads = 0;  // of this process; 0: all cores
  bool quiet = false;
  Journal* journal = nullptr;  // if given, supplies the results it has and receives all others
  Distribute distribute = {};  // if given, replaces the threads of this process
};

// Checks the claims on the cases. Apart from the seconds, the result depends neither on `running` nor on the order in
// which cases end.
CampaignResult run_campaign(const std::vector<const Claim*>& selected, const std::vector<RegionCase>& cases,
                            const std::set<Method>& methods, const Running& running);

// The campaign in one line. Two runs may share a journal iff their lines are equal.
std::string campaign_name(const std::string& version, const std::vector<const Claim*>& selected, const Ranges& ranges,
                          const std::set<Method>& methods);

}  // namespace requad::verify
