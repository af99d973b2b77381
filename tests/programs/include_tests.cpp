// Which room includes which. A room is a folder with sources. It may include its own headers and those of the rooms
// that the table below lists. theory/ and mesh/ do not include each other, so that the predictions of one can be
// compared with the results of the other. A lower room never includes a higher one.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"

namespace {

namespace fs = std::filesystem;
using Rooms = std::set<std::string>;
using Table = std::map<std::string, Rooms>;

Rooms operator+(Rooms a, const Rooms& b) {
  a.insert(b.begin(), b.end());
  return a;
}

const Rooms kTheory{"theory", "theory/proofs"};
// The rooms of requad::mesh, the lowest one first.
const Rooms kMesh{"mesh/topology", "mesh/geometry", "mesh/text", "mesh/files", "mesh/editing", "mesh/irregular"};
const Rooms kProgram{"mesh/program", "mesh/program/run"};
const Rooms kPlumbing = kProgram + Rooms{"mesh/threads"};
const Rooms kEnumerate{"enumerate", "enumerate/graphs", "enumerate/search"};
const Rooms kVerify{"verify", "verify/studies", "verify/claims", "verify/report"};
const Rooms kFigures{"figures", "figures/panels", "figures/pictures", "figures/explorer"};
const Rooms kBelowEnumerate = kTheory + kMesh + kPlumbing;
const Rooms kBelowVerify = kBelowEnumerate + kEnumerate;
const Rooms kBelowFigures = kBelowVerify + kVerify + Rooms{"mesh/pictures"};
const Rooms kAll = kBelowFigures + kFigures;
const Rooms kTestsOfMesh = kMesh + kPlumbing + Rooms{"mesh/pictures", "tests/support", "tests/support/mesh"};

const Table kMayInclude{
    {"theory", {}},
    {"theory/proofs", {"theory"}},

    {"mesh/topology", {}},
    {"mesh/geometry", {"mesh/topology"}},
    {"mesh/text", {"mesh/geometry"}},
    {"mesh/files", {"mesh/topology", "mesh/geometry", "mesh/text"}},
    {"mesh/editing", {"mesh/topology", "mesh/geometry", "mesh/text", "mesh/files"}},
    {"mesh/irregular", {"mesh/topology", "mesh/geometry", "mesh/text", "mesh/files", "mesh/editing"}},
    {"mesh/threads", {}},
    {"mesh/program/run", {}},
    {"mesh/program", {"mesh/program/run"}},
    {"mesh/pictures", kProgram + Rooms{"mesh/topology", "mesh/geometry", "mesh/text", "mesh/files"}},
    {"mesh/examples", kMesh},
    {"mesh/web", kMesh},
    {"mesh/commands", kMesh + kPlumbing + Rooms{"mesh/pictures"}},

    {"enumerate/search", kMesh + kPlumbing},
    {"enumerate", kBelowEnumerate},
    {"enumerate/graphs", kBelowEnumerate + Rooms{"enumerate"}},
    {"enumerate/commands", kBelowVerify},

    {"verify/studies", kBelowVerify},
    {"verify/claims", kBelowVerify + Rooms{"verify/studies"}},
    {"verify", kBelowVerify + Rooms{"verify/studies", "verify/claims"}},
    {"verify/report", kBelowVerify + Rooms{"verify", "verify/studies", "verify/claims"}},
    {"verify/check", {}},
    {"verify/commands", kBelowVerify + kVerify},

    {"figures", kBelowFigures},
    {"figures/panels", kBelowFigures + Rooms{"figures"}},
    {"figures/pictures", kBelowFigures + Rooms{"figures", "figures/panels"}},
    {"figures/explorer", kBelowFigures + Rooms{"figures"}},
    {"figures/commands", kAll},

    {"bench", kAll},

    {"tests/support", {}},
    {"tests/support/theory", kTheory},
    {"tests/support/mesh", kMesh + Rooms{"tests/support"}},
    {"tests/support/enumerate", kBelowVerify + Rooms{"tests/support", "tests/support/theory", "tests/support/mesh"}},
    {"tests/theory", kTheory + Rooms{"tests/support", "tests/support/theory"}},
    {"tests/mesh", kTestsOfMesh},
    {"tests/mesh/files", kTestsOfMesh},
    {"tests/mesh/geometry", kTestsOfMesh},
    {"tests/mesh/editing", kTestsOfMesh},
    {"tests/mesh/web", kMesh + Rooms{"mesh/web", "tests/support", "tests/support/mesh"}},
    {"tests/enumerate",
     kBelowVerify + Rooms{"tests/support", "tests/support/theory", "tests/support/mesh", "tests/support/enumerate"}},
    {"tests/verify/check", Rooms{"verify/check", "mesh/program/run", "tests/support"}},
    {"tests/verify",
     kBelowVerify + kVerify +
         Rooms{"tests/support", "tests/support/theory", "tests/support/mesh", "tests/support/enumerate"}},
    {"tests/figures",
     kAll + Rooms{"tests/support", "tests/support/theory", "tests/support/mesh", "tests/support/enumerate"}},
    {"tests/programs",
     kAll + Rooms{"tests/support", "tests/support/theory", "tests/support/mesh", "tests/support/enumerate"}},
    {"tests/fuzz", kBelowVerify + kVerify + Rooms{"verify/check"}},
    {"tests/package", {}},
};

// For each room, the rooms that its sources include, each with an include line.
using Arrows = std::map<std::string, std::map<std::string, std::string>>;

Arrows arrows_of_sources() {
  const fs::path root = REQUAD_SOURCE_DIR;
  Arrows arrows;
  for (const std::string folder : {"theory", "mesh", "enumerate", "verify", "figures", "bench", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path& path = entry.path();
      if (path.extension() != ".cpp" && path.extension() != ".hpp") continue;
      auto& included = arrows[path.parent_path().lexically_relative(root).generic_string()];
      std::ifstream in(path);
      const std::string include = "#include \"";
      for (std::string line; std::getline(in, line);) {
        if (line.rfind(include, 0) != 0) continue;
        const std::string header = line.substr(include.size(), line.find('"', include.size()) - include.size());
        included.emplace(fs::path(header).parent_path().generic_string(), path.generic_string() + ": " + line);
      }
    }
  }
  return arrows;
}

// The includes that are not allowed, one to a line.
std::vector<std::string> problems(const Arrows& arrows, const Table& may_include) {
  std::vector<std::string> found;
  for (const auto& [room, included] : arrows) {
    const auto row = may_include.find(room);
    if (row == may_include.end()) {
      found.push_back(room + " is in no row of the table");
      continue;
    }
    for (const auto& [other, where] : included) {
      if (other != room && row->second.count(other) == 0)
        found.push_back(room + " may not include " + other + ": " + where);
    }
  }
  return found;
}

// Rooms that include each other in a circle; empty if there are none.
std::vector<std::string> circle(const Arrows& arrows) {
  std::vector<std::string> path;
  std::set<std::string> done;
  const auto search = [&](auto&& self, const std::string& room) -> bool {
    if (const auto again = std::find(path.begin(), path.end(), room); again != path.end()) {
      path.erase(path.begin(), again);
      return true;
    }
    if (done.count(room) > 0) return false;
    path.push_back(room);
    if (const auto row = arrows.find(room); row != arrows.end()) {
      for (const auto& [other, where] : row->second) {
        if (other != room && self(self, other)) return true;
      }
    }
    path.pop_back();
    done.insert(room);
    return false;
  };
  for (const auto& [room, included] : arrows) {
    if (search(search, room)) return path;
  }
  return {};
}

}  // namespace

TEST_CASE("each room includes only those that it may", "[includes]") {
  const Arrows arrows = arrows_of_sources();
  CHECK(problems(arrows, kMayInclude) == std::vector<std::string>{});
  CHECK(circle(arrows) == std::vector<std::string>{});
  for (const auto& [room, row] : kMayInclude) {
    INFO(room << " has no sources");
    CHECK(arrows.count(room) == 1);
  }
}

TEST_CASE("the certificates' checker includes itself and the standard library only", "[includes]") {
  for (const auto& entry : fs::directory_iterator(std::string(REQUAD_SOURCE_DIR) + "/verify/check")) {
    if (entry.path().filename() == "CMakeLists.txt") continue;
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      if (line.rfind("#include", 0) != 0 || line.rfind("#include \"verify/check/", 0) == 0) continue;
      INFO(line);
      CHECK(line.find('<') != std::string::npos);
      CHECK(line.find('/') == std::string::npos);
      CHECK(line.find(".h") == std::string::npos);  // no header of the system
    }
  }
}

TEST_CASE("wrong arrows, rooms without a row and circles are found", "[includes]") {
  const Table table{{"low", {}}, {"high", {"low"}}, {"beside", {"high"}}};
  const Arrows good{{"low", {{"low", "a"}}}, {"high", {{"low", "b"}}}, {"beside", {{"high", "c"}}}};
  CHECK(problems(good, table).empty());
  CHECK(circle(good).empty());
  Arrows up = good;
  up["low"]["beside"] = "d";
  CHECK(problems(up, table) == std::vector<std::string>{"low may not include beside: d"});
  CHECK(std::set<std::string>{"beside", "high", "low"} == [&] {
    const auto rooms = circle(up);
    return std::set<std::string>(rooms.begin(), rooms.end());
  }());
  Arrows unknown = good;
  unknown["new"] = {};
  CHECK(problems(unknown, table) == std::vector<std::string>{"new is in no row of the table"});
}
