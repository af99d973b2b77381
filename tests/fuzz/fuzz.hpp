// What the fuzz targets share: what an input may come to, and how much memory it may take.
//
// A target is one source that defines try_input() and kMemory; fuzz.cpp hands it libFuzzer's inputs. An input
// either is accepted, and then the target checks what came of it, or it is refused by an exception that a program
// prints as one line. Whatever else happens ends the process, and libFuzzer keeps the input: a check that fails,
// another exception, what the sanitizers find, more memory than is allowed, or no end.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mesh/program/errors.hpp"
#include "mesh/topology/quad_mesh.hpp"

namespace requad::fuzz {

// The target's: reads the text and checks what comes of it. The text ends where its memory does.
void try_input(std::string_view text);
// How many bytes it may have in use at a time: some, and some more for each byte of input.
struct Memory {
  std::size_t fixed;
  std::size_t per_byte;
};
extern const Memory kMemory;

// Ends the process with this line unless the fact holds.
void require(bool holds, std::string_view otherwise);
// The same unless this is one line of text.
void require_one_line(std::string_view message);

// Whether read() ends without one of the exceptions that stand for bad input, whose message must be one line.
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
