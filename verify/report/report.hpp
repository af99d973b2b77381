// Reports of a campaign, for programs and for terminals. For browsers: html.hpp.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "verify/campaign.hpp"

namespace requad::verify {

// The range that was run of a family: "digons L=3..24". The same for the families of a claim.
std::string range_text(const Ranges& ranges, Family family);
std::string range_text(const Ranges& ranges, const std::set<Family>& families);

// The report as JSON:
//   {"claims": [{"id", "statement", "verdict", "instances", "range", "methods", "seconds", "counterexample", "proof",
//                "table"}, ...],
//    "passed": bool,
//    "errata": [{"where", "written", "found", "instance"}, ...],
//    "sentences": [{"where", "sentence", "reason"}, ...],
//    "regions": [{"family", "range", "regions", "searched", "empty"}, ...],
//    "methods": [{"method", "seconds"}, ...]}
// Of a family's regions, those are searched whose boundary a search filled in every possible way, and those of them are
// empty that have no filling. Apart from the seconds, which are summed over threads, the same campaign gives the same
// report.
// "proof" is null or
//   {"for", "statement", "premises", "steps": [{"text", "computed", "holds"}, ...], "proved"}
// A claim without an instance is undecided. If the check of a claim makes no table rows, its table has a row for each
// family.
nlohmann::ordered_json report_json(const CampaignResult& result, const Ranges& ranges);

// The report as text: the regions, a line for each claim, then what is proved for every size, then the violations.
std::string report_text(const CampaignResult& result, const Ranges& ranges);

// A proof in full: its premises and its steps, each of them argued or computed.
std::string proof_text(const theory::Proof& proof);

// Parts of the report, for the commands that print them alone.
// [{"id", "where", "statement", "compares", "fails_if", "range", "proved"}, ...]: the default range, and whether there is
// a proof for all sizes (theory/proofs/proofs.hpp).
nlohmann::ordered_json claims_json();
nlohmann::ordered_json errata_json();                          // {"errata": ...} as in the report
nlohmann::ordered_json sentences_json();                       // {"sentences": ...} as in the report
nlohmann::ordered_json totals_json(const ClaimResult& claim);  // [{"family", "regions", "checks"}, ...]
nlohmann::ordered_json proof_json(const std::optional<theory::Proof>& proof);

// "holds", "fails", "undecided".
const char* verdict(const ClaimResult& claim);

}  // namespace requad::verify
