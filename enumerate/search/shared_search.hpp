// What is left of a search: fillers, each with work of its own, and the threads that do it.
//
// The parts of a search differ by orders of magnitude, so none is cut to size beforehand: whoever has nothing to do waits
// for what the others hand over of theirs (backtracking.hpp).
//
// Internal: not installed.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

#include "enumerate/search/backtracking.hpp"

namespace requad::enumerate {

class SharedSearch {
 public:
  // The fillers that a search starts with, each after its open_hole().
  SharedSearch(std::vector<BacktrackingSearch> starts, SharedLimits& shared);

  // Calls visit, from several threads at once unless `threads` is 1, until nothing is left or SharedLimits says stop. An
  // exception out of a visit ends all threads and comes through; what is left is unknown then.
  void follow(int threads, const BacktrackingSearch::Visit& visit);
  bool empty() const { return parts_.empty(); }
  // How many quads the last follow() placed.
  std::int64_t states() const { return states_; }

  // All that is left, as numbers: for each part that of its start, then its trail.
  std::vector<std::vector<int>> left() const;
  // Makes that what is left. Throws std::invalid_argument if the numbers do not say so.
  void set_left(const std::vector<std::vector<int>>& parts);

 private:
  struct Part {
    int start;
    BacktrackingSearch filler;
  };
  void work(const BacktrackingSearch::Visit& visit);
  void tell_wanted() { wanted_ = idle_ > parts_.size(); }

  const std::vector<BacktrackingSearch> starts_;
  SharedLimits& shared_;
  std::atomic<bool> wanted_{false};
  std::mutex mutex_;  // of all below
  std::condition_variable changed_;
  std::vector<Part> parts_;  // that no thread works on
  std::size_t running_ = 0;  // threads with a part
  std::size_t idle_ = 0;     // threads that wait for one
  std::int64_t states_ = 0;
};

}  // namespace requad::enumerate
