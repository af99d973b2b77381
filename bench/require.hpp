// Checks that a benchmark did its work; otherwise its time means nothing.
#pragma once

#include <stdexcept>

namespace requad::bench {

// Throws std::logic_error with this message if the condition does not hold. This ends the program. The alternative,
// State::SkipWithError, crashes in Google Benchmark 1.7 without a message if Complexity() was called.
inline void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

}  // namespace requad::bench
