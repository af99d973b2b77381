// Writes numbers as text that reads back as the same bits.
#pragma once

#include <array>
#include <charconv>
#include <string>

#include <Eigen/Core>

namespace requad::mesh {

// Appends a number in decimal. A floating-point number gets the fewest digits that read back as the same bits; negative
// zero is "-0". The locale has no influence.
template <class Number>
void append_number(std::string& text, Number value) {
  std::array<char, 32> buffer;
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

// Appends the three coordinates, each after a blank.
inline void append_position(std::string& text, const Eigen::Vector3d& p) {
  for (const double coordinate : p) {
    text += ' ';
    append_number(text, coordinate);
  }
}

}  // namespace requad::mesh
