// Numbers as text that nothing is lost in.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace requad {

// Adds a number in decimal: for a floating-point one the fewest digits that read back as the same bits, "-0" included.
// Nothing depends on the locale.
template <class Number>
void append_number(std::string& text, Number value) {
  std::array<char, 32> buffer;
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

}  // namespace requad
