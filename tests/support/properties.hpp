// Properties of what is drawn at random (RapidCheck). What a run draws follows from a seed, which is a constant here and
// can be set from outside. A failing run shrinks what it drew, prints it, and prints RC_PARAMS="reproduce=...", which runs
// that very case again:
//
//   RC_PARAMS="seed=7 max_success=10000" build/tests/programs/requad-programs-tests "[properties]"
#pragma once

#include <cstdlib>
#include <iostream>
#include <string>

#include <rapidcheck.h>

#include "tests/support/catch.hpp"

namespace requad::tests {

// RapidCheck prints the case and how to repeat it; Catch counts the failure. The property is tried on so many cases, or on
// as many as RC_PARAMS asks for.
template <class Property>
void holds(const std::string& what, const Property& property, int cases = 500) {
  using namespace rc::detail;
  // rc::check() reads RC_PARAMS once, so that all properties of a process would be tried on as many cases as the first.
  static const char* const asked = std::getenv("RC_PARAMS");
  if (asked == nullptr) setenv("RC_PARAMS", "seed=2011", 1);
  Configuration defaults;
  defaults.testParams.seed = 2011;
  defaults.testParams.maxSuccess = cases;
  const TestParams parameters = configFromString(asked == nullptr ? "" : asked, defaults).testParams;

  std::cerr << "\n- " << what << "\n";
  TestMetadata metadata;
  metadata.id = what;
  metadata.description = what;
  const TestResult result = checkTestable(property, metadata, parameters);
  printResultMessage(result, std::cerr);
  std::cerr << std::endl;
  CHECK(result.is<SuccessResult>());
}

}  // namespace requad::tests
