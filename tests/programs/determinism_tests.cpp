// The same input gives the same output, bit by bit. Neither the number of threads, nor the locale, nor the addresses
// and first contents of memory may matter. The same holds for build type and compiler, which are tested if
// REQUAD_OTHER_BUILD names the folder of another build of the same sources, as in tests/run.
#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <locale>
#include <regex>
#include <string>
#include <vector>

#include "enumerate/generators.hpp"
#include "figures/graph_files.hpp"
#include "figures/pictures/grid_picture.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/files/read_polygons.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/irregular/pair_moves.hpp"
#include "mesh/pictures/page.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "verify/report/report.hpp"

using namespace requad;
namespace fs = std::filesystem;

namespace {

// A mesh that can be reduced. In the commands it is IN.
const std::string kIn = "'" REQUAD_SOURCE_DIR "/mesh/examples/figure-17.obj'";

// Standard output and all files in the folder, without the seconds that a run took.
std::string outputs(const std::string& variant, const std::string& folder, const std::string& command) {
  const fs::path out = tests::scratch() / "out";
  fs::remove_all(out);
  fs::create_directory(out);
  const std::size_t blank = command.find(' ');
  const std::string arguments = std::regex_replace(command.substr(blank), std::regex("\\bIN\\b"), kIn);
  tests::spill(tests::scratch() / "script", "cd out && " + variant + " '" + folder + "/requad-" +
                                                command.substr(0, blank) + "' " + arguments + "\n");
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

const std::vector<std::string> kCommands{
    "enumerate graph --sides 7,7 --pair 3-3 --json -",
    "enumerate graph --sides 5,5,5,5,5,5 --pair 5-5 --format dot -o found.dot --quiet",
    "enumerate search --sides 6,6,6 --irregular 3,3,5 --list",
    "enumerate search --sides 4,4,4,4 --irregular 3,5,3,5 --json -",
    "enumerate sphere --irregular 3,3,3,3,3,3,3,3 --vertices 8..14 --json -",
    "enumerate path --sides 8,8 --pair 3-3 --from 1,1 --to 5,1 -o path.obj",
    "verify --claim T2 --claim T4 --claim N1 --digon 3..5 --quad-perimeter 8..10 --json report.json --certificate "
    "proof >/dev/null",
    "figures --figure 10 --figure 8 --side 6 --format dot --format svg -o .",
    "edit smooth IN -o smooth.obj --iterations 20 --project --json -",
    "edit reduce IN -o reduced.obj --script edits.txt",
};

}  // namespace

namespace {

// Whether a variant is available here. For example, a container may not allow it. Warns if it is not.
bool is_available(const std::string& variant) {
  tests::spill(tests::scratch() / "script", variant + " true\n");
  if (tests::call("edit", "--version >/dev/null; bash script").code == 0) return true;
  WARN("skipped: " << variant << " is not available here");
  return false;
}

// The environment variables that make a program use decimal commas. If the system has no sources of locales, returns ""
// and warns.
std::string decimal_commas() {
  const std::string folder = (tests::scratch() / "locales").string();
  fs::create_directory(folder);
  tests::spill(tests::scratch() / "script", "localedef -i de_DE -f UTF-8 '" + folder +
                                                "/de_DE.UTF-8' 2>/dev/null && LOCPATH='" + folder +
                                                "' LC_ALL=de_DE.UTF-8 /usr/bin/printf %.1f 1,5\n");
  if (tests::call("edit", "--version >/dev/null; bash script").out == "1,5")
    return "LOCPATH='" + folder + "' LC_ALL=de_DE.UTF-8";
  WARN("skipped: there is no locale with decimal commas here; the package locales has the sources");
  return "";
}

// The numerals of a locale that a user's program may have set.
class Commas : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\1"; }
};

}  // namespace

TEST_CASE("no text of the libraries depends on the locale that a program has set", "[determinism]") {
  const auto all = [] {
    const theory::PairType type = theory::kDigon;
    const mesh::Region region =
        enumerate::glue_region(type, theory::parameter_set({type, theory::to_vector({12, 12})}).front());
    verify::Ranges ranges;
    ranges.digon = {3, 12};
    const verify::Claim& claim =
        *std::find_if(verify::claims().begin(), verify::claims().end(), [](const auto& c) { return c.id == "T2"; });
    const auto result = verify::run_campaign({&claim}, verify::list_cases(ranges, claim.families),
                                             {verify::Method::moves}, {.threads = 1, .quiet = true});
    const figures::GridFigure figure = figures::figure_10(12);
    const mesh::Surface surface = mesh::to_quad_mesh(mesh::parse_obj(mesh::obj_text(region), "a region"));
    mesh::QuadMesh m = surface.mesh;
    mesh::Positions positions = surface.positions;
    mesh::Editor editor(m, nullptr, &positions);
    const auto irregular = mesh::irregular_vertices(m);
    REQUIRE(mesh::move_pair(editor, mesh::pair_moves(m, irregular.at(0), irregular.at(1)).at(0)).refusal ==
            mesh::Refusal::none);
    return std::vector<std::string>{
        mesh::obj_text(m, positions), mesh::to_string(mesh::record_script(surface.mesh, surface.positions, editor)),
        mesh::signature(region),      verify::report_text(result, ranges),
        figures::to_dot(figure),      pictures::render(figures::paint_grid(figure), "svg")};
  };
  const std::vector<std::string> expected = all();
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Commas));
  const std::string variables = decimal_commas();
  if (!variables.empty()) {
    setenv("LOCPATH", (tests::scratch() / "locales").c_str(), 1);
    REQUIRE(std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr);
  }
  const std::vector<std::string> now = all();
  std::setlocale(LC_ALL, "C");
  unsetenv("LOCPATH");
  std::locale::global(before);
  REQUIRE(now.size() == expected.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    const auto differs =
        std::mismatch(now[i].begin(), now[i].end(), expected[i].begin(), expected[i].end()).first - now[i].begin();
    INFO("text " << i << ": ..."
                 << now[i].substr(static_cast<std::size_t>(std::max<std::ptrdiff_t>(differs - 40, 0)), 80));
    CHECK((now[i] == expected[i]));
  }
}

TEST_CASE("the same input gives the same output", "[determinism]") {
  std::vector<std::string> variants{"LC_ALL=C.UTF-8", "MALLOC_PERTURB_=85"};
  if (const std::string commas = decimal_commas(); !commas.empty()) variants.push_back(commas);
  for (const char* variant : {"setarch -R", "taskset 1"}) {
    if (is_available(variant)) variants.emplace_back(variant);
  }
  for (const std::string& command : kCommands) {
    INFO(command);
    const std::string expected = outputs("", REQUAD_PROGRAM_DIR, command);
    CHECK(expected.size() > 20);
    for (const std::string& variant : variants) {
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
  for (const std::string& command : kCommands) {
    INFO(command);
    CHECK(outputs("", REQUAD_PROGRAM_DIR, command) == outputs("", other, command));
  }
}
