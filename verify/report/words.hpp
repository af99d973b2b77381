// Words for what the JSON report calls by keys.
#pragma once

#include <string>

#include "verify/studies/study.hpp"

namespace requad::verify {

// The heading of a column in the table of a claim: what the claim's rows have under this key. Throws std::out_of_range
// for a key that no claim writes.
const std::string& heading(const std::string& claim, const std::string& key);

// What the method does, in two or three sentences.
std::string explanation(Method method);

}  // namespace requad::verify
