// Tasks shared out to the threads of one process, by oneTBB.
#pragma once

#include <cstddef>
#include <functional>

namespace requad::threads {

// How many threads that is: `threads`, or as many as the machine has if that is 0.
int thread_count(int threads);

// Calls task(i) once for each i in 0..count-1: one after the other in this order as threads become free, several at once,
// on at most thread_count(threads) threads. Returns when all are done; what they wrote
// can be read then. If a task throws, the first exception is thrown here once no task runs, and some tasks may be left out.
void run_on_threads(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

}  // namespace requad::threads
