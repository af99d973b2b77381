// A search that several threads share: the subtrees that are still to be searched, and the workers that search them.
//
// Subtrees differ in size by orders of magnitude, so the work is not divided beforehand. A worker without work waits
// until another one gives some away (work sharing, backtracking.hpp).
//
// Internal: not installed.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "enumerate/search/backtracking.hpp"

namespace requad::enumerate {

class SharedSearch {
 public:
  // The searches to be done, one for each partial mesh to start from. `control` must outlive this.
  SharedSearch(std::vector<BacktrackingSearch> starts, SearchControl& control);

  // Calls visit until nothing remains or SearchControl says stop, from several threads at once unless `threads` is 1.
  // If a visit throws, all threads stop, and run() rethrows the exception; remaining() is then undefined.
  void run(int threads, const BacktrackingSearch::Visit& visit);
  bool done() const { return subtrees_.empty(); }
  // The number of quads that the last run() placed.
  std::int64_t states() const { return states_; }

  // What remains, as numbers: for each subtree the index of its start, then its guiding path.
  std::vector<std::vector<int>> remaining() const;
  // An estimate of its share of all the work.
  double remaining_share() const;
  // Replaces what remains. Throws std::invalid_argument if the numbers are not such a list of this search.
  void set_remaining(const std::vector<std::vector<int>>& subtrees);

 private:
  struct Subtree {
    int start;
    BacktrackingSearch search;
  };
  void work(const BacktrackingSearch::Visit& visit);
  std::optional<Subtree> next_subtree();
  bool search_subtree(Subtree& subtree, const BacktrackingSearch::Visit& visit);
  void add_subtree(Subtree subtree);
  void update_wanted() { wanted_ = idle_ > subtrees_.size(); }

  const std::vector<BacktrackingSearch> starts_;
  SearchControl& control_;
  std::atomic<bool> wanted_{false};  // more workers wait than there are subtrees for them
  std::mutex mutex_;                 // guards all below
  std::condition_variable changed_;
  std::vector<Subtree> subtrees_;  // those that no worker has
  std::size_t busy_ = 0;           // workers that have one
  std::size_t idle_ = 0;           // workers that wait for one
  std::int64_t states_ = 0;
};

}  // namespace requad::enumerate
