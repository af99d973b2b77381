// Properties of what is drawn at random (RapidCheck). What a run draws follows from a seed, which is a constant here and
// can be set from outside; a failing run shrinks what it drew, prints it, and RC_PARAMS="reproduce=..." which runs that
// very case again:
//
//   RC_PARAMS="seed=7 max_success=10000" build/tests/requad-tests "[properties]"
#pragma once

#include <cstdlib>
#include <string>

#include <rapidcheck.h>

#include "tests/support/catch.hpp"

namespace requad::tests {

// RapidCheck prints the case and how to repeat it; Catch counts the failure. Holds for so many cases, or as many as
// RC_PARAMS asks for.
template <class Property>
void holds(const std::string& what, const Property& property, int cases = 500) {
  static const bool asked = std::getenv("RC_PARAMS") != nullptr;
  if (!asked) setenv("RC_PARAMS", ("seed=2011 max_success=" + std::to_string(cases)).c_str(), 1);
  CHECK(rc::check(what, property));
}

}  // namespace requad::tests
