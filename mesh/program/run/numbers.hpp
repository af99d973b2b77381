// Numbers on command lines. Each function accepts a decimal number and nothing else, and throws UsageError otherwise;
// `what` names the number in the message.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace requad::program {

std::int64_t parse_integer(std::string_view text, std::string_view what);
// A finite number.
double parse_number(std::string_view text, std::string_view what);
// Integers with commas between them, as in "6,6,6".
std::vector<std::int64_t> parse_integers(std::string_view text, std::string_view what);

// The integers first, ..., last; first <= last.
struct Range {
  std::int64_t first;
  std::int64_t last;
};
// "3..24", or "3-24", which is not mistaken for a difference; "7" for 7..7.
Range parse_range(std::string_view text, std::string_view what);

}  // namespace requad::program
