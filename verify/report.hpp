// Reports of a campaign, for people and for programs.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "verify/campaign.hpp"

namespace requad::verify {

// The ranges that were run, for the families of a claim: "digons L=3..24" and so on.
std::string range_text(const Ranges& ranges, const std::set<Family>& families);

// The report as JSON:
//   {"claims": [{"id", "statement", "verdict", "instances", "range", "methods", "seconds", "counterexample", "proof",
//                "table"}, ...],
//    "passed": bool,
//    "errata": [{"where", "written", "found", "instance"}, ...],
//    "sentences": [{"where", "sentence", "reason"}, ...],
//    "regions": [{"family", "range", "regions", "searched", "empty"}, ...]}
// Of a family's regions, those are searched whose boundary a search filled in every possible way, and those of them are
// empty that have no filling.
// "proof" is null or
//   {"for", "statement", "premises", "steps": [{"text", "computed", "holds"}, ...], "proved"}
// A claim without an instance is undecided. If the check of a claim makes no table rows, its table has a row for each
// family.
nlohmann::ordered_json report_json(const CampaignResult& result, const Ranges& ranges);

// The report as text: the regions, a line for each claim, then what is proved for every size, then the violations.
std::string report_text(const CampaignResult& result, const Ranges& ranges);

// A proof in full: its premises and its steps, each of them argued or computed.
std::string proof_text(const theory::Proof& proof);

// The report as one self-contained HTML page. For each claim it has the statement, what the check compares, the
// verdict, the totals by family, and the first kRowsShown rows of the table.
inline constexpr std::size_t kRowsShown = 60;
std::string report_html(const CampaignResult& result, const Ranges& ranges);

// Parts of the report, for the commands that print them alone.
nlohmann::ordered_json claims_json();  // [{"id", "where", "statement", "compares", "fails_if"}, ...]
nlohmann::ordered_json sentences_json();
nlohmann::ordered_json proof_json(const std::optional<theory::Proof>& proof);

// "holds", "fails", "undecided".
const char* verdict(const ClaimResult& claim);

}  // namespace requad::verify
