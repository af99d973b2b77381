// The error of a file that can not be read, or whose text is not what it should be.
#pragma once

#include <stdexcept>

namespace requad::mesh {

// The message is one line, "file: reason" or "file:line: reason", and needs nothing added before a user reads it.
class FileError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace requad::mesh
