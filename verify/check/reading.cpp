#include "verify/check/reading.hpp"

#include <algorithm>
#include <charconv>

namespace check {

int number(std::string_view word) {
  int value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole = error == std::errc() && end == word.data() + word.size() && word[0] != '-';
  if (!whole || word.size() > 7 || (word.size() > 1 && word[0] == '0'))
    throw Rejected("'" + std::string(word.substr(0, 20)) + "' is no number");
  return value;
}

namespace {

// One step of CRC-32 for each value of a byte: the polynomial 0x04C11DB7, lowest bit first.
constexpr std::array<std::uint32_t, 256> kCrcSteps = [] {
  std::array<std::uint32_t, 256> steps{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? (crc >> 1) ^ 0xEDB88320 : crc >> 1;
    steps[byte] = crc;
  }
  return steps;
}();

}  // namespace

bool Lines::read_line() {
  line_.clear();
  std::streambuf& source = *in_.rdbuf();
  for (;;) {
    const int c = source.sbumpc();
    if (c == std::char_traits<char>::eof()) {
      require(line_.empty(), "the last line has no end");
      return false;
    }
    crc_ = (crc_ >> 8) ^ kCrcSteps[(crc_ ^ static_cast<std::uint32_t>(c)) & 0xFF];
    if (c == '\n') return true;
    require(' ' <= c && c <= '~', "a character is not printable");
    require(line_.size() < kLongestLine, "a line is too long");
    line_.push_back(static_cast<char>(c));
  }
}

const std::vector<std::string_view>& Lines::next(std::string_view first, std::size_t words) {
  ++number_;
  require(read_line(), "the file ends too early");
  words_.clear();
  std::string_view rest = line_;
  for (;;) {
    const std::size_t space = std::min(rest.find(' '), rest.size());
    require(space > 0, "words are not parted by one space");
    words_.push_back(rest.substr(0, space));
    if (space == rest.size()) break;
    rest.remove_prefix(space + 1);
  }
  if (!first.empty() && words_[0] != first) throw Rejected("expected '" + std::string(first) + "'");
  require(words == 0 || words_.size() == words, "a line has a wrong number of words");
  return words_;
}

void Lines::finish() {
  if (!read_line()) return;
  ++number_;
  throw Rejected("the file goes on after 'end'");
}

std::string Lines::checksum() const {
  std::string digits;
  for (int shift = 28; shift >= 0; shift -= 4) digits += "0123456789abcdef"[(~crc_ >> shift) & 0xF];
  return digits;
}

}  // namespace check
