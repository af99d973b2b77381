#include "mesh/program/run/numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

#include "mesh/program/run/errors.hpp"

namespace requad::program {

std::int64_t parse_integer(std::string_view text, std::string_view what) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    throw UsageError(std::string(what) + ": " + std::string(text) + " is too large");
  }
  if (error != std::errc() || end != text.data() + text.size()) {
    throw UsageError(std::string(what) + ": '" + std::string(text) + "' is not an integer");
  }
  return value;
}

double parse_number(std::string_view text, std::string_view what) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || end != text.data() + text.size()) {
    throw UsageError(std::string(what) + ": '" + std::string(text) + "' is not a number");
  }
  if (error != std::errc() || !std::isfinite(value)) {
    throw UsageError(std::string(what) + ": " + std::string(text) + " is not a finite number");
  }
  return value;
}

std::vector<std::int64_t> parse_integers(std::string_view text, std::string_view what) {
  std::vector<std::int64_t> values;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    values.push_back(parse_integer(text.substr(start, comma - start), what));
    start = comma + 1;
  }
  return values;
}

Range parse_range(std::string_view text, std::string_view what) {
  std::size_t end = text.find(".."), next = end + 2;
  if (end == std::string_view::npos && text.size() > 1) {  // a sign may come first
    end = text.find('-', 1);
    next = end + 1;
  }
  if (end == std::string_view::npos) {
    const std::int64_t only = parse_integer(text, what);
    return {only, only};
  }
  const Range range{parse_integer(text.substr(0, end), what), parse_integer(text.substr(next), what)};
  if (range.first > range.last) {
    throw UsageError(std::string(what) + ": " + std::string(text) +
                     " is empty; expected FIRST..LAST with FIRST <= LAST");
  }
  return range;
}

}  // namespace requad::program
