// Who includes whom: theory/ and mesh/ do not know each other, so that what one predicts is compared with what the other
// does; the folders above them include only folders below.
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "tests/support/catch.hpp"

TEST_CASE("each folder includes only those it may use", "[includes]") {
  const std::map<std::string, std::set<std::string>> may_use{
      {"theory", {}},
      {"mesh", {}},
      {"enumerate", {"theory", "mesh"}},
      {"verify", {"theory", "mesh", "enumerate"}},
      {"figures", {"theory", "mesh", "enumerate"}},
  };
  const std::string include = "#include \"";
  for (const auto& [folder, used] : may_use) {
    int own = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::string(REQUAD_SOURCE_DIR) + "/" + folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        if (line.rfind(include, 0) != 0) continue;
        const std::string included = line.substr(include.size(), line.find('/') - include.size());
        if (included == folder) ++own;
        const bool ours = may_use.count(included) > 0 || included == "bench" || included == "tests";
        INFO(entry.path() << ": " << line);
        CHECK((!ours || included == folder || used.count(included) > 0));
      }
    }
    INFO(folder);
    CHECK(own > 10);
  }
}
