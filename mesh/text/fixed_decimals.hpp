// Writes numbers as text with a given number of digits after the point. The locale has no influence.
#pragma once

#include <array>
#include <charconv>
#include <limits>
#include <string>

namespace requad::mesh {

// A number with as many digits after the point, wherever the point is. What is rounded to zero has no sign. Precondition:
// the number is finite, and 0 <= digits <= 15.
inline std::string fixed_decimals(double value, int digits) {
  std::array<char, std::numeric_limits<double>::max_exponent10 + 32> buffer;
  std::string text(
      buffer.data(),
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits).ptr);
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

// The same without zeros at the end: "1.5", "2".
inline std::string short_decimals(double value, int digits) {
  std::string text = fixed_decimals(value, digits);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace requad::mesh
