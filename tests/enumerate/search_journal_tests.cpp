// Searches that are stopped and continued. They find the same as one run, whenever and however often they are stopped.
#include "enumerate/search/search.hpp"
#include "enumerate/search/spheres.hpp"
#include "mesh/program/run/errors.hpp"
#include "mesh/program/run/journal_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/sanitizers.hpp"

using namespace requad;
using namespace requad::enumerate;
using program::JournalFile;
using tests::call;
using tests::line_count;
using tests::scratch;
using tests::slurp;
using tests::spill;

namespace {

// Limits without any time: a search with these stops each time it looks at the clock.
SearchLimits hurried(int threads) {
  SearchLimits limits;
  limits.threads = threads;
  limits.seconds = 0;
  return limits;
}

// A journal of "a run", to which a search appends each time it looks at the clock.
SearchJournal journal_at(const std::string& name) { return {(scratch() / name).string(), "a run", 0}; }

void append(const SearchJournal& journal, const JournalFile::Record& record) {
  JournalFile(journal.path, "requad-enumerate", journal.run, [](const JournalFile::Record&) {}).append(record);
}

void check_same(const CountedSearch& a, const CountedSearch& b) {
  CHECK(a.outcome.complete() == b.outcome.complete());
  CHECK(a.outcome.count == b.outcome.count);
  CHECK(a.outcome.by_faces == b.outcome.by_faces);
  CHECK(a.outcome.states == b.outcome.states);
  CHECK(a.outcome.face_limit_cut == b.outcome.face_limit_cut);
  CHECK(a.orbits.rotations == b.orbits.rotations);
  CHECK(a.orbits.reflections == b.orbits.reflections);
  CHECK(a.signatures == b.signatures);
}

// The record of a search that found nothing and has this left.
JournalFile::Record nothing_found(const JournalFile::Record& left) {
  const auto none = JournalFile::Record::array();
  return {
      {"found", {{"count", 0}, {"by_faces", none}, {"symmetries", {1, 1}}, {"fixing", {0, 0}}, {"signatures", none}}},
      {"states", 0},
      {"face_limit_cut", false},
      {"left", left}};
}

// The message by which the journal of a search is refused; "" if it is accepted.
std::string refusal(const SearchProblem& problem, const SearchJournal& journal) {
  try {
    count_fillings(problem, {}, false, journal);
    return "";
  } catch (const program::UsageError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a search that stops again and again finds the same as one run", "[search][journal]") {
  struct Case {
    SearchProblem problem;
    std::optional<int> faces;
  };
  const std::vector<Case> cases{{search_problem({8, 8, 8}, {3, 3, 5}), {}},
                                {search_problem({9, 9}, {3, 3}), {}},
                                {search_problem({6, 6, 6, 6, 6, 6}, {5, 5}), {}},
                                {{std::vector<int>(8, 2), {3, 3, 3, 3}}, 30},
                                {search_problem({6, 6, 6}, {3, 3}), {}}};  // the first hole cannot be filled
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SearchLimits limits;
    limits.faces = cases[i].faces;
    const CountedSearch at_once = count_fillings(cases[i].problem, limits, true);
    for (const int threads : {1, 2, 5}) {
      CAPTURE(i, threads);
      SearchLimits cut = hurried(threads);
      cut.faces = cases[i].faces;
      const SearchJournal journal = journal_at("cut-" + std::to_string(i) + "-" + std::to_string(threads));
      int runs = 0;
      CountedSearch found;
      do {
        found = count_fillings(cases[i].problem, cut, true, journal);
        REQUIRE(found.outcome.count <= at_once.outcome.count);
        REQUIRE(++runs < 10'000);
      } while (found.outcome.out_of_time);
      check_same(found, at_once);
      CHECK((at_once.outcome.states < 20'000 || runs > 5));
      // In another run, nothing is left and nothing is written.
      const std::string whole = slurp(journal.path);
      check_same(count_fillings(cases[i].problem, limits, true, journal), at_once);
      CHECK(slurp(journal.path) == whole);
    }
  }
}

TEST_CASE("a search for spheres that stops again and again finds the same as one run", "[search][journal]") {
  const std::vector<int> irregular{3, 3, 3, 3, 3, 3, 3, 3, 3, 5};
  const SphereOutcome at_once = search_spheres(irregular, 17, {});
  CHECK(at_once.oriented_counts != at_once.counts);
  for (const int threads : {1, 3}) {
    const SearchJournal journal = journal_at("spheres-" + std::to_string(threads));
    int runs = 0;
    SphereOutcome found;
    do {
      found = search_spheres(irregular, 17, hurried(threads), journal);
      REQUIRE(++runs < 10'000);
    } while (!found.complete);
    CHECK(runs > 5);
    CHECK(found.counts == at_once.counts);
    CHECK(found.oriented_counts == at_once.oriented_counts);
    CHECK(found.signatures == at_once.signatures);
    CHECK(found.states == at_once.states);
  }
}

TEST_CASE("a search continues from a journal that is cut anywhere", "[search][journal]") {
  const SearchProblem problem = search_problem({6, 6, 6}, {3, 3, 5});
  const CountedSearch at_once = count_fillings(problem, {}, true);
  SearchLimits two;
  two.threads = 2;
  const SearchJournal journal = journal_at("torn");
  check_same(count_fillings(problem, two, true, journal), at_once);
  const std::string whole = slurp(journal.path);
  REQUIRE(line_count(whole) > 5);
  // A last record without findings changes nothing.
  append(journal, nothing_found(JournalFile::Record::array()));
  check_same(count_fillings(problem, two, true, journal), at_once);
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 50) {
    CAPTURE(size);
    spill(journal.path, whole.substr(0, size));
    check_same(count_fillings(problem, two, true, journal), at_once);
  }
}

TEST_CASE("a search's journal with impossible records is refused", "[search][journal]") {
  using Record = JournalFile::Record;
  const SearchProblem problem = search_problem({6, 6, 6}, {3, 3, 5});
  const SearchJournal journal = journal_at("false");
  const Record good = nothing_found(Record::array({Record::array({0, 1})}));
  const auto refused = [&](const std::string& place, const std::string& value) {
    spill(journal.path, "");
    Record record = good;
    if (!place.empty()) record[Record::json_pointer(place)] = Record::parse(value);
    append(journal, record);
    const std::string before = slurp(journal.path);
    const std::string why = refusal(problem, journal);
    if (!why.empty()) CHECK(slurp(journal.path) == before);
    return why;
  };
  CHECK(refused("", "") == "");
  const std::string prefix = "--journal: " + journal.path + ": ";
  for (const auto& [place, value] :
       std::vector<std::pair<std::string, std::string>>{{"/states", "-1"},
                                                        {"/states", "1e3"},
                                                        {"/states", "18446744073709551615"},
                                                        {"/face_limit_cut", "1"},
                                                        {"/left", "[[0,2147483648]]"},
                                                        {"/left", "[0]"},
                                                        {"/left/0/1", "0.5"},
                                                        {"/found", "[]"},
                                                        {"/found/count", "-1"},
                                                        {"/found/by_faces", "[[0,1]]"},
                                                        {"/found/by_faces", "[[7]]"},
                                                        {"/found/by_faces", "[[7,9223372036854775807],[7,1]]"},
                                                        {"/found/symmetries", "[0,1]"},
                                                        {"/found/symmetries/1", "null"},
                                                        {"/found/fixing", "[0]"},
                                                        {"/found/signatures", "[7]"},
                                                        {"/found/signatures", "\"x\""}}) {
    CAPTURE(place, value);
    CHECK(refused(place, value).starts_with(prefix + "line 2: it is no record: "));
  }
  // Refused are a start other than 0, a guiding path of even length, a placement that was not listed, and more untried
  // placements than there were.
  for (const char* left :
       {"[[]]", "[[1,1]]", "[[0]]", "[[0,0,1]]", "[[0,1000]]", "[[0,1000,0,0]]", "[[0,0,1,0]]", "[[0,0,0,1000]]"}) {
    CAPTURE(left);
    CHECK(refused("/left", left).starts_with(prefix + "what is left in the last line is nothing of this search: "));
  }
  CHECK(refusal(problem, {journal.path, "another run"}) == prefix + "line 1: it belongs to another run: a run");
  // Found spheres must be signatures.
  spill(journal.path, "");
  append(journal, {{"found", {"no signature"}}, {"states", 0}, {"face_limit_cut", false}, {"left", Record::array()}});
  CHECK_THROWS_AS(search_spheres(std::vector<int>(8, 3), 10, {}, journal), program::UsageError);
}

TEST_CASE("the same command continues a search that was killed", "[search][journal]") {
  // This search is slow enough to be killed twice.
  const std::string sides = tests::kSanitized ? "12,12,12" : "14,14,14";
  const std::string run = "search --sides " + sides + " --irregular 3,3,5 --quiet ";
  const tests::Outcome at_once = call("enumerate", run + "--json search-at-once.json");
  REQUIRE(at_once.code == 0);
  for (const std::size_t lines : {std::size_t{2}, std::size_t{3}})
    CHECK(tests::killed_at_line("enumerate", run + "--threads 2 --journal killed-search.journal >/dev/null",
                                "killed-search.journal", lines));
  const tests::Outcome rest =
      call("enumerate", run + "--json search-rest.json --journal killed-search.journal --threads 1");
  CHECK(rest.code == 0);
  CHECK(rest.out == at_once.out);
  CHECK(slurp(scratch() / "search-rest.json") == slurp(scratch() / "search-at-once.json"));
  const tests::Outcome other = call("enumerate", run + "--max-faces 50 --journal killed-search.journal");
  CHECK(other.code == 2);
  CHECK(other.err.find("line 1: it belongs to another run: requad-enumerate 0.1.0 (build ") != std::string::npos);
  CHECK(other.err.ends_with(") search, sides " + sides + "; irregular 3,3,5\n"));
}
