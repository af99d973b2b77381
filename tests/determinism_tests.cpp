// The same input gives the same output, bit by bit: whatever the number of threads, the locale, the addresses of
// memory, what memory holds at first; and the build type, if REQUAD_OTHER_BUILD names the folder of another build of
// the same sources, as tests/run does.
#include <algorithm>
#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/programs.hpp"

using namespace requad;
namespace fs = std::filesystem;

namespace {

// Standard output and all that is left in the folder, less the seconds that a run took.
std::string outputs(const std::string& variant, const std::string& folder, const std::string& command) {
  const fs::path out = tests::scratch() / "out";
  fs::remove_all(out);
  fs::create_directory(out);
  const std::size_t blank = command.find(' ');
  tests::spill(tests::scratch() / "script", "cd out && " + variant + " '" + folder + "/requad-" +
                                                command.substr(0, blank) + "' " + command.substr(blank) + "\n");
  const tests::Outcome outcome = tests::call("edit", "--version >/dev/null; timeout 300 bash script");
  INFO(variant << " requad-" << command << ": " << outcome.err);
  CHECK(outcome.code == 0);
  std::string text = outcome.out;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) text += file.filename().string() + "\n" + tests::slurp(file);
  return std::regex_replace(text, std::regex("\"seconds\":[-+.e0-9]+"), "");
}

const std::vector<std::string> kDiscrete{
    "enumerate graph --sides 7,7 --pair 3-3 --json -",
    "enumerate graph --sides 5,5,5,5,5,5 --pair 5-5 --format dot -o found.dot --quiet",
    "enumerate search --sides 6,6,6 --irregular 3,3,5 --list",
    "enumerate search --sides 4,4,4,4 --irregular 3,5,3,5 --json -",
    "enumerate sphere --irregular 3,3,3,3,3,3,3,3 --vertices 8..14 --json -",
    "enumerate path --sides 8,8 --pair 3-3 --from 1,1 --to 5,1 -o path.obj",
    "verify --claim T2 --claim T4 --claim N1 --digon 3..5 --quad-perimeter 8..10 --json report.json --certificate "
    "proof >/dev/null",
    "figures --figure 10 --side 6 --format dot -o .",
};

}  // namespace

TEST_CASE("the same input gives the same output", "[determinism]") {
  // A mesh with something to reduce: a filling with three irregular vertices and its boundary.
  REQUIRE(tests::call("enumerate", "path --sides 8,8 --pair 3-3 --from 1,1 --to 5,1 -o '" +
                                       (tests::scratch() / "in.obj").string() + "'")
              .code == 0);
  std::vector<std::string> commands = kDiscrete;
  commands.push_back("edit smooth ../in.obj -o smooth.obj --json -");
  commands.push_back("edit reduce ../in.obj -o reduced.obj --script edits.txt");
  for (const std::string& command : commands) {
    INFO(command);
    const std::string expected = outputs("", REQUAD_PROGRAM_DIR, command);
    CHECK(expected.size() > 20);
    for (const char* variant :
         {"LC_ALL=C.UTF-8", "LC_ALL=de_DE.UTF-8", "MALLOC_PERTURB_=85", "setarch -R", "taskset 1"}) {
      INFO(variant);
      CHECK(outputs(variant, REQUAD_PROGRAM_DIR, command) == expected);
    }
    for (const char* threads : {" --threads 1", " --threads 3"}) {
      INFO(threads);
      CHECK(outputs("", REQUAD_PROGRAM_DIR, command + threads) == expected);
    }
  }
}

TEST_CASE("another build of the same sources gives the same output", "[determinism]") {
  const char* other = std::getenv("REQUAD_OTHER_BUILD");
  if (other == nullptr) {
    WARN("skipped: REQUAD_OTHER_BUILD is not set");
    return;
  }
  for (const std::string& command : kDiscrete) {
    INFO(command);
    CHECK(outputs("", REQUAD_PROGRAM_DIR, command) == outputs("", other, command));
  }
}
