// What a campaign keeps of one region, and how it travels: into a journal (journal.hpp) and between processes.
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

// Studies the region and lets each claim that concerns it judge. An exception is a violation of the claim (of all of
// them, if it comes from the study), never lost. `progress` is told of configurations that a walk visits.
CaseResult run_case(const RegionCase& region, const std::vector<const Claim*>& selected,
                    const std::set<Method>& methods, const enumerate::WalkProgress& progress = {});

// As JSON, and back. What comes back makes the same report, byte for byte, and the same mesh of a violation.
nlohmann::ordered_json to_json(const CaseResult& result);
// Throws std::invalid_argument, or an exception of the JSON library, if that is no result for so many claims.
CaseResult case_result(const nlohmann::ordered_json& json, std::size_t claims);

}  // namespace requad::verify
