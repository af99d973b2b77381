// Reads a text line by line and word by word, and reports errors with their line.
//
// A line ends in LF, CRLF or CR. A backslash at a line's end joins the next line to it. A # at the start of a word
// starts a comment, up to the line's end. A byte order mark at the start of the text is skipped. The locale has no
// influence.
// Cost: linear in the text, which is not copied.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "mesh/text/file_error.hpp"

namespace requad::mesh {

class TextScanner {
 public:
  // `name` stands for the text in messages. The text must outlive the scanner.
  TextScanner(std::string name, std::string_view text);

  // Skips what is left of this line and goes to the next line that holds a word. Returns false at the end of the text.
  bool next_line();
  // The next word of the line; empty at its end.
  std::string_view word();
  bool at_end_of_line();

  // The next word as a finite number, or as an integer. `what` names it in the message if it is missing. A number that
  // is too small for a double is 0.
  double number(const char* what);
  std::int64_t integer(const char* what);
  // What is left of the line, without comment and outer blanks, as the text has it.
  std::string rest_of_line();
  // Fails unless the word is a number, which may be infinite or NaN.
  void require_number(std::string_view word) const;
  // The word as a finite number, or the fallback. Numbers that are too small are 0.
  static double number_or(std::string_view word, double fallback);
  // The integer at the start of `text`. What follows it comes into `rest`, which the caller must check.
  std::int64_t integer(std::string_view text, std::string_view& rest) const;
  // The next word, or the next three, as coordinates, which are within kLargestCoordinate (measures.hpp) of 0.
  double coordinate();
  Eigen::Vector3d position();

  int line() const { return line_; }
  std::size_t bytes_left() const { return text_.size() - at_; }
  const std::string& name() const { return name_; }

  // Throws FileError "name:line: reason".
  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] static void fail(const std::string& name, int line, const std::string& reason);
  // A word for a message: in quotes, shortened, and without characters that would break the line.
  static std::string quoted(std::string_view word);

 private:
  // How many characters, from `at` on, end a line: 0 if none does, else 1 or 2.
  std::size_t line_end(std::size_t at) const;
  void skip_blanks();

  std::string name_;
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

// Both throw FileError "name: cannot be read: reason": for what is no text, as far as its start tells (UTF-16, a binary
// OFF file), and for a text with a zero byte.
void require_text(std::string_view start, const std::string& name);
void require_no_zero_byte(std::string_view text, const std::string& name);
// The content of a text file or pipe, or of standard input for "-": at most 2 GiB without a zero byte. Throws FileError
// "path: cannot be read: reason". Of a pipe that has no end, or no text, no more is read than shows that.
std::string read_text(const std::string& path);
// How messages call the file: "standard input" for "-", else the path.
std::string name_in_messages(const std::string& path);

}  // namespace requad::mesh
