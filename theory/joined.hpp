// Sequences of numbers as text.
#pragma once

#include <string>

namespace requad::theory {

// The numbers of a range in decimal, with the separator between them: "3,5,7"; "" for none.
template <class Numbers>
std::string joined(const Numbers& numbers, const char* separator) {
  std::string text;
  for (const auto number : numbers) {
    if (!text.empty()) text += separator;
    text += std::to_string(number);
  }
  return text;
}

}  // namespace requad::theory
