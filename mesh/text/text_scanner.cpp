#include "mesh/text/text_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "mesh/geometry/measures.hpp"
#include "mesh/text/number_text.hpp"

namespace requad::mesh {

TextScanner::TextScanner(std::string name, std::string_view text) : name_(std::move(name)), text_(text) {
  if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
}

std::size_t TextScanner::line_end(std::size_t at) const {
  if (at >= text_.size()) return 0;
  if (text_[at] == '\n') return 1;
  if (text_[at] != '\r') return 0;
  return at + 1 < text_.size() && text_[at + 1] == '\n' ? 2 : 1;
}

void TextScanner::skip_blanks() {
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '\\' && line_end(at_ + 1) > 0) {
      at_ += line_end(at_ + 1);
      ++line_;
    } else if (c == '#') {
      at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
      return;
    } else if (c != ' ' && c != '\t' && c != '\v' && c != '\f') {
      return;
    }
  }
}

bool TextScanner::at_end_of_line() {
  skip_blanks();
  return at_ == text_.size() || line_end(at_) > 0;
}

bool TextScanner::next_line() {
  while (true) {
    while (!at_end_of_line()) word();
    if (at_ == text_.size()) return false;
    // Skips all empty lines at once. Afterwards the caller stands at the first word of a line, or at the end.
    while (const std::size_t length = line_end(at_)) {
      at_ += length;
      ++line_;
    }
    if (!at_end_of_line()) return true;
  }
}

std::string_view TextScanner::word() {
  if (at_end_of_line()) return {};
  const std::size_t start = at_;
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f') break;
    if (c == '\\' && line_end(at_ + 1) > 0) break;
    ++at_;
  }
  return text_.substr(start, at_ - start);
}

namespace {

// Whether a number that no double can hold is too small. `text` is well-formed.
bool is_underflow(std::string_view text) {
  const std::size_t digits = text.find_first_of("0123456789."), e = text.find_first_of("eE");
  const std::string_view mantissa = text.substr(digits, std::min(e, text.size()) - digits);
  std::int64_t power = 0;
  if (e != std::string_view::npos) {
    std::string_view exponent = text.substr(e + 1);
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    const auto [end, error] = std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
    if (error != std::errc()) return exponent.starts_with('-');
  }
  const auto point = static_cast<std::int64_t>(std::min(mantissa.find('.'), mantissa.size()));
  const auto first = static_cast<std::int64_t>(mantissa.find_first_not_of("0."));
  return power + (first < point ? point - first : point + 1 - first) < 0;
}

enum class NumberProblem { none, no_number, not_finite };

NumberProblem parse_number(std::string_view text, double& value) {
  const char* const last = text.data() + text.size();
  const bool plus = text.starts_with('+');
  const auto [end, error] = read_number(text.data() + (plus ? 1 : 0), last, value);
  if (error == std::errc::invalid_argument || end != last || text.starts_with("+-")) return NumberProblem::no_number;
  if (error == std::errc::result_out_of_range && is_underflow(text)) {
    value = text.starts_with('-') ? -0.0 : 0.0;
    return NumberProblem::none;
  }
  return error != std::errc() || !std::isfinite(value) ? NumberProblem::not_finite : NumberProblem::none;
}

}  // namespace

double TextScanner::number(const char* what) {
  const std::string_view text = word();
  if (text.empty()) fail(std::string("the line ends where ") + what + " is expected");
  double value = 0;
  const NumberProblem problem = parse_number(text, value);
  if (problem == NumberProblem::no_number) fail(quoted(text) + " is not a number");
  if (problem == NumberProblem::not_finite) fail(quoted(text) + " is not a finite number");
  return value;
}

void TextScanner::require_number(std::string_view word) const {
  double value = 0;
  if (parse_number(word, value) == NumberProblem::no_number) fail(quoted(word) + " is not a number");
}

double TextScanner::number_or(std::string_view word, double fallback) {
  double value = 0;
  return !word.empty() && parse_number(word, value) == NumberProblem::none ? value : fallback;
}

std::string TextScanner::rest_of_line() {
  if (at_end_of_line()) return "";
  const std::size_t start = at_;
  std::size_t end = at_;
  const int line = line_;
  std::string words;
  while (!at_end_of_line()) {
    words += (words.empty() ? "" : " ") + std::string(word());
    end = at_;
  }
  return line == line_ ? std::string(text_.substr(start, end - start)) : words;
}

std::int64_t TextScanner::integer(std::string_view text, std::string_view& rest) const {
  std::int64_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error == std::errc::invalid_argument) fail(quoted(text) + " is not an integer");
  if (error != std::errc()) fail(quoted(text) + " is too large");
  rest = std::string_view(end, static_cast<std::size_t>(last - end));
  return value;
}

std::int64_t TextScanner::integer(const char* what) {
  const std::string_view text = word();
  if (text.empty()) fail(std::string("the line ends where ") + what + " is expected");
  std::string_view rest;
  const std::int64_t value = integer(text, rest);
  if (!rest.empty()) fail(quoted(text) + " is not an integer");
  return value;
}

double TextScanner::coordinate() {
  const double value = number("a coordinate");
  if (std::abs(value) > kLargestCoordinate) fail("a coordinate is larger than 1e70");
  return value;
}

Eigen::Vector3d TextScanner::position() {
  Eigen::Vector3d p;
  for (double& x : p) x = coordinate();
  return p;
}

void TextScanner::fail(const std::string& reason) const { fail(name_, line_, reason); }

void TextScanner::fail(const std::string& name, int line, const std::string& reason) {
  throw FileError(name + ":" + std::to_string(line) + ": " + reason);
}

std::string TextScanner::quoted(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string start(word.substr(0, kLongest));
  std::replace_if(
      start.begin(), start.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7F'; }, '?');
  return "'" + start + (word.size() > kLongest ? "...'" : "'");
}

void require_text(std::string_view start, const std::string& name) {
  const auto fail = [&name](const char* why) { throw FileError(name + ": cannot be read: " + why); };
  if (start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF")) fail("it is UTF-16; expected ASCII or UTF-8");
  const std::size_t off = start.find("OFF"), binary = start.find("BINARY");
  const std::size_t line_end = start.find_first_of("\r\n");
  if (off < binary && binary < line_end && binary != std::string_view::npos)
    fail("it is a binary OFF file; expected the text format");
}

void require_no_zero_byte(std::string_view text, const std::string& name) {
  if (text.find('\0') != std::string_view::npos)
    throw FileError(name + ": cannot be read: it is no text: a zero byte is in it");
}

}  // namespace requad::mesh
