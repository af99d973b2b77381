#include "mesh/text/portable_charconv.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

namespace requad::mesh::portable {

namespace {

float parsed(const char* text, float) { return std::strtof(text, nullptr); }
double parsed(const char* text, double) { return std::strtod(text, nullptr); }

// The fewest significant digits that read back as this value, as "d.ddde+xx". Any text of digits10 digits survives, so
// fewer digits show themselves by zeros at the end; except of numbers so small that they have fewer bits.
template <class Number>
std::string shortest_scientific(Number value) {
  using Limits = std::numeric_limits<Number>;
  std::array<char, 40> buffer;
  for (int digits = std::abs(value) < Limits::min() ? 1 : Limits::digits10; digits <= Limits::max_digits10; ++digits) {
    std::snprintf(buffer.data(), buffer.size(), "%.*e", digits - 1, static_cast<double>(value));
    if (parsed(buffer.data(), value) == value) break;
  }
  std::string text = buffer.data();
  const std::size_t e = text.find('e');
  const std::size_t last = text.find_last_not_of('0', e - 1);
  text.erase(text[last] == '.' ? last : last + 1, e - (text[last] == '.' ? last : last + 1));
  return text;
}

// The same digits without an exponent.
std::string fixed(const std::string& scientific, double value) {
  const std::size_t e = scientific.find('e');
  const int power = std::atoi(scientific.c_str() + e + 1);
  std::string digits;
  for (const char c : scientific.substr(0, e)) {
    if (c >= '0' && c <= '9') digits += c;
  }
  const auto count = static_cast<int>(digits.size());
  std::string text;
  if (power < 0) {
    text = "0." + std::string(static_cast<std::size_t>(-power - 1), '0') + digits;
  } else if (power < count - 1) {
    text = digits.substr(0, static_cast<std::size_t>(power) + 1) + "." +
           digits.substr(static_cast<std::size_t>(power) + 1);
  } else {
    std::array<char, 400> buffer;  // an integer, with all its digits
    std::snprintf(buffer.data(), buffer.size(), "%.0f", std::abs(value));
    text = buffer.data();
  }
  return (std::signbit(value) ? "-" : "") + text;
}

template <class Number>
char* write(char* first, Number value) {
  const std::string scientific = shortest_scientific(value);
  const std::string plain = fixed(scientific, static_cast<double>(value));
  const std::string& shorter = scientific.size() < plain.size() ? scientific : plain;
  return std::copy(shorter.begin(), shorter.end(), first);
}

// Where the number at the start of the text ends: "-1.5e+3", "inf", "nan". 0 if there is none.
std::size_t end_of_number(std::string_view text) {
  const auto digits_from = [&text](std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    return end;
  };
  const std::size_t start = text.starts_with('-') ? 1 : 0;
  for (const std::string_view word : {"infinity", "inf", "nan"}) {
    const std::string_view here = text.substr(start, word.size());
    if (here.size() == word.size() && std::equal(here.begin(), here.end(), word.begin(), [](char c, char lower) {
          return c == lower || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == lower);
        }))
      return start + word.size();
  }
  std::size_t end = digits_from(start);
  std::size_t digits = end - start;
  if (end < text.size() && text[end] == '.') {
    const std::size_t last = digits_from(end + 1);
    digits += last - end - 1;
    end = last;
  }
  if (digits == 0) return 0;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    const bool sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
    const std::size_t exponent = end + (sign ? 2 : 1);
    if (digits_from(exponent) > exponent) end = digits_from(exponent);
  }
  return end;
}

}  // namespace

char* to_chars(char* first, char*, double value) { return write(first, value); }
char* to_chars(char* first, char*, float value) { return write(first, value); }

std::from_chars_result from_chars(const char* first, const char* last, double& value) {
  const std::string_view text(first, static_cast<std::size_t>(last - first));
  const std::size_t end = end_of_number(text);
  if (end == 0) return {first, std::errc::invalid_argument};
  const std::string number(text.substr(0, end));  // strtod() needs an end
  const double result = std::strtod(number.c_str(), nullptr);
  const bool has_nonzero_digit = number.find_first_of("123456789") < number.find_first_of("eE");
  const bool too_large = std::isinf(result) && number.find_first_of("iI") == std::string::npos;
  const bool too_small = result == 0 && has_nonzero_digit;
  if (too_large || too_small) return {first + end, std::errc::result_out_of_range};
  value = result;
  return {first + end, std::errc()};
}

}  // namespace requad::mesh::portable
