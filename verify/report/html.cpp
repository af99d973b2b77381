#include "verify/report/html.hpp"

#include <algorithm>
#include <utility>

#include "mesh/program/layout.hpp"
#include "verify/errata.hpp"
#include "verify/report/numbers.hpp"
#include "verify/report/pictures.hpp"
#include "verify/report/report.hpp"
#include "verify/report/style.hpp"
#include "verify/report/svg.hpp"
#include "verify/report/words.hpp"
#include "verify/sentences.hpp"

namespace requad::verify {

using nlohmann::ordered_json;
using program::counted;

namespace {

// --- elements --------------------------------------------------------------------------------------------------------

std::string paragraph(const std::string& text) { return "<p>" + escaped(text) + "</p>\n"; }

std::string term(const std::string& word, const std::string& meaning) {
  return "<dt>" + escaped(word) + "</dt><dd>" + escaped(meaning) + "</dd>\n";
}

std::string figure(const Picture& picture) {
  return "<figure>" + picture.svg + "<figcaption>" + escaped(picture.caption) + "</figcaption></figure>";
}

std::string verdict_mark(const std::string& verdict) {
  return "<span class=\"verdict " + verdict + "\">" + verdict + "</span>";
}

std::string cell(const ordered_json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return escaped(value.get<std::string>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "<strong class=\"fails\">no</strong>";
  if (value.is_number_integer()) return grouped(value.get<std::int64_t>());
  if (!value.is_array()) return escaped(value.dump());
  std::string text;
  for (const auto& x : value)
    text += (text.empty() ? "" : " ") + escaped(x.is_string() ? x.get<std::string>() : x.dump());
  return text;
}

// The keys of the rows, each once. A key stands after the one that it follows in the first row that has it.
std::vector<std::string> columns(const ordered_json& rows) {
  std::vector<std::string> keys;
  for (const auto& row : rows) {
    auto place = keys.begin();
    for (const auto& [key, value] : row.items()) {
      const auto known = std::find(keys.begin(), keys.end(), key);
      place = known != keys.end() ? known + 1 : keys.insert(place, key) + 1;
    }
  }
  return keys;
}

bool is_words(const ordered_json& value) { return value.is_string() || value.is_array(); }

std::string html_table(const std::string& claim, const ordered_json& rows) {
  const std::vector<std::string> keys = columns(rows);
  const auto start = [&](const char* element, const ordered_json& row, const std::string& key) {
    return std::string("<") + element + (row.contains(key) && is_words(row[key]) ? " class=\"words\">" : ">");
  };
  std::string html =
      "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"table of " + claim + "\"><table>\n<thead><tr>";
  for (const std::string& key : keys)
    html += start("th scope=\"col\"", rows.front(), key) + escaped(heading(claim, key)) + "</th>";
  html += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < std::min(rows.size(), kRowsShown); ++i) {
    html += "<tr>";
    for (const std::string& key : keys)
      html += start("td", rows[i], key) + (rows[i].contains(key) ? cell(rows[i][key]) : "") + "</td>";
    html += "</tr>\n";
  }
  html += "</tbody></table></div>\n";
  if (rows.size() > kRowsShown) {
    html += paragraph("The first " + std::to_string(kRowsShown) + " of " +
                      grouped(static_cast<std::int64_t>(rows.size())) + " rows; the JSON report has them all.");
  }
  return html;
}

// The proof for all sizes, shown separately from the instances.
std::string html_proof(const theory::Proof& proof) {
  std::string html = std::string(R"(<details class="proof"><summary><span class=")") +
                     (proof.proved() ? "holds\">Proved" : "fails\">Not proved") + "</span> for " +
                     escaped(proof.range) + ", apart from the instances: " + escaped(proof.statement) +
                     "</summary>\n<p>Given:</p>\n<ul>\n";
  for (const std::string& premise : proof.premises) html += "<li>" + escaped(premise) + "</li>\n";
  html += "</ul>\n<ol>\n";
  for (const theory::ProofStep& step : proof.steps) {
    const char* outcome = !step.computed ? ""
                          : step.holds   ? " <em>(computed)</em>"
                                         : " <em class=\"fails\">(fails)</em>";
    html += "<li>" + escaped(step.text) + outcome + "</li>\n";
  }
  return html + "</ol>\n</details>\n";
}

// --- parts of the page -----------------------------------------------------------------------------------------------

std::int64_t checks_of(const ClaimResult& c) {
  std::int64_t checks = 0;
  for (const auto& [family, total] : c.totals) checks += total.checks;
  return checks;
}

// "36 claims: 36 hold, 0 fail, 0 are undecided".
std::string summary(const CampaignResult& result) {
  std::map<std::string, std::int64_t> number;
  for (const ClaimResult& c : result.claims) ++number[verdict(c)];
  std::string html = "<p class=\"summary\">" + counted(std::ssize(result.claims), "claim") + ": ";
  html += "<span class=\"holds\">" + counted(number["holds"], "holds", "hold") + "</span>";
  if (number["fails"] > 0) html += ", <span class=\"fails\">" + counted(number["fails"], "fails", "fail") + "</span>";
  if (number["undecided"] > 0)
    html += ", <span class=\"undecided\">" + counted(number["undecided"], "is undecided", "are undecided") + "</span>";
  return html + ".</p>\n";
}

// In one line, so that it can be left out where two reports are compared.
std::string run_html(const RunDescription& run) {
  if (run.version.empty()) return "";
  return "<dl id=\"run\"><dt>version</dt><dd>" + escaped(run.version) + "</dd><dt>date</dt><dd>" + escaped(run.date) +
         "</dd><dt>command</dt><dd><code>" + escaped(run.command) + "</code></dd><dt>machine</dt><dd>" +
         escaped(run.machine) + "</dd><dt>took</dt><dd>" + seconds_text(run.seconds) + "</dd></dl>\n";
}

std::string contents(const CampaignResult& result) {
  std::string html = "<nav aria-label=\"claims\">\n";
  for (const ClaimResult& c : result.claims)
    html += std::string("<a class=\"") + verdict(c) + "\" href=\"#" + c.claim->id + "\">" + c.claim->id + "</a>\n";
  return html + "<a href=\"#errata\">errata</a>\n<a href=\"#sentences\">sentences</a>\n</nav>\n";
}

// The graphs of the theorems that are among the claims.
std::string graphs_html(const CampaignResult& result) {
  std::string html;
  for (const auto& [id, type] : {std::pair{"T2", theory::kDigon}, {"T3", theory::kHexagon}, {"T4", theory::kQuad}}) {
    const auto is_it = [id = id](const ClaimResult& c) { return c.claim->id == id; };
    const auto c = std::find_if(result.claims.begin(), result.claims.end(), is_it);
    if (c == result.claims.end()) continue;
    html += "<h3><a href=\"#" + std::string(id) + "\">" + escaped(c->claim->where) + "</a>: a " + type.name() +
            " pair</h3>\n" + figure(graph_picture(type)) + "\n";
  }
  if (html.empty()) return "";
  return "<section>\n<h2>Configurations and moves</h2>\n" +
         paragraph(
             "A configuration is a mesh of quads that fills a given boundary and holds a pair of irregular vertices: "
             "two "
             "vertices inside where 3 or 5 quads meet in place of 4. A pair move changes one configuration into "
             "another "
             "one. Theorems 7.2 to 7.4 say which configurations there are and which moves join them. The small regions "
             "below show it. Every mesh and every line was found by making moves.") +
         html + "</section>\n";
}

std::string methods_html(const CampaignResult& result) {
  std::set<Method> used;
  for (const ClaimResult& c : result.claims) used.insert(c.methods.begin(), c.methods.end());
  if (used.empty()) return "";
  std::string html = "<section>\n<h2>How configurations are found</h2>\n<dl class=\"methods\">\n";
  for (const Method method : used) html += term(name(method), explanation(method));
  return html + "</dl>\n" + paragraph("The theory predicts, these methods find, and the checks compare the two.") +
         "<div id=\"times\">" + figure(times_picture(result)) + "</div>\n</section>\n";
}

std::string regions_html(const CampaignResult& result, const Ranges& ranges) {
  if (result.regions.empty()) return "";
  const bool searched = std::any_of(result.regions.begin(), result.regions.end(),
                                    [](const auto& entry) { return entry.second.searched > 0; });
  std::string html =
      "<section>\n<h2>The regions</h2>\n" +
      paragraph(std::string("The claims are checked on every convex region of these sizes, each once up to rotation.") +
                (searched ? " The search fills its boundary in every possible way. In an empty region it finds no "
                            "filling, so that moves have nothing to start from."
                          : "")) +
      "<div class=\"cards\">\n";
  for (const auto& [family, total] : result.regions) {
    const Picture picture = family_picture(family);
    html += "<figure>" + picture.svg + "<figcaption><strong>" + escaped(range_text(ranges, family)) + "</strong><br>" +
            grouped(total.regions) + (total.regions == 1 ? " region" : " regions");
    if (total.searched > 0)
      html += ", " + grouped(total.searched) + " searched, " + grouped(total.empty) + " of these empty";
    html += "<br><span class=\"soft\">" + escaped(picture.caption) + "</span></figcaption></figure>\n";
  }
  html += "</div>\n";
  if (const Picture counts = counts_picture(result); !counts.svg.empty()) html += figure(counts) + "\n";
  return html + "</section>\n";
}

std::string overview_html(const CampaignResult& result) {
  std::string html =
      "<section>\n<h2>The claims</h2>\n" +
      paragraph(
          "A comparison is one fact that is checked: a configuration that was predicted with one that was found, "
          "a move with what a theorem says of it, and so on.") +
      "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"all claims\"><table class=\"overview\">\n"
      "<thead><tr><th class=\"words\" scope=\"col\">claim</th><th class=\"words\" scope=\"col\">in the paper</th>"
      "<th class=\"words\" scope=\"col\">verdict</th>"
      "<th scope=\"col\">regions</th><th scope=\"col\">comparisons</th></tr></thead>\n<tbody>\n";
  for (const ClaimResult& c : result.claims) {
    html += "<tr><td class=\"words\"><a href=\"#" + c.claim->id + "\">" + c.claim->id +
            "</a></td><td class=\"words\">" + escaped(c.claim->where) + "</td><td class=\"words\">" +
            verdict_mark(verdict(c)) + "</td><td>" + grouped(c.instances) + "</td><td>" + grouped(checks_of(c)) +
            "</td></tr>\n";
  }
  return html + "</tbody></table></div>\n</section>\n";
}

std::string violation_html(const ClaimResult& c) {
  const std::string region = c.violating_region ? describe(*c.violating_region) + " " : "";
  std::string html = "<p class=\"fails\">Violated by: " + escaped(region + c.violation->configuration) + " " +
                     escaped(c.violation->move) + ": " + escaped(c.violation->what);
  if (!c.predicted.empty()) html += "<br>Predicted: " + escaped(c.predicted) + "<br>Found: " + escaped(c.found);
  return html + "</p>\n";
}

std::string claim_html(const ClaimResult& c, const ordered_json& totals, const Ranges& ranges) {
  const Claim& claim = *c.claim;
  std::string methods;
  for (const Method method : c.methods) methods += (methods.empty() ? "" : ", ") + std::string(name(method));
  std::string html = "<section>\n<h2 id=\"" + claim.id + "\">" + claim.id + " <span class=\"where\">" +
                     escaped(claim.where) + "</span> " + verdict_mark(verdict(c)) + "</h2>\n<p class=\"statement\">" +
                     escaped(claim.statement) + "</p>\n<dl>\n" + term("compared", claim.compares) +
                     term("fails if", claim.fails_if) + term("found by", methods) +
                     term("regions", range_text(ranges, claim.families)) + "</dl>\n";
  if (c.violation) html += violation_html(c);
  if (c.proof) html += html_proof(*c.proof);
  if (!totals.empty()) html += html_table(claim.id, totals);
  if (!c.table.empty())
    html += "<details class=\"rows\"><summary>Region by region</summary>\n" + html_table(claim.id, c.table) +
            "</details>\n";
  return html + "</section>\n";
}

std::string errata_html() {
  std::string html =
      "<section>\n<h2 id=\"errata\">Errata</h2>\n" +
      paragraph("Slips in the text that the program found, each with the smallest region that shows it.");
  for (const Erratum& e : find_errata()) {
    html += "<h3>" + escaped(e.where) + "</h3>\n<dl>\n" + term("written", e.written) + term("found", e.found) +
            term("shown by", e.instance) + "</dl>\n";
  }
  return html + "</section>\n";
}

std::string sentences_html() {
  std::string html = "<section>\n<h2 id=\"sentences\">Sentences without a check</h2>\n" +
                     paragraph("What the paper says and no check can decide, each with the reason.");
  for (const UndecidedSentence& s : undecided_sentences())
    html +=
        "<h3>" + escaped(s.where) + "</h3>\n<dl>\n" + term("says", s.sentence) + term("reason", s.reason) + "</dl>\n";
  return html + "</section>\n";
}

}  // namespace

std::string report_html(const CampaignResult& result, const Ranges& ranges, const RunDescription& run) {
  std::string html = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>requad: the claims, one by one</title>
<style>
)" + std::string(kReportStyle) +
                     R"(</style>
</head>
<body>
<header>
<h1>The claims, one by one</h1>
<p>Peng, Zhang, Kobayashi and Wonka, <em>Connectivity Editing for Quadrilateral Meshes</em> (2011), checked by computer
on real meshes.</p>
)";
  html += summary(result) + run_html(run) + contents(result) + "</header>\n<main>\n";
  html += graphs_html(result) + methods_html(result) + regions_html(result, ranges) + overview_html(result);
  for (const ClaimResult& c : result.claims) html += claim_html(c, totals_json(c), ranges);
  html += errata_html() + sentences_html();
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace requad::verify
