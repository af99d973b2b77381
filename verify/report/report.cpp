#include "verify/report/report.hpp"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

#include "mesh/program/layout.hpp"
#include "verify/claims/judging.hpp"
#include "verify/errata.hpp"
#include "verify/sentences.hpp"

namespace requad::verify {

using nlohmann::ordered_json;

namespace {

constexpr std::size_t kHanging = 7;  // the column after a claim's id

ordered_json counterexample(const ClaimResult& c) {
  if (!c.violation) return nullptr;
  return {{"region", c.violating_region ? describe(*c.violating_region) : ""},
          {"configuration", c.violation->configuration},
          {"move", c.violation->move},
          {"what", c.violation->what},
          {"predicted", c.predicted},
          {"found", c.found}};
}

}  // namespace

ordered_json proof_json(const std::optional<theory::Proof>& proof) {
  if (!proof) return nullptr;
  ordered_json steps = ordered_json::array();
  for (const theory::ProofStep& step : proof->steps) {
    steps.push_back({{"text", step.text}, {"computed", step.computed}, {"holds", step.holds}});
  }
  return {{"for", proof->range},
          {"statement", proof->statement},
          {"premises", proof->premises},
          {"steps", steps},
          {"proved", proof->proved()}};
}

ordered_json claims_json() {
  ordered_json list = ordered_json::array();
  for (const Claim& c : claims()) {
    list.push_back({{"id", c.id},
                    {"where", c.where},
                    {"statement", c.statement},
                    {"compares", c.compares},
                    {"fails_if", c.fails_if},
                    {"range", range_text({}, c.families)},
                    {"proved", theory::proof_of(c.id).has_value()}});
  }
  return {{"claims", list}};
}

ordered_json errata_json() {
  ordered_json list = ordered_json::array();
  for (const Erratum& e : find_errata())
    list.push_back({{"where", e.where}, {"written", e.written}, {"found", e.found}, {"instance", e.instance}});
  return {{"errata", list}};
}

ordered_json sentences_json() {
  ordered_json list = ordered_json::array();
  for (const UndecidedSentence& s : undecided_sentences())
    list.push_back({{"where", s.where}, {"sentence", s.sentence}, {"reason", s.reason}});
  return {{"sentences", list}};
}

std::string range_text(const Ranges& ranges, Family family) {
  const auto span = [](program::Range r) {
    return std::to_string(r.first) + (r.first == r.last ? "" : ".." + std::to_string(r.last));
  };
  switch (family) {
    case Family::regular_digon: return "digons L=" + span(ranges.digon);
    case Family::regular_hexagon: return "hexagons L=" + span(ranges.hexagon);
    case Family::quad: return "3-5 regions of perimeter " + span(ranges.quad_perimeter);
    case Family::other_digon: return "non-regular digons of perimeter " + span(ranges.other_perimeter);
    case Family::other_hexagon: return "non-regular hexagons of perimeter " + span(ranges.other_perimeter);
    case Family::single_vertex:
    case Family::three_vertices: return name(family);
  }
  return "";
}

std::string range_text(const Ranges& ranges, const std::set<Family>& families) {
  std::string text;
  for (const Family family : families) text += (text.empty() ? "" : "; ") + range_text(ranges, family);
  return text;
}

ordered_json totals_json(const ClaimResult& c) {
  ordered_json totals = ordered_json::array();
  for (const auto& [family, total] : c.totals)
    totals.push_back({{"family", name(family)}, {"regions", total.regions}, {"checks", total.checks}});
  return totals;
}

const char* verdict(const ClaimResult& c) { return c.violation ? "fails" : c.instances > 0 ? "holds" : "undecided"; }

ordered_json report_json(const CampaignResult& result, const Ranges& ranges) {
  ordered_json json{{"claims", ordered_json::array()}, {"passed", result.passed()}};
  json.update(errata_json());
  json.update(sentences_json());
  json["regions"] = ordered_json::array();
  for (const auto& [family, total] : result.regions) {
    json["regions"].push_back({{"family", name(family)},
                               {"range", range_text(ranges, family)},
                               {"regions", total.regions},
                               {"searched", total.searched},
                               {"empty", total.empty}});
  }
  json["methods"] = ordered_json::array();
  for (const auto& [method, seconds] : result.method_seconds)
    json["methods"].push_back({{"method", name(method)}, {"seconds", seconds}});
  for (const ClaimResult& c : result.claims) {
    ordered_json table = c.table;
    ordered_json methods = ordered_json::array();
    for (const Method method : c.methods) methods.push_back(name(method));
    const ordered_json totals = totals_json(c);
    if (table.empty()) table = totals;
    json["claims"].push_back({{"id", c.claim->id},
                              {"where", c.claim->where},
                              {"statement", c.claim->statement},
                              {"verdict", verdict(c)},
                              {"instances", c.instances},
                              {"range", range_text(ranges, c.claim->families)},
                              {"methods", methods},
                              {"compares", c.claim->compares},
                              {"fails_if", c.claim->fails_if},
                              {"seconds", c.seconds},
                              {"violated", c.violated},
                              {"counterexample", counterexample(c)},
                              {"proof", proof_json(c.proof)},
                              {"totals", totals},
                              {"table", std::move(table)}});
  }
  return json;
}

std::string report_text(const CampaignResult& result, const Ranges& ranges) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  std::set<Family> families;
  for (const ClaimResult& c : result.claims) families.insert(c.claim->families.begin(), c.claim->families.end());
  for (const Family family : families) {
    out << range_text(ranges, family);
    if (const auto it = result.regions.find(family); it != result.regions.end()) {
      const RegionTotal& total = it->second;
      out << ": " << counted(total.regions, "region") << ", " << total.searched << " searched";
      if (total.searched > 0) out << ", " << total.empty << " of these empty";
    }
    out << '\n';
  }
  out << "\nclaim  verdict     regions    checks  statement\n";
  // The columns before the statement. Where too little room is left beside them, the statement begins a new line.
  constexpr std::size_t kBesideNumbers = 38, kBelowNumbers = 7, kRoom = 30;
  const bool is_beside = program::text_width() >= kBesideNumbers + kRoom;
  for (const ClaimResult& c : result.claims) {
    std::int64_t checks = 0;
    for (const auto& [family, total] : c.totals) checks += total.checks;
    out << std::left << std::setw(7) << c.claim->id << std::setw(10) << verdict(c) << std::right << std::setw(9)
        << c.instances << std::setw(10) << checks;
    std::vector<std::string> statement =
        program::wrapped(c.claim->statement + " [" + c.claim->where + "]", is_beside ? kBesideNumbers : kBelowNumbers,
                         program::text_width());
    if (is_beside) {
      statement.front().erase(0, kBesideNumbers - 2);  // the columns before it are written
    } else {
      out << '\n';
    }
    for (const std::string& line : statement) out << line << '\n';
  }
  const char* heading =
      "\nproved by exact arithmetic for every size, apart from these instances\n(--proofs has the steps):\n";
  for (const ClaimResult& c : result.claims) {
    if (!c.proof || !c.proof->proved()) continue;
    out << heading << std::left << std::setw(7) << c.claim->id << c.proof->range << ": " << c.proof->statement << '\n';
    heading = "";
  }
  out << '\n'
      << undecided_sentences().size()
      << " sentences of the paper are outside the claims, since no check can decide them (--sentences has the "
         "reasons)\n";
  for (const ClaimResult& c : result.claims) {
    if (!c.violation) continue;
    out << '\n' << c.claim->id << " fails";
    if (c.violating_region) out << ": " << describe(*c.violating_region);
    out << ": " << described(*c.violation) << '\n';
    if (c.violated > 1) out << "  and in " << counted(c.violated - 1, "other region") << ", not shown\n";
    if (!c.predicted.empty()) out << "  predicted: " << c.predicted << "\n  found: " << c.found << '\n';
  }
  return program::fitted(out.str(), kHanging);
}

std::string proof_text(const theory::Proof& proof) {
  std::string out = proof.claim + ", for " + proof.range + (proof.proved() ? ", is proved: " : ", is not proved: ") +
                    proof.statement + '\n';
  for (const std::string& premise : proof.premises) out += "  given      " + premise + '\n';
  for (const theory::ProofStep& step : proof.steps) {
    out += (!step.computed ? "  argued     " : step.holds ? "  computed   " : "  FAILS      ") + step.text + '\n';
  }
  return out;
}

}  // namespace requad::verify
