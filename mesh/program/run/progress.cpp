#include "mesh/program/run/progress.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

#include <sys/ioctl.h>
#include <unistd.h>

namespace requad::program {

namespace {

constexpr auto kSilence = std::chrono::seconds(1);
constexpr auto kInterval = std::chrono::milliseconds(200);
// An estimate from less than this share of the work would mislead.
constexpr double kLeastShare = 1e-6;

std::size_t width_of_stderr() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

std::string duration_text(double seconds) {
  struct Unit {
    double seconds;
    double most;  // what is longer has the next unit
    const char* name;
  };
  for (const Unit& unit :
       {Unit{1, 100, " s"}, Unit{60, 100, " min"}, Unit{3600, 48, " h"}, Unit{86400, 1000, " days"}}) {
    const double count = std::max(1.0, std::round(seconds / unit.seconds));
    if (count <= unit.most) return std::to_string(static_cast<int>(count)) + unit.name;
  }
  return "years";
}

Progress::Progress(std::string what, std::int64_t total, bool quiet)
    : what_(std::move(what)), total_(total), start_(Clock::now()) {
  if (!quiet && isatty(STDERR_FILENO) == 1) shower_ = std::thread([this] { show_until_finished(); });
}

Progress::~Progress() { finish(); }

void Progress::finish() {
  {
    const std::scoped_lock lock(mutex_);
    finished_ = true;
  }
  changed_.notify_all();
  if (shower_.joinable()) shower_.join();
}

void Progress::advance(std::int64_t by) {
  const std::scoped_lock lock(mutex_);
  done_ += by;
}

void Progress::advance(std::int64_t by, double share) {
  const std::scoped_lock lock(mutex_);
  done_ += by;
  share_ += share;
  shares_known_ = true;
}

void Progress::was_done(std::int64_t by, double share) {
  advance(by, share);
  const std::scoped_lock lock(mutex_);
  share_before_ += share;
}

std::string Progress::line() const {
  std::string text = what_ + ": " + std::to_string(done_);
  if (total_ > 0) text += " of " + std::to_string(total_);
  const double all = shares_known_ ? share_ : total_ > 0 ? static_cast<double>(done_) / static_cast<double>(total_) : 0;
  const double now = all - share_before_;  // what was done in this time
  if (now < kLeastShare || all >= 1) return text;
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  return text + ", about " + duration_text(seconds * (1 - all) / now) + " left";
}

void Progress::show_until_finished() {
  std::unique_lock lock(mutex_);
  bool shown = false;
  for (Clock::time_point next = start_ + kSilence; !changed_.wait_until(lock, next, [this] { return finished_; });
       next = Clock::now() + kInterval) {
    // In the last column a terminal would begin a new line.
    std::cerr << '\r' << line().substr(0, width_of_stderr() - 1) << "\033[K" << std::flush;
    shown = true;
  }
  if (shown) std::cerr << "\r\033[K" << std::flush;
}

}  // namespace requad::program
