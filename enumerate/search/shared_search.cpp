#include "enumerate/search/shared_search.hpp"

#include <stdexcept>
#include <string>

#include "mesh/threads/threads.hpp"

namespace requad::enumerate {

SharedSearch::SharedSearch(std::vector<BacktrackingSearch> starts, SharedLimits& shared)
    : starts_(std::move(starts)), shared_(shared) {
  for (std::size_t i = 0; i < starts_.size(); ++i) parts_.push_back({static_cast<int>(i), starts_[i]});
}

void SharedSearch::follow(int threads, const BacktrackingSearch::Visit& visit) {
  shared_.stop = false;
  states_ = 0;
  const auto workers = static_cast<std::size_t>(threads::thread_count(threads));
  threads::run_on_threads(workers, threads, [&](std::size_t) { work(visit); });
}

void SharedSearch::work(const BacktrackingSearch::Visit& visit) {
  std::unique_lock lock(mutex_);
  while (!shared_.stop) {
    if (parts_.empty()) {
      if (running_ == 0) break;
      ++idle_, tell_wanted();
      changed_.wait(lock);
      --idle_, tell_wanted();
      continue;
    }
    // A copy of this thread's own: what two threads write lies apart.
    Part part = parts_.back();
    parts_.pop_back();
    tell_wanted();
    ++running_;
    lock.unlock();
    const BacktrackingSearch::Sharing sharing{wanted_, [this, start = part.start](const BacktrackingSearch& given) {
                                                const std::scoped_lock handing(mutex_);
                                                parts_.push_back({start, given});
                                                tell_wanted();
                                                changed_.notify_one();
                                              }};
    bool done = true;
    try {
      done = part.filler.run(visit, sharing);
    } catch (...) {  // out of a visit: the others must not wait for this one
      lock.lock();
      --running_;
      shared_.stop = true;
      changed_.notify_all();
      throw;
    }
    lock.lock();
    --running_;
    states_ += part.filler.states();
    if (!done) parts_.push_back(std::move(part));
    if (!done || running_ == 0) changed_.notify_all();
  }
}

std::vector<std::vector<int>> SharedSearch::left() const {
  std::vector<std::vector<int>> left;
  for (const Part& part : parts_) {
    left.push_back(part.filler.trail());
    left.back().insert(left.back().begin(), part.start);
  }
  return left;
}

void SharedSearch::set_left(const std::vector<std::vector<int>>& parts) {
  parts_.clear();
  for (const std::vector<int>& numbers : parts) {
    if (numbers.empty() || numbers[0] < 0 || static_cast<std::size_t>(numbers[0]) >= starts_.size())
      throw std::invalid_argument("there is no such start");
    Part part{numbers[0], starts_[static_cast<std::size_t>(numbers[0])]};
    part.filler.go_to({numbers.begin() + 1, numbers.end()});
    parts_.push_back(std::move(part));
  }
}

}  // namespace requad::enumerate
