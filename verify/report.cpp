#include "verify/report.hpp"

#include <iomanip>
#include <sstream>

namespace requad::verify {

using nlohmann::ordered_json;

namespace {

std::string range_of(Family family, const Ranges& ranges) {
  const auto span = [](program::Range r) { return std::to_string(r.first) + ".." + std::to_string(r.last); };
  switch (family) {
    case Family::regular_digon: return "digons L=" + span(ranges.digon);
    case Family::regular_hexagon: return "hexagons L=" + span(ranges.hexagon);
    case Family::quad: return "3-5 regions of perimeter " + span(ranges.quad_perimeter);
    case Family::other_digon: return "non-regular digons of perimeter " + span(ranges.other_perimeter);
    case Family::other_hexagon: return "non-regular hexagons of perimeter " + span(ranges.other_perimeter);
    case Family::single_vertex: return "regions with one irregular vertex";
  }
  return "";
}

ordered_json counterexample(const ClaimResult& c) {
  if (!c.violation) return nullptr;
  return {{"region", c.violating_region ? describe(*c.violating_region) : ""},
          {"configuration", c.violation->configuration}, {"move", c.violation->move}, {"what", c.violation->what}};
}

}  // namespace

std::string range_text(const Ranges& ranges, const std::set<Family>& families) {
  std::string text;
  for (const Family family : families) text += (text.empty() ? "" : "; ") + range_of(family, ranges);
  return text;
}

const char* verdict(const ClaimResult& c) { return c.violation ? "fails" : c.instances > 0 ? "holds" : "undecided"; }

ordered_json report_json(const CampaignResult& result, const Ranges& ranges) {
  ordered_json json{{"claims", ordered_json::array()}, {"passed", result.passed()}};
  for (const ClaimResult& c : result.claims) {
    ordered_json table = c.table;
    ordered_json methods = ordered_json::array();
    for (const Method method : c.methods) methods.push_back(name(method));
    ordered_json totals = ordered_json::array();
    for (const auto& [family, total] : c.totals) {
      totals.push_back({{"family", name(family)}, {"regions", total.regions}, {"checks", total.checks}});
    }
    if (table.empty()) table = totals;
    json["claims"].push_back({{"id", c.claim->id}, {"where", c.claim->where}, {"statement", c.claim->statement},
                              {"verdict", verdict(c)}, {"instances", c.instances},
                              {"range", range_text(ranges, c.claim->families)}, {"methods", methods},
                              {"compares", c.claim->compares}, {"seconds", c.seconds},
                              {"counterexample", counterexample(c)}, {"totals", totals}, {"table", std::move(table)}});
  }
  return json;
}

std::string report_text(const CampaignResult& result, const Ranges& ranges) {
  std::ostringstream out;
  std::set<Family> families;
  for (const ClaimResult& c : result.claims) families.insert(c.claim->families.begin(), c.claim->families.end());
  for (const Family family : families) {
    out << range_of(family, ranges);
    if (const auto it = result.empty.find(family); it != result.empty.end()) {
      out << " (" << it->second << " more have no configuration, by count and by parameter set)";
    }
    out << '\n';
  }
  out << "\nclaim  verdict     regions    checks  statement\n";
  for (const ClaimResult& c : result.claims) {
    std::int64_t checks = 0;
    for (const auto& [family, total] : c.totals) checks += total.checks;
    out << std::left << std::setw(7) << c.claim->id << std::setw(10) << verdict(c) << std::right << std::setw(9) << c.instances
        << std::setw(10) << checks << "  " << c.claim->statement << " [" << c.claim->where << "]\n";
  }
  for (const ClaimResult& c : result.claims) {
    if (!c.violation) continue;
    out << '\n' << c.claim->id << " fails: " << (c.violating_region ? describe(*c.violating_region) : "a region");
    if (!c.violation->configuration.empty()) out << ", configuration " << c.violation->configuration;
    if (!c.violation->move.empty()) out << ", move " << c.violation->move;
    out << ": " << c.violation->what << '\n';
  }
  return out.str();
}

}  // namespace requad::verify
