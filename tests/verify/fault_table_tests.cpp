// Tests of tests/faults/table.txt: each fault still has its place in the sources, so that tests/faults/run can seed it.
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "tests/support/catch.hpp"
#include "verify/claims/claims.hpp"

namespace {

const std::string kSources = REQUAD_SOURCE_DIR;

std::string content(const std::string& path) {
  std::ifstream in(kSources + "/" + path);
  INFO(path);
  REQUIRE(in.good());
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

using Fault = std::map<std::string, std::string>;  // the values of the table's keys, and of "name"

std::vector<Fault> read_table() {
  std::vector<Fault> faults;
  std::istringstream in(content("tests/faults/table.txt"));
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (line[0] == '[') {
      faults.push_back({{"name", line.substr(1, line.size() - 2)}});
      continue;
    }
    REQUIRE_FALSE(faults.empty());
    const std::size_t colon = line.find(':');
    REQUIRE(colon != std::string::npos);
    const std::string value = line.substr(colon + 1);
    faults.back()[line.substr(0, colon)] = value.empty() ? "" : value.substr(1);
  }
  return faults;
}

}  // namespace

TEST_CASE("each fault of the table occurs exactly once in its source", "[faults]") {
  const std::vector<Fault> faults = read_table();
  CHECK(faults.size() >= 25);
  std::set<std::string> names;
  for (const Fault& fault : faults) {
    INFO(fault.at("name"));
    CHECK(names.insert(fault.at("name")).second);
    REQUIRE(fault.size() == 6);
    CHECK_FALSE(fault.at("what").empty());
    CHECK(fault.at("replace") != fault.at("with"));
    const std::string source = content(fault.at("file"));
    const std::size_t at = source.find(fault.at("replace"));
    CHECK(at != std::string::npos);
    CHECK(source.find(fault.at("replace"), at + 1) == std::string::npos);
  }
}

TEST_CASE("faults are caught by claims of the ledger, and the README lists them all", "[faults]") {
  std::set<std::string> known{"check", "tampering", "closed"};
  for (const auto& claim : requad::verify::claims()) known.insert(claim.id);
  const std::string readme = content("tests/README.md");
  for (const Fault& fault : read_table()) {
    INFO(fault.at("name"));
    std::istringstream caught(fault.at("caught"));
    std::set<std::string> ids{std::istream_iterator<std::string>(caught), {}};
    CHECK_FALSE(ids.empty());
    for (const std::string& id : ids) CHECK(known.count(id) == 1);
    CHECK(readme.find("| " + fault.at("what") + " | `" + fault.at("file") + "` |") != std::string::npos);
  }
}
