// Properties that are tested on random cases (RapidCheck). The seed is a constant here, and can be set from outside. A
// run that fails shrinks its case, prints it, and prints RC_PARAMS="reproduce=...", which repeats this case. The seed
// and the number of cases are set by:
//
//   RC_PARAMS="seed=7 max_success=10000" build/tests/programs/requad-programs-tests "[properties]"
#pragma once

#include <cstdlib>
#include <iostream>
#include <string>

#include <rapidcheck.h>

#include "tests/support/catch.hpp"

namespace requad::tests {

// Tests the property on this many cases, or on as many as RC_PARAMS asks for. RapidCheck prints a case that fails and
// how to repeat it. Catch counts the failure.
template <class Property>
void holds(const std::string& what, const Property& property, int cases = 500) {
  using namespace rc::detail;
  // rc::check() is not used: it reads RC_PARAMS once, so all properties of a process would get the same number of
  // cases.
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
