// Takes a text apart line by line and word by word, and says in which line something is wrong.
//
// Lines end in LF, CRLF or CR. A backslash before a line's end joins the next line to it; what follows a # at the start
// of a word is a comment. A byte order mark is skipped. Nothing depends on the locale. Linear in the text, no copies.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mesh/files/file_error.hpp"

namespace requad::mesh {

class TextScanner {
 public:
  // `name` stands for the text in messages; the text is not copied.
  TextScanner(std::string name, std::string_view text);

  // Goes to the next line that holds a word; false at the end of the text. What is left of the present line is skipped.
  bool next_line();
  // The next word of the line; empty at its end.
  std::string_view word();
  bool at_end_of_line();

  // The next word as a finite number or as an integer; `what` names it if it is missing.
  double number(const char* what);
  std::int64_t integer(const char* what);
  // A whole word, or the start of one, as an integer: what is left of it, in `rest`, the caller must look at.
  std::int64_t integer(std::string_view text, std::string_view& rest) const;

  int line() const { return line_; }
  std::size_t bytes_left() const { return text_.size() - at_; }
  const std::string& name() const { return name_; }

  // Throws FileError "name:line: reason".
  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] static void fail(const std::string& name, int line, const std::string& reason);
  // A word for a message: in quotes, shortened, and without characters that would break the line.
  static std::string quoted(std::string_view word);

 private:
  // How many characters from `at` on end a line: 0 (none does), 1 or 2.
  std::size_t line_end(std::size_t at) const;
  void skip_blanks();

  std::string name_;
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

// A whole file of text: at most 2 GiB, no zero byte. Throws FileError with a one-line reason, early on pipes.
std::string read_text(const std::string& path);

}  // namespace requad::mesh
