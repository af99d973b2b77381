// What all branches of one search share: the pruning rules, the limits, and the flags by which the search stops.
//
// Internal: not installed.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "enumerate/search/search.hpp"

namespace requad::enumerate {

struct SearchControl {
  using Clock = std::chrono::steady_clock;

  // The time limit of `limits` starts here.
  explicit SearchControl(const SearchLimits& limits);

  SearchPruning pruning;
  int most_faces;                             // fillings with more faces are not looked for
  std::optional<Clock::time_point> deadline;  // the search ends then
  std::optional<Clock::time_point> pause;     // the search stops then, so that its journal can be written
  SearchProgress progress;
  std::atomic<bool> stop{false};            // every thread stops when it next looks
  std::atomic<bool> face_limit_cut{false};  // a branch ended at most_faces

  // Reports this many more states, and this share of the work. Returns whether the search is to stop. Sets `stop` if one of the two times has
  // passed. Safe from any thread if `progress` is.
  bool should_stop(std::int64_t states, double share);
};

}  // namespace requad::enumerate
