// Provers who cheat: each tampering with a certificate is refused, for the reason that there is.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/verify/check/tamperings.hpp"

namespace fs = std::filesystem;
using namespace requad;
using tests::call;
using tests::Outcome;
using tests::Proof;
using tests::Tampering;

namespace {

// The certificates of one claim, and regions of each of its families: regular or not, with and without a merged vertex,
// with segments and with grids.
struct Claimed {
  std::string name;  // of the folder
  std::string options;
  std::vector<std::string> regions;
};
const std::vector<Claimed> kClaimed{
    {"T2",
     "--claim T2 --digon 5..7 --other-perimeter 20",
     {"3-3-5-5.txt", "3-3-6-6.txt", "3-3-7-7.txt", "3-3-6-14.txt"}},
    {"T3",
     "--claim T3 --hexagon 4..5 --other-perimeter 20",
     {"5-5-4-4-4-4-4-4.txt", "5-5-5-5-5-5-5-5.txt", "5-5-3-3-4-3-3-4.txt"}},
    {"T4", "--claim T4 --quad-perimeter 14..16", {"3-5-3-3-4-4.txt", "3-5-3-4-5-4.txt"}},
};

const Proof& honest(const Claimed& claimed) {
  static std::map<std::string, Proof> proofs;
  if (proofs.count(claimed.name) == 0) {
    REQUIRE(call("verify", claimed.options + " --method moves --certificate " + claimed.name + " --quiet").code == 0);
    proofs[claimed.name] = tests::read_proof(tests::scratch() / claimed.name);
  }
  return proofs[claimed.name];
}

// What the checker says of a proof that is changed so.
Outcome checked(const Claimed& claimed, const Proof& changed) {
  const fs::path folder = tests::scratch() / claimed.name;
  changed.write(folder, honest(claimed));
  const Outcome outcome = call("verify", "check " + claimed.name);
  honest(claimed).write(folder, changed);
  return outcome;
}

std::vector<std::string> reasons_of(const Tampering& tampering) {
  std::vector<std::string> reasons;
  std::istringstream all(tampering.reason);
  for (std::string reason; std::getline(all, reason, '|');) reasons.push_back(reason);
  return reasons;
}

// The tampering's row of the table in tests/README.md.
std::string row_of(const Tampering& tampering) {
  std::string row = "| " + tampering.name + " | ";
  for (const std::string& reason : reasons_of(tampering)) row += (row.ends_with("| ") ? "" : ", or ") + reason;
  return row + " |\n";
}

}  // namespace

TEST_CASE("honest certificates hold", "[tampering]") {
  for (const Claimed& claimed : kClaimed) {
    const Outcome held = checked(claimed, honest(claimed));
    CHECK(held.code == 0);
    CHECK(held.err == "");
    CHECK(held.out.find("certificates hold") != std::string::npos);
    for (const std::string& name : claimed.regions) {
      INFO(name);
      Proof proof = honest(claimed);
      CHECK(tests::listed_region(proof.file(name).text).text() == proof.file(name).text);
    }
  }
}

TEST_CASE("each tampering is refused, for its reason", "[tampering]") {
  for (const Tampering& tampering : tests::tamperings()) {
    int times = 0;
    for (const Claimed& claimed : kClaimed) {
      for (const std::string& name : claimed.regions) {
        if (tests::kSanitized && times > 0) break;  // one region is enough there
        Proof proof = honest(claimed);
        if (!tampering.apply(proof, proof.file(name))) continue;
        ++times;
        const Outcome outcome = checked(claimed, proof);
        INFO(tampering.name << ", " << name << ": " << outcome.out << outcome.err);
        CHECK(outcome.code == 1);
        CHECK(tests::line_count(outcome.err) == 1);
        const auto reasons = reasons_of(tampering);
        CHECK(std::any_of(reasons.begin(), reasons.end(),
                          [&](const std::string& reason) { return outcome.err.find(reason) != std::string::npos; }));
      }
    }
    INFO(tampering.name << " was tried on no region");
    CHECK(times > 0);
  }
}

TEST_CASE("the README lists all tamperings", "[tampering]") {
  const std::string readme = tests::slurp(fs::path(REQUAD_SOURCE_DIR) / "tests/README.md");
  std::string table = "| tampering | reason |\n|---|---|\n";
  for (const Tampering& tampering : tests::tamperings()) table += row_of(tampering);
  INFO(table);
  CHECK(readme.find(table) != std::string::npos);
}
