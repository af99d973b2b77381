// A campaign: claims checked on many regions, in parallel, with results that do not depend on the number of threads.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/program/numbers.hpp"
#include "theory/proofs/proofs.hpp"
#include "verify/case_result.hpp"
#include "verify/journal.hpp"

namespace requad::verify {

// Which regions. Ranges are inclusive; a range whose last is below its first is empty.
struct Ranges {
  program::Range digon{3, 24};    // side length of regular digons
  program::Range hexagon{3, 12};  // side length of regular hexagons
  program::Range quad_perimeter{8, 24};
  program::Range other_perimeter{4,
                                 24};  // of non-regular digons and hexagons, and of regions with one irregular vertex
};

// Regions with a single irregular vertex: valences 2..9, other than 4, of these perimeters up to 20, with a configuration
// or without; and regular ones of side 2, 3, 4, 6 and 8 for valences 2..12, 4 being the regular grid.
// All regions of the ranges that have a configuration, each once up to rotation of its sides. (The others have an empty
// parameter set and an exact count of 0: counted in `empty`.) Families in order, then by perimeter, then by sides.
// Regions with three of v3, v5, of perimeter up to 18 to 22.
struct CaseList {
  std::vector<RegionCase> cases;
  std::map<Family, std::int64_t> empty;
};
CaseList list_cases(const Ranges& ranges, const std::set<Family>& families);

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

// Puts the proof beside the instances; one that does not go through makes the claim fail.
void attach_proof(ClaimResult& result, std::optional<theory::Proof> proof);

struct CampaignResult {
  std::vector<ClaimResult> claims;
  std::map<Family, std::int64_t> empty;
  double study_seconds = 0;  // of exploring, summed over threads
  bool passed() const;
};

// Makes the results of the cases in `todo`, in any order and anywhere, and hands each to `done`, once.
using Done = std::function<void(std::size_t, CaseResult)>;
using Distribute = std::function<void(const std::vector<std::size_t>& todo, const Done& done)>;

struct Running {
  int threads = 0;  // of this process; 0: all cores
  bool quiet = false;
  Journal* journal = nullptr;  // results that stand there are taken from it, all others are added
  Distribute distribute = {};  // instead of threads of this process
};

// Runs the claims on the cases. The result depends on neither `running` nor the order in which cases end, but for seconds.
CampaignResult run_campaign(const std::vector<const Claim*>& selected, const CaseList& list,
                            const std::set<Method>& methods, const Running& running);

// What the campaign is, in a line: two runs may share a journal iff these are equal.
std::string campaign_name(const std::string& version, const std::vector<const Claim*>& selected, const Ranges& ranges,
                          const std::set<Method>& methods);

}  // namespace requad::verify
