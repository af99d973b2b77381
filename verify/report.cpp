#include "verify/report.hpp"

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

std::string range_of(Family family, const Ranges& ranges) {
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
                    {"fails_if", c.fails_if}});
  }
  return {{"claims", list}};
}

ordered_json sentences_json() {
  ordered_json list = ordered_json::array();
  for (const UndecidedSentence& s : undecided_sentences())
    list.push_back({{"where", s.where}, {"sentence", s.sentence}, {"reason", s.reason}});
  return {{"sentences", list}};
}

std::string range_text(const Ranges& ranges, const std::set<Family>& families) {
  std::string text;
  for (const Family family : families) text += (text.empty() ? "" : "; ") + range_of(family, ranges);
  return text;
}

const char* verdict(const ClaimResult& c) { return c.violation ? "fails" : c.instances > 0 ? "holds" : "undecided"; }

ordered_json report_json(const CampaignResult& result, const Ranges& ranges) {
  ordered_json json{{"claims", ordered_json::array()}, {"passed", result.passed()}, {"errata", ordered_json::array()}};
  for (const Erratum& e : find_errata()) {
    json["errata"].push_back(
        {{"where", e.where}, {"written", e.written}, {"found", e.found}, {"instance", e.instance}});
  }
  json.update(sentences_json());
  json["regions"] = ordered_json::array();
  for (const auto& [family, total] : result.regions) {
    json["regions"].push_back({{"family", name(family)},
                               {"range", range_of(family, ranges)},
                               {"regions", total.regions},
                               {"searched", total.searched},
                               {"empty", total.empty}});
  }
  for (const ClaimResult& c : result.claims) {
    ordered_json table = c.table;
    ordered_json methods = ordered_json::array();
    for (const Method method : c.methods) methods.push_back(name(method));
    ordered_json totals = ordered_json::array();
    for (const auto& [family, total] : c.totals) {
      totals.push_back({{"family", name(family)}, {"regions", total.regions}, {"checks", total.checks}});
    }
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
    out << range_of(family, ranges);
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

namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else {
      result += c;
    }
  }
  return result;
}

std::string cell(const ordered_json& value) {
  if (value.is_string()) return escaped(value.get<std::string>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const auto& x : value) text += (text.empty() ? "" : " ") + (x.is_string() ? x.get<std::string>() : x.dump());
  return text;
}

// A table with a line of headings. All rows must have the same keys.
std::string html_table(const ordered_json& rows) {
  if (rows.empty()) return "";
  std::string html = "<table>\n<tr>";
  for (const auto& [key, value] : rows.front().items()) html += "<th>" + escaped(key) + "</th>";
  html += "</tr>\n";
  for (std::size_t i = 0; i < std::min(rows.size(), kRowsShown); ++i) {
    html += "<tr>";
    for (const auto& [key, value] : rows.front().items())
      html += "<td>" + (rows[i].contains(key) ? cell(rows[i][key]) : "") + "</td>";
    html += "</tr>\n";
  }
  html += "</table>\n";
  if (rows.size() > kRowsShown) {
    html += "<p>The first " + std::to_string(kRowsShown) + " of " + std::to_string(rows.size()) +
            " rows; the JSON report has them all.</p>\n";
  }
  return html;
}

// The proof for all sizes, shown separately from the instances.
std::string html_proof(const ordered_json& proof) {
  const bool proved = proof["proved"].get<bool>();
  std::string html = std::string(R"(<details class="proof"><summary><span class=")") +
                     (proved ? "holds\">Proved" : "fails\">Not proved") + "</span> for " + escaped(proof["for"]) +
                     ", apart from the instances: " + escaped(proof["statement"]) + "</summary>\n<p>Given:</p>\n<ul>\n";
  for (const auto& premise : proof["premises"]) html += "<li>" + escaped(premise) + "</li>\n";
  html += "</ul>\n<ol>\n";
  for (const auto& step : proof["steps"]) {
    const char* outcome = !step["computed"].get<bool>() ? ""
                          : step["holds"].get<bool>()   ? " <em>(computed)</em>"
                                                        : " <em class=\"fails\">(fails)</em>";
    html += "<li>" + escaped(step["text"]) + outcome + "</li>\n";
  }
  return html + "</ol>\n</details>\n";
}

}  // namespace

std::string report_html(const CampaignResult& result, const Ranges& ranges) {
  const ordered_json report = report_json(result, ranges);
  std::string html = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>requad: the claims, one by one</title>
<style>
body {
  font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; color: #222;
  background: #fff;
}
h2 { margin-top: 2.5rem; border-top: 1px solid #ccc; padding-top: 1rem; }
table { border-collapse: collapse; font-size: 0.9rem; display: block; overflow-x: auto; }
th, td { border: 1px solid #ccc; padding: 0.15rem 0.5rem; text-align: right; }
#errata ~ table td, #errata ~ table th, #sentences ~ table td, #sentences ~ table th { text-align: left; vertical-align: top; }
.holds { color: #1b6e3a; } .fails { color: #b3261e; } .undecided { color: #8a5a00; }
nav a { display: inline-block; margin-right: 0.7rem; }
</style>
</head>
<body>
<h1>The claims, one by one</h1>
<p>Claims of Peng, Zhang, Kobayashi and Wonka, <em>Connectivity Editing for Quadrilateral Meshes</em> (2011), checked by
computer. <em>Moves</em> explores from one configuration by every pair move until nothing is new; <em>search</em> fills
the boundary with quads in every possible way, without any theorem.</p>
<nav aria-label="claims">
)";
  for (const auto& c : report["claims"]) {
    html += "<a class=\"" + c["verdict"].get<std::string>() + "\" href=\"#" + c["id"].get<std::string>() + "\">" +
            c["id"].get<std::string>() + "</a>\n";
  }
  html += "<a href=\"#errata\">errata</a>\n<a href=\"#sentences\">sentences</a>\n</nav>\n";
  html +=
      "<p>The regions of each family. In an empty region the search finds no filling, so moves have nothing to start "
      "from.</p>\n" +
      html_table(report["regions"]);
  for (const auto& c : report["claims"]) {
    const std::string verdict_text = c["verdict"];
    html += "<section>\n<h2 id=\"" + c["id"].get<std::string>() + "\">" + c["id"].get<std::string>() +
            ": <span class=\"" + verdict_text + "\">" + verdict_text + "</span></h2>\n<p>" + escaped(c["statement"]) +
            " <em>(" + escaped(c["where"]) + ")</em></p>\n<p>Compared: " + escaped(c["compares"]) +
            ". The check fails if " + escaped(c["fails_if"]) + ". Found by: " + escaped(cell(c["methods"])) +
            ". Range: " + escaped(c["range"]) + ".</p>\n";
    if (!c["counterexample"].is_null()) {
      html += "<p class=\"fails\">Violated by: " + escaped(c["counterexample"]["region"]) + " " +
              escaped(c["counterexample"]["configuration"]) + " " + escaped(c["counterexample"]["move"]) + ": " +
              escaped(c["counterexample"]["what"]) + "<br>Predicted: " + escaped(c["counterexample"]["predicted"]) +
              "<br>Found: " + escaped(c["counterexample"]["found"]) + "</p>\n";
    }
    if (!c["proof"].is_null()) html += html_proof(c["proof"]);
    if (!c["totals"].empty()) html += html_table(c["totals"]);
    if (!c["table"].empty() && c["table"] != c["totals"])
      html += "<details><summary>Region by region</summary>\n" + html_table(c["table"]) + "</details>\n";
    html += "</section>\n";
  }
  html +=
      "<section>\n<h2 id=\"errata\">Errata</h2>\n<p>Slips in the text that the program found, each with the smallest "
      "region that shows it.</p>\n" +
      html_table(report["errata"]) +
      "</section>\n<section>\n<h2 id=\"sentences\">Sentences without a check</h2>\n<p>What the paper says and no check "
      "can decide, each with the reason.</p>\n" +
      html_table(report["sentences"]) + "</section>\n";
  return html + "</body>\n</html>\n";
}

}  // namespace requad::verify
