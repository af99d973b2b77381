// Reading of certificates: verdicts, words of lines, numbers and checksums.
#pragma once

#include <array>
#include <cstdint>
#include <istream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace check {

// What was claimed does not hold. The message says what is wrong, without a line break.
class Rejected : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A file cannot be read.
class Unreadable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Whether it holds cannot be said: a limit was reached, or there is nothing to check.
class Undecided : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline void require(bool holds, const char* problem) {
  if (!holds) throw Rejected(problem);
}

// A decimal number of at most seven digits, without needless zeros. Throws Rejected if the word is none.
int number(std::string_view word);

// The lines of a file. A line consists of words in ASCII with one space between them, and ends by a line feed.
class Lines {
 public:
  explicit Lines(std::istream& in) : in_(in) {}
  // The next line. It must start with the word `first`, unless that is "", and have `words` words, unless that is 0.
  // The words live until the next call. Throws Rejected.
  const std::vector<std::string_view>& next(std::string_view first, std::size_t words);
  // Requires that no line is left.
  void finish();

  int number() const { return number_; }  // of the line read last, from 1 on
  // CRC-32 (as of gzip and PNG) of what was read, as eight hexadecimal digits.
  std::string checksum() const;

  static constexpr std::size_t kLongestLine = 1000;

 private:
  bool read_line();

  std::istream& in_;
  std::string line_;
  std::vector<std::string_view> words_;
  int number_ = 0;
  std::uint32_t crc_ = 0xFFFFFFFF;
};

}  // namespace check
