// Help texts, and the table of commands from which they are made.
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "mesh/program/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/sanitizers.hpp"

using namespace requad;
using namespace requad::tests;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

const std::vector<std::string>& programs() {
  static const std::vector<std::string> all{"edit", "enumerate", "verify", "figures"};
  return all;
}

// The names of the commands that the help of a program lists.
std::vector<std::string> commands_of(const std::string& program) {
  std::vector<std::string> names;
  bool listed = false;
  const std::string start = "  requad-" + program + " ";
  for (const std::string& line : lines_of(call(program, "--help").out)) {
    if (line == "Commands:") listed = true;
    if (line.empty()) listed = false;
    if (!listed || line.rfind(start, 0) != 0) continue;
    const std::string name = line.substr(start.size(), line.find(' ', start.size()) - start.size());
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  return names;
}

// The help of a program and of each of its commands, by their names.
std::map<std::string, std::string> help_texts(const std::string& program) {
  std::map<std::string, std::string> texts{{program, call(program, "--help").out}};
  for (const std::string& command : commands_of(program))
    texts[program + " " + command] = call(program, command + " --help").out;
  return texts;
}

std::set<std::string> examples_of(const std::string& help) {
  std::set<std::string> examples;
  bool found = false;
  for (const std::string& line : lines_of(help)) {
    if (found && line.size() > 2) examples.insert(line.substr(2));
    if (line == "Examples:") found = true;
  }
  return examples;
}

// The command lines of a README that call the programs of build/, without the comments after them.
std::vector<std::string> commands_in(const std::string& readme) {
  std::vector<std::string> commands;
  for (std::string line : lines_of(slurp(std::filesystem::path(REQUAD_SOURCE_DIR) / readme))) {
    line = line.substr(0, line.find("  #"));
    line.erase(0, line.find_first_not_of(' '));
    line.erase(line.find_last_not_of(' ') + 1);
    if (!line.starts_with("build/requad-") || line.starts_with("build/requad-bench")) continue;
    for (std::size_t at = 0; (at = line.find("build/requad-", at)) != std::string::npos;) line.erase(at, 6);
    commands.push_back(line);
  }
  return commands;
}

// Runs command lines, each once, in a folder that has mesh/examples as the project's root has it.
class Examples {
 public:
  Examples() {
    std::filesystem::create_directories(scratch() / "examples");
    if (!std::filesystem::exists(scratch() / "examples/mesh"))
      std::filesystem::create_directory_symlink(REQUAD_SOURCE_DIR "/mesh", scratch() / "examples/mesh");
  }
  void run(const std::string& example) {
    // These take minutes, or need MPI.
    static const std::set<std::string> left_out{
        "requad-verify", "requad-verify --hexagon 3..15 --journal run.journal --json report.json",
        "mpirun -n 4 requad-verify --hexagon 3..15 --journal run.journal --json report.json"};
    if (left_out.count(example) > 0 || !done_.insert(example).second) return;
    spill(scratch() / "script", "cd examples && export PATH='" REQUAD_PROGRAM_DIR "':\"$PATH\" && " + example + "\n");
    const Outcome outcome = call("edit", "--version >/dev/null; timeout 100 bash script");
    INFO(example << "\n" << outcome.err);
    CHECK(outcome.code == 0);
  }
  std::size_t count() const { return done_.size(); }

 private:
  std::set<std::string> done_;
};

}  // namespace

TEST_CASE("every command has its own help, without wide lines and without repeated lines", "[programs]") {
  const std::map<std::string, std::size_t> counts{{"edit", 13}, {"enumerate", 8}, {"verify", 5}, {"figures", 1}};
  for (const std::string& program : programs()) {
    CHECK(commands_of(program).size() == counts.at(program));
    for (const auto& [called, help] : help_texts(program)) {
      INFO("requad-" << called << " --help\n" << help);
      CHECK(help.find("\nExit code: ") != std::string::npos);
      CHECK_FALSE(examples_of(help).empty());
      std::set<std::string> met;
      for (const std::string& line : lines_of(help)) {
        if (line.empty()) continue;
        CHECK(met.insert(line).second);
        const bool is_command = line.rfind("  requad-", 0) == 0 || line.rfind("  mpirun ", 0) == 0;
        if (!is_command) CHECK(line.size() <= 80);
        CHECK(line.back() != ' ');
      }
    }
  }
}

TEST_CASE("the examples of the help texts and of the READMEs work as printed", "[programs]") {
  Examples examples;
  for (const std::string& program : programs()) {
    if (tests::kSanitized && program != "edit") continue;  // the others would take minutes
    for (const auto& [called, help] : help_texts(program)) {
      for (const std::string& example : examples_of(help)) examples.run(example);
    }
  }
  CHECK(examples.count() > (tests::kSanitized ? 10 : 30));
  if (tests::kSanitized) return;
  // In the order of the file, for some read what others write.
  for (const char* readme : {"README.md", "verify/README.md", "mesh/irregular/README.md"}) {
    const std::vector<std::string> commands = commands_in(readme);
    if (readme == std::string("README.md")) CHECK(commands.size() >= 14);
    for (const std::string& command : commands) examples.run(command);
  }
}

TEST_CASE("an option that has no effect is refused", "[programs]") {
  CHECK(call("edit", "info a.obj --iterations 3").err ==
        "requad-edit: info: has no use for --iterations; see --help\n");
  CHECK(call("enumerate", "graph --sides 6,6 --pair 3-3 --from 1,1").err ==
        "requad-enumerate: graph: has no use for --from; see --help\n");
  CHECK(call("verify", "check proof --digon 3..4").err == "requad-verify: check: has no use for --digon; see --help\n");
  CHECK(call("verify", "--list --claim T2").err == "requad-verify: --list: has no use for --claim; see --help\n");
  CHECK(call("verify", "--list --proofs").code == 2);
  CHECK(call("verify", "--list --quiet --threads 1").code == 0);
  CHECK(call("verify", "--proofs --claim T2 --digon 3..4").err ==
        "requad-verify: --proofs: has no use for --digon; see --help\n");
  CHECK(call("verify", "--proofs --method walk").code == 2);
  CHECK(call("figures", "--pair 3-3").err == "requad-figures: there is no use for --pair; see --help\n");
  CHECK(call("figures", "--explorer --sides 6,6 --pair 3-3 --page").err ==
        "requad-figures: --explorer: has no use for --page; see --help\n");
  CHECK(call("edit", "info a.obj --dance").err == "requad-edit: unrecognised option '--dance'; see --help\n");
}

TEST_CASE("the value of an option is not taken for the name of a command", "[programs]") {
  const Outcome outcome = call("enumerate", "-o graph region digon 2 1 3,2");
  CHECK(outcome.code == 0);
  CHECK(std::filesystem::exists(scratch() / "graph"));
}

TEST_CASE("a command's help is made from its entry in the table", "[programs]") {
  const program::Command command{
      .name = "boil",
      .usage = {"EGG"},
      .summary = "boils an egg",
      .text = "The water should be hot.\n",
      .examples = {"cook boil egg.obj"},
      .options =
          {
              program::flag("soft", "stop early"),
              program::value("minutes,m", "N",
                             "how long; an egg that is boiled for a very long time is hard to eat "
                             "and to digest, and takes energy\n"
                             "  4   soft\n"
                             "  10  hard, and this entry goes on below its own first word, indented"),
              program::output("a-rather-long-name", "FILE", "where it goes"),
          },
      .words = {1, 1},
      .run = {},
  };
  const program::Program program{"cook", "1", "makes breakfast", "0 done", "EGG is fresh.\n", {command}};
  CHECK(program::command_help(program, command) == R"(cook boil: boils an egg

Usage:
  cook boil EGG

The water should be hot.

Options:
  --soft           stop early
  -m, --minutes N  how long; an egg that is boiled for a very long time is hard
                   to eat and to digest, and takes energy
                     4   soft
                     10  hard, and this entry goes on below its own first word,
                         indented
  --a-rather-long-name FILE
                   where it goes

EGG is fresh.

Common options: --json FILE|-  --threads N  --quiet  --force  --help  --version
Exit code: 0 done

Examples:
  cook boil egg.obj
)");
}
