// The error that this room throws: a file cannot be read, or its text is not what it should be.
#pragma once

#include <stdexcept>

namespace requad::mesh {

// The message is one line, "file: reason" or "file:line: reason", which can be shown to a user as it is.
class FileError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace requad::mesh
