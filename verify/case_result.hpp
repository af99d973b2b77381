// The result of a campaign for one region, and its JSON for journals (journal.hpp) and for other processes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "verify/claims/claims.hpp"

namespace requad::verify {

struct ClaimJudgement {
  std::size_t claim = 0;  // its index among the claims of the campaign
  Judgement judgement;
  double seconds = 0;  // of judging
};

struct CaseResult {
  std::vector<ClaimJudgement> judgements;  // by the claims that say something about the region, in their order
  // The fillings that the search found with the irregular vertices of the region. Nothing if there was no search.
  std::optional<std::int64_t> fillings;
  double study_seconds = 0;
  MethodSeconds method_seconds;  // the parts of these that its methods took
};

// Studies the region and judges it by each claim that concerns it. An exception from a check counts as a violation of
// its claim, one from the study as a violation of all claims. A walk reports the configurations that it visits to
// `progress`.
CaseResult run_case(const RegionCase& region, const std::vector<const Claim*>& selected,
                    const std::set<Method>& methods, const enumerate::WalkProgress& progress = {});

// Converts a result to JSON and back. The converted result makes the same report, byte for byte, and the same violating
// mesh.
nlohmann::ordered_json to_json(const CaseResult& result);
// Throws std::invalid_argument or an exception of the JSON library if the JSON is no result for this number of claims.
CaseResult case_result(const nlohmann::ordered_json& json, std::size_t claims);

}  // namespace requad::verify
