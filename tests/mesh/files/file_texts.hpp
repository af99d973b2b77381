// Texts and helpers for the tests of files.
#pragma once

#include <string>

#include "mesh/text/file_error.hpp"
#include "tests/support/catch.hpp"

namespace requad::tests {

// The vertices of an OBJ file that has one quad.
inline const std::string kFourVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

// The message by which the reader refuses a text, as "line: reason"; "" if it accepts the text.
template <class Parse>
std::string complaint(const Parse& parse, const std::string& text) {
  try {
    parse(text, "file");
  } catch (const mesh::FileError& error) {
    const std::string message = error.what();
    CHECK(message.find('\n') == std::string::npos);
    REQUIRE(message.rfind("file:", 0) == 0);
    return message.substr(5);
  }
  return "";
}

}  // namespace requad::tests
