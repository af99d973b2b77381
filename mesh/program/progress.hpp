// A counter on standard error that shows how far long work has got.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace requad::program {

// The counter is shown only if standard error is a terminal and the work has taken a second. Safe to use from any
// thread.
class Progress {
 public:
  // `what` names the things that are counted. A total of 0 means that their number is not known.
  Progress(std::string what, std::int64_t total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void advance(std::int64_t by = 1);
  // Takes the counter off the screen, so that other output can follow. The destructor does so too.
  void finish();

 private:
  std::string what_;
  std::int64_t total_;
  bool shown_;
  std::atomic<std::int64_t> done_{0};
  std::mutex mutex_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_;  // when the counter was printed, or the start
  bool printed_ = false;
};

}  // namespace requad::program
