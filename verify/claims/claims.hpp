// One check for each claim of the paper that this program verifies. A check judges a study and changes nothing.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verify/studies/study.hpp"

namespace requad::verify {

// The object that violates a claim.
struct Violation {
  std::string what;                  // one line: what was expected, what was found
  std::string configuration;         // label, "" if the region as a whole is at fault
  std::string move;                  // step, "" if no move is at fault
  std::optional<mesh::Region> mesh;  // to be written as OBJ
};

struct Judgement {
  bool applies = true;         // false: the claim says nothing about this region
  std::int64_t checks = 0;     // things compared
  nlohmann::ordered_json row;  // a table row, or null where only totals are reported
  std::optional<Violation> violation;
};

struct Claim {
  std::string id;     // of the claims ledger
  std::string where;  // in the paper
  std::string statement;
  std::string compares;       // the two sides of the check, for readers of the report
  std::set<Family> families;  // the regions that the claim can say something about
  std::set<Method> methods;   // the ways of finding that the check can use; one of them must have been asked for
  std::function<Judgement(const Study&)> judge;
};

// In the ledger's order.
const std::vector<Claim>& claims();

}  // namespace requad::verify
