// Checks that a benchmark did its work; otherwise its time means nothing.
#pragma once

#include <stdexcept>

namespace requad::bench {

// Throws std::logic_error if the condition does not hold, which ends the program with this line. State::SkipWithError
// is no alternative: that of Google Benchmark 1.7 crashes without a message when Complexity() was called.
inline void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

}  // namespace requad::bench
