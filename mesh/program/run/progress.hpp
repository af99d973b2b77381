// A line on standard error that shows how far long work has got, and when it may end.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

namespace requad::program {

// "regions: 120 of 3000, about 40 s left". The line is shown only if standard error is a terminal and the work has taken
// a second. A thread of its own keeps it up to date, so that it is seen that the program is at work even where a single
// step takes long. Safe to use from any thread.
class Progress {
 public:
  // `what` names the things that are counted. A total of 0 means that their number is not known.
  Progress(std::string what, std::int64_t total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // So many more things are done. They are this share of all the work, as far as one can know it; without a share, each
  // thing is as much work as any other.
  void advance(std::int64_t by = 1);
  void advance(std::int64_t by, double share);
  // The same for what was done before this run, and took none of its time.
  void was_done(std::int64_t by, double share);
  // Takes the line off the screen, so that other output can follow. The destructor does so too.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  std::string line() const;
  void show_until_finished();

  const std::string what_;
  const std::int64_t total_;
  const Clock::time_point start_;
  mutable std::mutex mutex_;  // guards all below
  std::condition_variable changed_;
  std::int64_t done_ = 0;
  double share_ = 0;  // of the work that is done, if shares are known
  bool shares_known_ = false;
  double share_before_ = 0;  // of the work that was done before
  bool finished_ = false;
  std::thread shower_;  // only if the line is shown
};

// "12 s", "3 min", "5 h", "4 days", "years".
std::string duration_text(double seconds);

}  // namespace requad::program
