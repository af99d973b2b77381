#include "verify/report/numbers.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace requad::verify {

std::string grouped(std::int64_t number) {
  std::string digits = std::to_string(std::abs(number));
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, "\u202f");
  return (number < 0 ? "-" : "") + digits;
}

std::string seconds_text(double seconds) {
  if (seconds >= 60) {
    const auto whole = static_cast<std::int64_t>(std::llround(seconds));
    if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
  }
  if (seconds < 0.005) return "under 0.01 s";
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), seconds, std::chars_format::fixed, seconds < 1 ? 2 : 1).ptr;
  return std::string(text.data(), end) + " s";
}

}  // namespace requad::verify
