// Random changes to good command lines. Whatever the arguments, each program does what they say or refuses them in one
// line. Options are inserted that the program's own --help names.
#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/properties.hpp"
#include "tests/support/sanitizers.hpp"

using namespace requad;
using tests::scratch;
using tests::spill;
namespace fs = std::filesystem;

namespace {

using CommandLine = std::vector<std::string>;

struct FuzzedProgram {
  std::string name;
  std::vector<CommandLine> starts;
};
// Each of these command lines takes only a moment.
const std::vector<FuzzedProgram>& fuzzed_programs() {
  static const std::vector<FuzzedProgram> all{
      {"edit",
       {{"info", "in.obj"},
        {"info", "triangles.off", "--subdivide", "--json", "-"},
        {"smooth", "in.obj", "--feature-angle", "30", "--weights", "chord", "--iterations", "3", "--project", "-o",
         "out.obj"},
        {"subdivide", "triangles.off", "-o", "out.obj"},
        {"moves", "in.obj", "153", "163"},
        {"move", "in.obj", "153", "163", "--step", "slide_first", "-o", "out.obj"},
        {"cancel", "in.obj", "153", "163", "-o", "out.obj"},
        {"merge", "hexagon.obj", "1", "4", "-o", "out.obj"},
        {"align", "in.obj", "153", "366", "-o", "out.obj"},
        {"part", "in.obj", "-o", "out.obj"},
        {"reduce", "in.obj", "--until", "4", "--max-deviation", "0.01", "-o", "out.obj", "--script", "made.txt",
         "--map", "map.json"},
        {"atomic", "in.obj", "366"},
        {"atomic", "in.obj", "366", "149", "--make", "move-v3 flip left", "-o", "out.obj"},
        {"apply", "in.obj", "edits.txt", "-o", "out.obj"},
        {"apply", "less.obj", "edits.txt", "--undo", "-o", "out.obj"}}},
      {"enumerate",
       {{"region", "digon", "2", "1", "3,2", "-o", "out.obj"},
        {"region", "hexagon", "1", "2", "1,1,2,1,1,1", "--generator", "grow"},
        {"graph", "--sides", "5,5", "--pair", "3-3", "--format", "dot", "-o", "out.dot"},
        {"path", "--sides", "8,8", "--pair", "3-3", "--from", "1,1", "--to", "5,1", "-o", "out.obj"},
        {"search", "--sides", "4,4,4", "--irregular", "3,3,5", "--list", "--max-faces", "9"},
        {"search", "--interior-quads", "1,2,2,1,2,2", "--irregular", "3,3", "--journal", "run.journal",
         "--limit-seconds", "1"},
        {"sphere", "--irregular", "3,3,3,3,3,3,3,3", "--vertices", "8..10", "--list", "--journal", "run.journal"},
        {"signature", "in.obj"},
        {"signature", "--from-signature", "1111f13e3934", "--json", "-"}}},
      {"verify",
       {{"--claim", "T2", "--digon", "3..5", "--json", "report.json", "--threads", "2"},
        {"--claim", "T2", "--digon", "3..4", "--certificate", "proof"},
        {"--claim", "T4", "--claim", "N1", "--quad-perimeter", "8..10", "--method", "search", "--journal",
         "run.journal"},
        {"--claim", "T3", "--hexagon", "3..4", "--quiet"},
        {"--claim", "T3", "--proofs", "--quiet"},
        {"--list"},
        {"check", "proof"}}},
      {"figures",
       {{"--figure", "10", "--side", "5", "--format", "svg"},
        {"--figure", "hexagon", "--sides", "3,4,5,4,3,5", "--format", "dot", "-o", "."},
        {"--explorer", "--sides", "4,4", "--pair", "3-3", "-o", "out.html"}}}};
  return all;
}

const CommandLine& odd_words() {
  static const CommandLine all{"",
                               "0",
                               "1",
                               "2",
                               "3",
                               "6",
                               "-1",
                               "1.5",
                               "1e9",
                               "99999999999999999999",
                               "9223372036854775807",
                               "nan",
                               "2,2",
                               "4,4,4",
                               "3,,3",
                               "6,6,6,6,6,6",
                               "3..5",
                               "5..3",
                               "..",
                               "3-3",
                               "5-5",
                               "3-5",
                               "T2",
                               "walk",
                               "svg",
                               "-",
                               "--",
                               ".",
                               "in.obj",
                               "no.obj",
                               "run.journal",
                               "two words",
                               "'",
                               "\xff\xfe",
                               "line\nend",
                               "\n",
                               "in\n.obj",
                               "--sides=6\n,6",
                               "3\n",
                               "--json",
                               "-o",
                               "--help"};
  return all;
}

// A change to a command line: its kind, its place, and the new word. Any three numbers give a change.
using WordChange = std::tuple<unsigned, unsigned, unsigned>;

void change_by_chance(CommandLine& words, const WordChange& drawn, const CommandLine& options) {
  const auto [what, where, by] = drawn;
  const auto at = words.begin() + static_cast<std::ptrdiff_t>(where % (words.size() + 1));
  const std::string& odd = odd_words()[by % odd_words().size()];
  if (what % 6 == 0) {
    words.insert(at, odd);
  } else if (what % 6 == 1) {
    words.insert(at, options[by % options.size()]);
  } else if (at == words.end()) {
    return;
  } else if (what % 6 == 2) {
    words.erase(at);
  } else if (what % 6 == 3) {
    *at = odd;
  } else if (what % 6 == 4) {
    words.insert(at, *at);
  } else {
    std::iter_swap(at, words.begin() + static_cast<std::ptrdiff_t>(by % words.size()));
  }
}

std::string shell_quoted(const std::string& word) {
  return "'" + std::regex_replace(word, std::regex("'"), "'\\''") + "'";
}

std::string command_of(const std::string& program, const CommandLine& words) {
  std::string text = "requad-" + program;
  for (const std::string& word : words) text += " " + shell_quoted(word);
  return text;
}

CommandLine options_of(const std::string& program) {
  const std::string help = tests::call(program, "--help").out;
  const std::regex option("--[a-z][-a-z]*");
  std::set<std::string> names;
  for (std::sregex_iterator it(help.begin(), help.end(), option), end; it != end; ++it) names.insert(it->str());
  REQUIRE(names.size() > 5);
  return {names.begin(), names.end()};
}

// Makes a new folder with the files that the command lines name.
fs::path new_folder() {
  static const fs::path pattern = [] {
    const fs::path folder = scratch() / "pattern";
    fs::create_directory(folder);
    spill(folder / "in.obj", tests::slurp(REQUAD_SOURCE_DIR "/mesh/examples/figure-17.obj"));
    spill(folder / "triangles.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
    REQUIRE(tests::call("edit", "reduce pattern/in.obj -o pattern/less.obj --script pattern/edits.txt").code == 0);
    REQUIRE(tests::call("enumerate", "region hexagon 1 1 1,1,1,1,1,1 -o pattern/hexagon.obj").code == 0);
    REQUIRE(tests::call("verify", "--claim T2 --digon 3..4 --certificate pattern/proof").code == 0);
    return folder;
  }();
  const fs::path folder = scratch() / "command";
  fs::remove_all(folder);
  fs::copy(pattern, folder, fs::copy_options::recursive);
  return folder;
}

constexpr int kOutOfTime =
    128 + 24;  // SIGXCPU, at the soft limit of ten seconds; at a hard limit the signal would be SIGKILL

tests::Outcome run_in_new_folder(const std::string& command) {
  new_folder();
  spill(scratch() / "script",
        "cd command && ulimit -S -t 10 && exec '" REQUAD_PROGRAM_DIR "'/" + command + " </dev/null\n");
  return tests::call("edit", "--version >/dev/null; bash script");
}

// What is wrong with the end of a run and with the files that it left; "" if nothing is.
std::string ending_problem(const tests::Outcome& outcome) {
  if (outcome.code == kOutOfTime) return "";  // the arguments asked for long work
  if (outcome.code < 0 || outcome.code > 3) return "it ended by exit code " + std::to_string(outcome.code);
  if (outcome.err.find("internal error") != std::string::npos) return "an internal error";
  if (outcome.code == 2) {
    if (!outcome.err.starts_with("requad-") || tests::line_count(outcome.err) != 1)
      return "it is not refused in one line";
    if (!outcome.out.empty()) return "there is output, though it is refused";
  }
  static const std::regex temporary("\\.[A-Za-z0-9]{6}");
  for (const auto& entry : fs::recursive_directory_iterator(scratch() / "command")) {
    if (std::regex_match(entry.path().extension().string(), temporary))
      return "it left " + entry.path().filename().string();
  }
  return "";
}

}  // namespace

TEST_CASE("whatever the arguments, a program does what they say or refuses them in one line", "[properties][hostile]") {
  for (const FuzzedProgram& program : fuzzed_programs()) {
    for (const CommandLine& start : program.starts) {
      const std::string command = command_of(program.name, start);
      const tests::Outcome outcome = run_in_new_folder(command);
      INFO(command << ": exit code " << outcome.code << ", standard error: " << outcome.err);
      CHECK((outcome.code == 0 || outcome.code == 3));
      CHECK(ending_problem(outcome).empty());
    }
    const CommandLine options = options_of(program.name);
    int refused = 0, done = 0, out_of_time = 0;
    tests::holds(
        program.name + ": arguments changed by chance",
        [&] {
          CommandLine words = program.starts[*rc::gen::inRange(std::size_t{0}, program.starts.size())];
          const auto number = rc::gen::inRange(0U, 1U << 20);
          for (const WordChange& drawn :
               *rc::gen::resize(3, rc::gen::container<std::vector<WordChange>>(rc::gen::tuple(number, number, number))))
            change_by_chance(words, drawn, options);
          const std::string command = command_of(program.name, words);
          const tests::Outcome outcome = run_in_new_folder(command);
          ++(outcome.code == kOutOfTime ? out_of_time : outcome.code == 2 ? refused : done);
          const std::string problem = ending_problem(outcome);
          if (!problem.empty())
            RC_FAIL(command + "\n" + problem + "; exit code " + std::to_string(outcome.code) +
                    ", standard error: " + outcome.err);
        },
        tests::kSanitized ? 25 : 100);
    CAPTURE(program.name, refused, done, out_of_time);
    // Some command lines must be refused and some done, or little was tested.
    const int all = refused + done + out_of_time;
    CHECK(10 * refused > all);
    CHECK(10 * done > all);
    CHECK(20 * out_of_time < all);
  }
}
