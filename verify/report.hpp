// Reports of a campaign, for people and for programs.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "verify/campaign.hpp"

namespace requad::verify {

// What was run, for the report: "digons L=3..24" and so on for the families of a claim.
std::string range_text(const Ranges& ranges, const std::set<Family>& families);

// {"claims":[{"id","statement","verdict","instances","range","methods","seconds","counterexample","proof","table"},...],
//  "passed":bool, "errata":[{"where","written","found","instance"},...]}. "proof" is null, or
// {"for","statement","premises","steps":[{"text","computed","holds"},...],"proved"}. A claim without an instance is
// undecided. Claims without rows of their own have one for each family.
nlohmann::ordered_json report_json(const CampaignResult& result, const Ranges& ranges);

// A line for each claim, what is proved for every size apart from the instances, and the violations at the end.
std::string report_text(const CampaignResult& result, const Ranges& ranges);

// The proofs in full: premises, and step by step what was argued and what was computed.
std::string proof_text(const theory::Proof& proof);

// One self-contained HTML page, claim by claim: statement, what the check compares, verdict, totals by family, and the
// table (its first kRowsShown rows).
inline constexpr std::size_t kRowsShown = 60;
std::string report_html(const CampaignResult& result, const Ranges& ranges);

// "holds", "fails", "undecided".
const char* verdict(const ClaimResult& claim);

}  // namespace requad::verify
