// Writes numbers as text that reads back as the same bits, and reads them.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <type_traits>

#include <Eigen/Core>

#include "mesh/text/portable_charconv.hpp"

namespace requad::mesh {

// Appends a number in decimal. A floating-point number gets the fewest digits that read back as the same bits; negative
// zero is "-0". The locale has no influence.
template <class Number>
void append_number(std::string& text, Number value) {
  std::array<char, 32> buffer;
  char* const last = buffer.data() + buffer.size();
#ifdef __cpp_lib_to_chars
  text.append(buffer.data(), std::to_chars(buffer.data(), last, value).ptr);
#else
  if constexpr (std::is_floating_point_v<Number>) {
    text.append(buffer.data(), portable::to_chars(buffer.data(), last, value));
  } else {
    text.append(buffer.data(), std::to_chars(buffer.data(), last, value).ptr);
  }
#endif
}

// std::from_chars() for the number at the start of the text.
inline std::from_chars_result read_number(const char* first, const char* last, double& value) {
#ifdef __cpp_lib_to_chars
  return std::from_chars(first, last, value);
#else
  return portable::from_chars(first, last, value);
#endif
}

// Appends the three coordinates, each after a blank.
inline void append_position(std::string& text, const Eigen::Vector3d& p) {
  for (const double coordinate : p) {
    text += ' ';
    append_number(text, coordinate);
  }
}

}  // namespace requad::mesh
