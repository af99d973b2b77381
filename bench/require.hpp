// What a benchmark must have done, or its time means nothing.
#pragma once

#include <stdexcept>

namespace requad::bench {

// Throws, which ends the program with this line. (State::SkipWithError of Google Benchmark 1.7 crashes without a word
// where Complexity() is asked for.)
inline void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

}  // namespace requad::bench
