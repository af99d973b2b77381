// What the fuzz targets share: the allowed outcomes of an input, and the allowed memory.
//
// A target is one source that defines try_input() and kMemory. fuzz.cpp passes libFuzzer's inputs to it. An input is
// either accepted or refused. If it is accepted, the target checks the result. If it is refused, an exception must have
// a message of one line. Anything else ends the process, and libFuzzer keeps the input: a check that fails, another
// exception, a finding of the sanitizers, too much memory, or a run without end.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mesh/program/run/errors.hpp"
#include "mesh/topology/quad_mesh.hpp"

namespace requad::fuzz {

// Defined by the target: reads the text and checks the result. The text's memory ends with the text.
void try_input(std::string_view text);
// Defined by the target: the number of bytes that it may have in use at a time. It grows with the bytes of the input.
struct Memory {
  std::size_t fixed;
  std::size_t per_byte;
};
extern const Memory kMemory;

// Ends the process with the line `otherwise` if the fact does not hold.
void require(bool holds, std::string_view otherwise);
// Ends the process if the message is not one line of text.
void require_one_line(std::string_view message);

// Whether read() ends without an exception for bad input. The message of such an exception must be one line.
template <class Read>
bool accepts(Read&& read) {
  try {
    read();
    return true;
  } catch (const mesh::MeshError& error) {
    require_one_line(error.what());
  } catch (const program::UsageError& error) {
    require_one_line(error.what());
  } catch (const std::invalid_argument& error) {
    require_one_line(error.what());
  }
  return false;
}

}  // namespace requad::fuzz
