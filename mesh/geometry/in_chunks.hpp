// Loops whose rounds do not depend on each other, on the threads of a caller who has some.
//
// This library starts no threads: the editor's page has none. A program passes requad::threads::run_on_threads().
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace requad::mesh {

// Calls task(i) once for each i in 0..count-1, in any order or at the same time, and returns when all are done.
using RunTasks = std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

// Calls body(first, last) for ranges that make up 0..count-1, by `run` if there is one and the loop is long enough to be
// worth it. The ranges do not depend on the number of threads. body must not throw.
template <class Body>
void in_chunks(const RunTasks& run, std::size_t count, Body&& body) {
  constexpr std::size_t kLeast = 8, kMost = 64;  // rounds in a chunk, chunks
  const std::size_t chunks = std::min(count / kLeast, kMost);
  if (!run || chunks < 2) {
    body(std::size_t{0}, count);
  } else {
    run(chunks, [&](std::size_t i) { body(count * i / chunks, count * (i + 1) / chunks); });
  }
}

}  // namespace requad::mesh
