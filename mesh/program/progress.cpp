#include "mesh/program/progress.hpp"

#include <iostream>
#include <utility>

#include <unistd.h>

namespace requad::program {

Progress::Progress(std::string what, std::int64_t total, bool quiet)
    : what_(std::move(what)),
      total_(total),
      shown_(!quiet && isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {}

Progress::~Progress() { finish(); }

void Progress::finish() {
  const std::scoped_lock lock(mutex_);
  if (printed_) std::cerr << "\r\033[K" << std::flush;
  printed_ = false;
}

void Progress::advance(std::int64_t by) {
  const std::int64_t done = done_ += by;
  if (!shown_) return;
  const std::scoped_lock lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (now - start_ < std::chrono::seconds(1) || now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  printed_ = true;
  std::cerr << '\r' << what_ << ": " << done;
  if (total_ > 0) std::cerr << " of " << total_;
  std::cerr << "\033[K" << std::flush;
}

}  // namespace requad::program
