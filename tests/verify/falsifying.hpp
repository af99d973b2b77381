// A study is falsified, and a claim must fail: what the tests of claims share.
#pragma once

#include <set>
#include <stdexcept>
#include <string>

#include "tests/support/catch.hpp"
#include "verify/claims/claims.hpp"

namespace requad::tests {

using verify::Claim;
using verify::Judgement;
using verify::Method;
using verify::PairStudy;

inline const Claim& claim(const std::string& id) {
  const Claim* const found = verify::find_claim(id);
  if (found == nullptr) throw std::logic_error("no claim " + id);
  return *found;
}

inline const std::set<Method> kAll{Method::moves, Method::search, Method::walk};

inline PairStudy study_of(theory::PairType type, const theory::IntegerVector& s) {
  return verify::study_pair({type, s}, kAll);
}

// Checks that a claim holds for this study, and fails after the study is falsified.
template <class Kind, class Falsify>
void fails(const std::string& id, Kind s, Falsify falsify) {
  INFO(id);
  REQUIRE_FALSE(claim(id).judge(s).violation.has_value());
  falsify(s);
  const Judgement j = claim(id).judge(s);
  REQUIRE(j.violation.has_value());
  CHECK(!j.violation->what.empty());
  CHECK(!j.predicted.empty());
  CHECK(!j.found.empty());
}

}  // namespace requad::tests
