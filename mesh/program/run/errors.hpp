// Errors that a program reports in one line.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

namespace requad::program {

// The text with a '?' for each character that would end the line or act on a terminal.
std::string one_line(std::string text);

// Bad arguments or bad input. The message is one line that says what is wrong, where, and what was expected.
class UsageError : public std::runtime_error {
 public:
  // A message may quote arguments and names of files, so one_line() is applied to it.
  explicit UsageError(std::string message) : std::runtime_error(one_line(std::move(message))) {}
};

// Whether the error says that memory or threads ran out. That is no fault of the code that threw it: throw it again.
bool is_exhaustion(const std::exception& error);

}  // namespace requad::program
