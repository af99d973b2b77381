#include "mesh/files/text_scanner.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>

#include "mesh/geometry/measures.hpp"

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

double TextScanner::number(const char* what) {
  const std::string_view text = word();
  if (text.empty()) fail(std::string("the line ends where ") + what + " is expected");
  double value = 0;
  const char* const last = text.data() + text.size();
  const bool plus = text.front() == '+';
  const auto [end, error] = std::from_chars(text.data() + (plus ? 1 : 0), last, value);
  if (error == std::errc::invalid_argument || end != last || text.starts_with("+-"))
    fail(quoted(text) + " is not a number");
  if (error != std::errc() || !std::isfinite(value)) fail(quoted(text) + " is not a finite number");
  return value;
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

Eigen::Vector3d TextScanner::position() {
  Eigen::Vector3d p;
  for (double& coordinate : p) {
    coordinate = number("a coordinate");
    if (std::abs(coordinate) > kLargestCoordinate) fail("a coordinate is larger than 1e70");
  }
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

std::string read_text(const std::string& path) {
  const auto fail = [&path](const std::string& why) { throw FileError(path + ": cannot be read: " + why); };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail("it is a folder");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(std::strerror(errno));
  // The text is read in pieces, because a pipe does not know its size and may have no end.
  std::string text;
  constexpr std::size_t kLargestText = std::size_t{1} << 31;  // over thirty million quads
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  std::size_t size = 0;
  try {
    do {
      text.resize(std::max(size + kPiece, size + size / 2));
      in.read(text.data() + size, static_cast<std::streamsize>(text.size() - size));
      const std::size_t end = size + static_cast<std::size_t>(in.gcount());
      if (std::memchr(text.data() + size, 0, end - size)) fail("it is no text: a zero byte is in it");
      if (end > kLargestText) fail("it is larger than 2 GiB");
      size = end;
    } while (in);
    if (in.bad()) fail("input error");
    text.resize(size);
  } catch (const std::bad_alloc&) {
    fail("it does not fit into memory");
  }
  return text;
}

}  // namespace requad::mesh
