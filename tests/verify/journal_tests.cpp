// Journals: a run continues from what a killed run leaves. Nothing is lost, counted twice or taken from another run.
// Also reports, which do not depend on the number of threads.
#include <filesystem>
#include <fstream>
#include <regex>

#include <sys/stat.h>

#include "mesh/program/run/errors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/sanitizers.hpp"
#include "verify/report/report.hpp"

using namespace requad;
using namespace requad::verify;
using namespace requad::tests;

namespace {

std::string without_seconds(const std::string& json) {
  return std::regex_replace(json, std::regex("\"seconds\":[^,}]*"), "\"seconds\":0");
}

CaseResult some_result(int number) {
  CaseResult r;
  r.judgements.resize(1);
  r.judgements[0].claim = 1;
  r.judgements[0].seconds = 0.25;
  r.fillings = number;
  r.study_seconds = 1;
  r.method_seconds = {{Method::moves, 0.25}, {Method::walk, 0.5}};
  r.judgements[0].judgement.checks = number;
  r.judgements[0].judgement.row = {{"sides", {number, 2}}, {"text", "a \"b\"\n"}};
  return r;
}

// The message by which the journal is refused; "" if it is opened.
std::string refusal(const std::string& path, const std::string& run, std::size_t cases = 10) {
  try {
    Journal journal(path, run, cases, 2);
    return "";
  } catch (const program::UsageError& error) {
    return error.what();
  }
}

// The arguments of a run that is slow enough to be killed.
const std::string kRun =
    tests::kSanitized
        ? "--claim T2 --claim T4 --claim M1 --digon 3..11 --quad-perimeter 8..14 --other-perimeter 4..10 --quiet "
        : "--claim T2 --claim T4 --claim M1 --digon 3..16 --quad-perimeter 8..16 --other-perimeter 4..12 --quiet ";

}  // namespace

TEST_CASE("JSON gives results back unchanged", "[journal]") {
  CaseResult r = some_result(7);
  r.judgements[0].judgement.violation = Violation{"what", "(1,2)", "open", tests::grid(3, 2)};
  r.judgements[0].judgement.predicted = "6 configurations";
  r.judgements[0].judgement.found = "5 configurations";
  const CaseResult back = case_result(nlohmann::ordered_json::parse(to_json(r).dump()), 2);
  REQUIRE(back.judgements.size() == 1);
  CHECK(back.judgements[0].claim == 1);
  CHECK(back.judgements[0].seconds == 0.25);
  CHECK(back.method_seconds == r.method_seconds);
  CHECK(back.fillings == 7);
  CHECK(back.judgements[0].judgement.row.dump() == r.judgements[0].judgement.row.dump());
  CHECK(back.judgements[0].judgement.checks == 7);
  CHECK(back.judgements[0].judgement.violation->what == "what");
  CHECK(back.judgements[0].judgement.violation->configuration == "(1,2)");
  CHECK(back.judgements[0].judgement.violation->move == "open");
  CHECK(back.judgements[0].judgement.predicted == "6 configurations");
  CHECK(back.judgements[0].judgement.found == "5 configurations");
  CHECK(back.judgements[0].judgement.violation->mesh->mesh == tests::grid(3, 2).mesh);
  CHECK(back.judgements[0].judgement.violation->mesh->root == tests::grid(3, 2).root);
  CHECK_THROWS(case_result(to_json(r), 1));
  r.fillings.reset();
  CHECK_FALSE(case_result(to_json(r), 2).fillings.has_value());
  r.judgements.push_back(r.judgements[0]);
  CHECK_THROWS(case_result(to_json(r), 2));  // one claim twice
}

TEST_CASE("JSON that is no result is refused, at a cost bounded by its size", "[journal]") {
  using nlohmann::ordered_json;
  CaseResult r = some_result(7);
  r.judgements[0].judgement.violation = Violation{"what", "(1,2)", "open", tests::grid(3, 2)};
  const ordered_json good = to_json(r);
  REQUIRE_NOTHROW(case_result(good, 2));
  const std::string mesh = "/claims/0/violation/mesh";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"/claims/0/claim", "2"},   {"/claims/0/claim", "-1"},      {"/claims/0/claim", "0.5"},
      {"/claims/0/checks", "-1"}, {"/claims/0/checks", "1e300"},  {"/claims/0/checks", "18446744073709551615"},
      {mesh + "/root", "24"},     {mesh + "/root", "-1"},         {mesh + "/root", "4294967296"},
      {mesh + "/vertices", "13"}, {mesh + "/vertices", "-1"},     {mesh + "/vertices", "2147483647"},
      {mesh + "/faces/0", "[]"},  {mesh + "/faces/0/0", "-1"},    {mesh + "/faces/0/0", "4294967296"},
      {mesh + "/faces", "7"},     {mesh + "/faces/0", "[0,1,2]"}, {mesh + "/faces/0", "[0,1,2,3,4]"}};
  for (const auto& [place, value] : cases) {
    INFO(place << ": " << value);
    ordered_json bad = good;
    bad[ordered_json::json_pointer(place)] = ordered_json::parse(value);
    CHECK_THROWS(case_result(bad, 2));
  }
}

TEST_CASE("a journal keeps whole lines, drops a torn one, and knows its run", "[journal]") {
  const std::string path = (scratch() / "unit.journal").string();
  {
    Journal journal(path, "run a", 10, 2);
    CHECK(journal.results().empty());
    journal.append(3, some_result(3));
    journal.append(0, some_result(0));
    CHECK(refusal(path, "run a") == "--journal: " + path + ": is in use by another run");
  }
  const std::string whole = slurp(path);
  CHECK(line_count(whole) == 3);
  {
    Journal journal(path, "run a", 10, 2);
    CHECK(journal.results().size() == 2);
    CHECK(journal.results().at(3).judgements[0].judgement.checks == 3);
  }
  CHECK(slurp(path) == whole);
  CHECK(refusal(path, "run b") == "--journal: " + path + ": line 1: it belongs to another run: run a");
  CHECK(slurp(path) == whole);
  CHECK(refusal(path, "run a", 2) == "--journal: " + path + ": line 2: there is no case 3");

  // If the journal is cut anywhere, whole lines stay and the rest is dropped. More results can be appended.
  for (std::size_t size = 0; size < whole.size(); ++size) {
    spill(path, whole.substr(0, size));
    const std::size_t kept = line_count(whole.substr(0, size));
    Journal journal(path, "run a", 10, 2);
    REQUIRE(journal.results().size() == (kept > 1 ? kept - 1 : 0));
    journal.append(7, some_result(7));
    REQUIRE(line_count(slurp(path)) == std::max<std::size_t>(kept, 1) + 1);
  }

  // A killed run does not leave damage before the end. So such a journal is refused.
  const std::size_t second = whole.find('\n') + 1;
  for (std::size_t at = 0; at < whole.rfind('\n', whole.size() - 2); at += 7) {
    std::string damaged = whole;
    damaged[at] = damaged[at] == 'x' ? 'y' : 'x';
    spill(path, damaged);
    REQUIRE_FALSE(refusal(path, "run a").empty());
    REQUIRE(slurp(path) == damaged);
  }
  spill(path, whole + whole.substr(second));
  CHECK(refusal(path, "run a") == "--journal: " + path + ": line 4: case 3 stands here twice");

  // The number of a case must be an integer. These checksums are right, but the numbers are not.
  for (const auto& [text, sum] :
       {std::pair{"{\"case\":1e20,\"result\":0}", "f9ee0582"}, std::pair{"{\"case\":-1,\"result\":0}", "a945e3da"}}) {
    spill(path, whole.substr(0, second) + sum + " " + text + "\n");
    CHECK(refusal(path, "run a").find("line 2: it is no record: no integer") != std::string::npos);
  }

  // Other files are refused and stay unchanged.
  for (const std::string text : {"x", "hello\n", "a\nb\n"}) {
    spill(path, text);
    CHECK(refusal(path, "run a") == "--journal: " + path + ": line 1: this is no journal of requad-verify");
    CHECK(slurp(path) == text);
  }
  CHECK(refusal(scratch().string(), "run a").find("cannot be opened") != std::string::npos);
  // A file without an end, and one that allows no seeking.
  CHECK(refusal("/dev/zero", "run a") == "--journal: /dev/zero: is no regular file");
  const std::string pipe = (scratch() / "pipe.journal").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(refusal(pipe, "run a") == "--journal: " + pipe + ": is no regular file");
}

TEST_CASE("a run that was killed continues where it stopped", "[journal]") {
  const Outcome at_once = call("verify", kRun + "--json at-once.json --threads 1");
  REQUIRE(at_once.code == 0);
  const Outcome two = call("verify", kRun + "--json two.json --threads 2");
  CHECK(two.code == 0);
  const std::string expected = without_seconds(slurp(scratch() / "at-once.json"));
  CHECK(without_seconds(slurp(scratch() / "two.json")) == expected);
  CHECK(expected.find("\"walk\":") != std::string::npos);
  CHECK(expected.find("\"methods\":[\"moves\",\"search\",\"walk\"]") != std::string::npos);

  const auto journal = scratch() / "killed.journal";
  for (const std::size_t lines : {std::size_t{4}, std::size_t{20}})
    CHECK(killed_at_line("verify", kRun + "--threads 2 --journal killed.journal", "killed.journal", lines));
  const std::size_t kept = line_count(slurp(journal));
  // A part of a line at the end looks like a torn one.
  std::ofstream(journal, std::ios::app) << slurp(journal).substr(0, 40);
  const Outcome rest = call("verify", kRun + "--json rest.json --journal killed.journal");
  REQUIRE(rest.code == 0);
  CHECK(without_seconds(slurp(scratch() / "rest.json")) == expected);
  const std::string full = slurp(journal);
  CHECK(line_count(full) > kept);
  // The journal is complete now. Another run studies nothing, and its report is the same.
  CHECK(call("verify", kRun + "--json again.json --journal killed.journal").code == 0);
  CHECK(slurp(journal) == full);
  CHECK(without_seconds(slurp(scratch() / "again.json")) == expected);

  // Another run's journal is refused in one line.
  const Outcome other = call("verify", kRun + "--method moves --journal killed.journal");
  CHECK(other.code == 2);
  CHECK(line_count(other.err) == 1);
  CHECK(other.err.find("line 1: it belongs to another run: requad-verify 0.1.0 (build ") != std::string::npos);
  CHECK(other.err.find(std::string(") claims T2 T4 M1; digon 3..") + (tests::kSanitized ? "11;" : "16;")) !=
        std::string::npos);
  CHECK(slurp(journal) == full);

  // So is another build's journal, even if the version is the same. This build has one byte more, which nothing reads.
  std::filesystem::copy_file(REQUAD_PROGRAM_DIR "/requad-verify", scratch() / "requad-verify");
  std::ofstream(scratch() / "requad-verify", std::ios::app) << '\n';
  const Outcome build = call("edit", "--version >/dev/null; ./requad-verify " + kRun + "--journal killed.journal");
  CHECK(build.code == 2);
  CHECK(build.err.find("line 1: it belongs to another run: requad-verify 0.1.0 (build ") != std::string::npos);
  CHECK(slurp(journal) == full);
}

TEST_CASE("a full disk ends a run with a journal, and another run continues it", "[journal]") {
  const Outcome at_once = call("verify", kRun + "--json at-once.json");
  REQUIRE(at_once.code == 0);
  // The size of files is limited to four blocks of the shell, each 512 bytes or 1 KiB.
  const Outcome full = call("edit", "--version >/dev/null; ulimit -f 4; '" REQUAD_PROGRAM_DIR "/requad-verify' " +
                                        kRun + "--threads 2 --journal full.journal");
  INFO(full.err);
  CHECK(full.code == 2);
  CHECK(line_count(full.err) == 1);
  CHECK(full.err.find("--journal: full.journal: cannot be written: File too large") != std::string::npos);
  const std::string kept = slurp(scratch() / "full.journal");
  CHECK(line_count(kept) > 3);
  CHECK(kept.ends_with('\n'));
  CHECK(kept.size() < 4096);
  const Outcome rest = call("verify", kRun + "--json rest.json --journal full.journal");
  CHECK(rest.code == 0);
  CHECK(slurp(scratch() / "full.journal").starts_with(kept));
  CHECK(without_seconds(slurp(scratch() / "rest.json")) == without_seconds(slurp(scratch() / "at-once.json")));
}

TEST_CASE("the walk alone verifies regions far beyond the reach of moves and search", "[journal]") {
  const int n = tests::kSanitized ? 30 : 75, m = tests::kSanitized ? 10 : 20;
  const Outcome made = call("verify", "--claim T2 --claim T3 --method walk --digon " + std::to_string(2 * n) +
                                          " --hexagon " + std::to_string(2 * m + 1) + " --other-perimeter 4 --json -");
  CHECK(made.code == 0);
  // Theorem 7.2 for L = 2 N: N (N - 1); Theorem 7.3 for L = 2 N + 1: 3 N^2.
  CHECK(made.out.find("\"walk\":" + std::to_string(n * (n - 1))) != std::string::npos);
  CHECK(made.out.find("\"walk\":" + std::to_string(3 * m * m)) != std::string::npos);
  CHECK(made.out.find("\"methods\":[\"walk\"]") != std::string::npos);
  CHECK(call("verify", "--claim T2 --digon 150").code == 2);
  CHECK(call("verify", "--claim T2 --method walk --digon 2001").code == 2);
}
