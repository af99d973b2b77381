// The HTML report: its words, its tables and its pictures.
#include <algorithm>
#include <regex>

#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/verify/small_campaign.hpp"
#include "verify/report/html.hpp"
#include "verify/report/pictures.hpp"
#include "verify/report/report.hpp"
#include "verify/report/words.hpp"

using namespace requad;
using namespace requad::verify;
using namespace requad::tests;

namespace {

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

const CampaignResult& small_result() {
  static const CampaignResult kResult = run_small(2);
  return kResult;
}

ClaimResult& claim_of(CampaignResult& result, const std::string& id) {
  return *std::find_if(result.claims.begin(), result.claims.end(), [&](const auto& c) { return c.claim->id == id; });
}

}  // namespace

TEST_CASE("the HTML report has a section for each claim and is self-contained", "[verify][report]") {
  const std::string html = report_html(small_result(), small_ranges());
  for (const Claim& c : claims()) CHECK(html.find("<h2 id=\"" + c.id + "\">") != std::string::npos);
  for (const char* outside : {"http:", "https:", "<script", "<link rel=\"style", "src=", "@import", "url("})
    CHECK(html.find(outside) == std::string::npos);
  CHECK(html.find("</html>") != std::string::npos);
  // Three graphs, seven families, the counts and the times.
  CHECK(occurrences(html, "<svg ") == 12);
  CHECK(occurrences(html, "</svg>") == 12);
}

TEST_CASE("every column of every table has a heading in words", "[verify][report]") {
  const std::string html = report_html(small_result(), small_ranges());
  int columns = 0;
  const auto report = report_json(small_result(), small_ranges());
  for (const auto& c : report["claims"]) {
    for (const char* table : {"totals", "table"}) {
      for (const auto& row : c[table]) {
        for (const auto& [key, value] : row.items()) {
          CAPTURE(c["id"], key);
          const std::string words = heading(c["id"], key);
          CHECK(words.find('_') == std::string::npos);
          if (&row == &c[table].front()) CHECK(html.find(">" + words + "</th>") != std::string::npos);
          ++columns;
        }
      }
    }
  }
  CHECK(columns > 1000);
  // A table has the columns of all its rows: tau of regular regions, its bound of others.
  const std::string t2 =
      html.substr(html.find("<h2 id=\"T2\">"), html.find("<h2 id=\"T3\">") - html.find("<h2 id=\"T2\">"));
  CHECK(t2.find(">tau(L)</th>") != std::string::npos);
  CHECK(t2.find(">" + heading("T2", "bound") + "</th>") != std::string::npos);
  CHECK_THROWS_AS(heading("T2", "no such key"), std::out_of_range);
}

// By hand: the digon of side 4 has (1,1) and (2,0), twice joined, and the merged vertex, once joined to (1,1).
TEST_CASE("the edges that moves and the walk find can be compared", "[verify][report]") {
  const auto report = report_json(small_result(), small_ranges());
  int compared = 0, apart = 0;
  for (const auto& c : report["claims"]) {
    for (const auto& row : c["table"]) {
      if (!row.contains("walk_edges") || !row.contains("edges")) continue;
      CAPTURE(c["id"], row["sides"]);
      CHECK(row["edges_with_apex"] == row["walk_edges"]);
      apart += row["edges_with_apex"] == row["edges"] ? 0 : 1;
      ++compared;
      if (c["id"] == "T2" && row["sides"] == nlohmann::ordered_json{4, 4}) {
        CHECK(row["edges"] == 2);
        CHECK(row["edges_with_apex"] == 3);
      }
    }
  }
  CHECK(compared > 20);
  CHECK(apart > 3);
}

// By hand: Figure 10 for side 6, with (0,2) and (0,4) drawn twice; tau(5) = 12 and K = 12 (Theorems 7.3 and 7.4), with
// the edges that the tests of the claims have.
TEST_CASE("the pictures of the theorems show each configuration and each move", "[verify][report]") {
  const std::string digon = graph_picture(theory::kDigon).svg;
  CHECK(occurrences(digon, "<g class=\"node\">") == 7);
  CHECK(occurrences(digon, "<g class=\"node copy\">") == 2);
  CHECK(occurrences(digon, "class=\"line\"") == 10);
  CHECK(digon.find(">(0,4) = (4,0)<") != std::string::npos);
  CHECK(occurrences(digon, "class=\"vertex v3\"") == 16);
  CHECK(occurrences(digon, "class=\"vertex v2\"") == 1);
  const std::string hexagon = graph_picture(theory::kHexagon).svg;
  CHECK(occurrences(hexagon, "<g class=\"node\">") == 12);
  CHECK(occurrences(hexagon, "class=\"line\"") == 18);
  CHECK(occurrences(hexagon, "class=\"vertex v5\"") == 24);
  const std::string quad = graph_picture(theory::kQuad).svg;
  CHECK(occurrences(quad, "<g class=\"node\">") == 12);
  CHECK(occurrences(quad, "class=\"line\"") == 17);
  CHECK(occurrences(quad, "class=\"vertex v3\"") == 12);
  CHECK(occurrences(quad, "class=\"vertex v5\"") == 12);
}

TEST_CASE("each family is shown with its irregular vertices", "[verify][report]") {
  const auto marks = [](Family family) {
    const Picture picture = family_picture(family);
    CHECK(!picture.caption.empty());
    std::string found;
    for (const char* valence : {"v2", "v3", "v5", "v6"})
      for (std::size_t i = 0; i < occurrences(picture.svg, std::string("class=\"vertex ") + valence + "\""); ++i)
        found += valence;
    return found;
  };
  CHECK(marks(Family::regular_digon) == "v3v3");
  CHECK(marks(Family::other_digon) == "v3v3");
  CHECK(marks(Family::regular_hexagon) == "v5v5");
  CHECK(marks(Family::other_hexagon) == "v5v5");
  CHECK(marks(Family::quad) == "v3v5");
  CHECK(marks(Family::single_vertex) == "v5");
  CHECK(marks(Family::three_vertices) == "v3v3v5");
}

TEST_CASE("the plot of counts has a mark for each number that a method found", "[verify][report]") {
  CampaignResult result = small_result();
  const Picture right = counts_picture(result);
  const int regions = static_cast<int>(small_ranges().digon.last + small_ranges().hexagon.last) - 4;
  const std::string all = std::to_string(3 * regions);
  CHECK(right.caption.find(all + " of " + all + " marks lie on the lines.") != std::string::npos);
  // The legend has three marks more: a square, a ring and a dot.
  CHECK(occurrences(right.svg, "class=\"mark") == static_cast<std::size_t>(3 * regions + 3));
  auto& row = claim_of(result, "T2").table.at(2);
  row["search"] = row["search"].get<int>() + 1;
  const Picture wrong = counts_picture(result);
  CHECK(wrong.caption.find(std::to_string(3 * regions - 1) + " of " + all + " marks") != std::string::npos);
  CHECK(wrong.svg != right.svg);
  std::erase_if(result.claims, [](const auto& c) { return c.claim->id == "T2" || c.claim->id == "T3"; });
  CHECK(counts_picture(result).svg.empty());
}

TEST_CASE("the times of methods are measured and shown", "[verify][report]") {
  const auto& seconds = small_result().method_seconds;
  REQUIRE(seconds.size() == 3);
  double sum = 0;
  for (const auto& [method, time] : seconds) {
    CHECK(time > 0);
    sum += time;
  }
  CHECK(sum <= small_result().study_seconds);
  const std::string svg = times_picture(small_result()).svg;
  for (const char* name : {">moves<", ">search<", ">walk<", ">comparisons<", ">predictions<"})
    CHECK(svg.find(name) != std::string::npos);
}

TEST_CASE("the HTML report says what was run, when, and on what", "[verify][report]") {
  const char* const words[] = {"requad-verify", "--claim", "T2", "--html", "it's here/r.html", ""};
  CHECK(command_line(6, words) == "requad-verify --claim T2 --html 'it'\\''s here/r.html' ''");
  const Outcome done = call("verify", "--claim T2 --digon 3..5 --other-perimeter 4..8 --quiet --html run.html");
  REQUIRE(done.code == 0);
  const std::string html = slurp(scratch() / "run.html");
  std::smatch run;
  REQUIRE(std::regex_search(html, run, std::regex("<dl id=\"run\">.*</dl>")));
  const std::string line = run.str();
  for (const char* part : {" --claim T2 --digon 3..5 --other-perimeter 4..8 --quiet --html run.html</code>", "(build "})
    CHECK(line.find(part) != std::string::npos);
  CHECK(std::regex_search(line,
                          std::regex("<dt>date</dt><dd>20[0-9]{2}-[01][0-9]-[0-3][0-9] [0-2][0-9]:[0-5][0-9] UTC<")));
  CHECK(std::regex_search(line, std::regex("<dt>machine</dt><dd>Linux .*[0-9]+ cores?, [0-9]+ GB<")));
  CHECK(std::regex_search(line, std::regex("<dt>took</dt><dd>(under )?[0-9.]+ s<")));
  CHECK(html.find("<dt>walk</dt>") != std::string::npos);
}
