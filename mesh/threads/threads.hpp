// Tasks divided among several threads of one process, by oneTBB.
#pragma once

#include <cstddef>
#include <functional>

namespace requad::threads {

// The number of threads that a request for `threads` of them means: `threads`, or for 0 as many as oneTBB may use,
// which is the number of cores unless something limits it.
int thread_count(int threads);

// Calls task(i) once for each i in 0..count-1, on at most thread_count(threads) threads. Tasks start in this order,
// each as soon as a thread is free. Returns when all are done; the caller can then read what they wrote. If a task
// throws, no further tasks start, and the first exception is thrown here once no task runs.
void run_on_threads(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

}  // namespace requad::threads
