#include "mesh/threads/threads.hpp"

#include <atomic>
#include <optional>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#ifdef REQUAD_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace requad::threads {

namespace {

// ThreadSanitizer cannot see that oneTBB, which is not compiled for it, starts tasks after what comes before the call,
// and ends them before the call returns. This tells it so, in the one source that is not compiled for it either. It
// still finds races between tasks.
struct Order {
#ifdef REQUAD_THREAD_SANITIZER
  void release() { __tsan_release(this); }
  void acquire() { __tsan_acquire(this); }
#else
  void release() {}
  void acquire() {}
#endif
};

}  // namespace

int thread_count(int threads) {
  return threads > 0
             ? threads
             : static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void run_on_threads(std::size_t count, int threads, const std::function<void(std::size_t)>& task) {
  std::optional<tbb::global_control> limit;
  if (threads > 0) limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  const auto workers = static_cast<std::size_t>(thread_count(threads));
  std::atomic<std::size_t> next{0};
  Order start, end;
  start.release();
  tbb::parallel_for(
      std::size_t{0}, workers,
      [&](std::size_t) {
        start.acquire();
        for (std::size_t i = next.fetch_add(1, std::memory_order_relaxed); i < count;
             i = next.fetch_add(1, std::memory_order_relaxed)) {
          try {
            task(i);
          } catch (...) {
            next.store(count, std::memory_order_relaxed);  // no further tasks start
            throw;
          }
        }
        end.release();
      },
      tbb::simple_partitioner());
  end.acquire();
}

}  // namespace requad::threads
