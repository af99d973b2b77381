// The result of a campaign for one region, and its JSON for journals (journal.hpp) and for other processes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "verify/claims/claims.hpp"

namespace requad::verify {

struct CaseResult {
  std::vector<Judgement> judgements;  // one for each claim of the campaign
  std::vector<double> seconds;        // of judging, likewise
  double study_seconds = 0;
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
