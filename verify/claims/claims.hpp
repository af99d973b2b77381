// The claims of the paper that this program verifies, and how one region is judged by them.
//
// Each claim is a row of one table: its id, what the paper states, and the check that judges a study. The rows are in
// operation_claims.cpp and region_claims.cpp. The checks are in the other sources, by subject (judging.hpp lists them).
#pragma once

#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "verify/studies/study.hpp"

namespace requad::verify {

// What violates a claim.
struct Violation {
  std::string what;                  // one line: what was expected, what was found
  std::string configuration;         // label, "" if the region as a whole is at fault
  std::string move;                  // step, "" if no move is at fault
  std::optional<mesh::Region> mesh;  // to be written as OBJ
};
// One line: "configuration (1,1), move open: what was expected, what was found".
std::string described(const Violation& violation);

struct Judgement {
  bool applies = true;         // false: the claim says nothing about this region
  std::int64_t checks = 0;     // number of comparisons
  std::string predicted;       // for this region, in a few words: "K = 4 x 3 = 12"
  std::string found;           // what was found there, or of how many things it is true: "20 of 20 moves"
  nlohmann::ordered_json row;  // a table row, or null where only totals are reported
  std::optional<Violation> violation;
};

// A check judges a study and does not change it. The type says which kind of study the check is about; the last type is
// about every kind.
using Check = std::variant<Judgement (*)(const PairStudy&), Judgement (*)(const VertexStudy&),
                           Judgement (*)(const TripleStudy&), Judgement (*)(const Study&)>;

struct Claim {
  std::string id;     // "T2", "N3", ...
  std::string where;  // in the paper
  std::string statement;
  std::string compares;       // the two sides of the check, for readers of the report
  std::string fails_if;       // what makes the check fail: "fails if ..."
  std::set<Family> families;  // the regions that the claim can say something about
  std::set<Method> methods;   // the methods that the check can use; at least one must be asked for
  Check check;

  // Does not apply to a study of another kind than the check's, or of another family than the claim's.
  Judgement judge(const Study& study) const;
  // The same, but an exception from the check counts as a violation. Lets pass only that memory ran out.
  Judgement judge_safely(const Study& study) const;
};

// Operations first, then regions, as operation_claims.cpp and region_claims.cpp list them.
const std::vector<Claim>& claims();
// The claim with this id, in upper or lower case; null if there is none.
const Claim* find_claim(const std::string& id);

// The verdict of a claim for one region.
struct RegionVerdict {
  const Claim* claim = nullptr;
  Judgement judgement;

  bool holds() const { return !judgement.violation; }
};
// Judges a region by these claims, safely. Leaves out the claims that say nothing about it. Precondition: every id is
// that of a claim.
std::vector<RegionVerdict> judge_region(const Study& study, const std::vector<std::string>& ids);

}  // namespace requad::verify
