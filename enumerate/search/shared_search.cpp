#include "enumerate/search/shared_search.hpp"

#include <stdexcept>
#include <utility>

#include "mesh/threads/threads.hpp"

namespace requad::enumerate {

namespace {

// Each of them is the same share of the work.
std::vector<BacktrackingSearch> with_shares(std::vector<BacktrackingSearch> starts) {
  for (BacktrackingSearch& start : starts) start.set_share(1 / static_cast<double>(starts.size()));
  return starts;
}

}  // namespace

SharedSearch::SharedSearch(std::vector<BacktrackingSearch> starts, SearchControl& control)
    : starts_(with_shares(std::move(starts))), control_(control) {
  for (std::size_t i = 0; i < starts_.size(); ++i) subtrees_.push_back({static_cast<int>(i), starts_[i]});
}

void SharedSearch::run(int threads, const BacktrackingSearch::Visit& visit) {
  control_.stop = false;
  states_ = 0;
  const auto workers = static_cast<std::size_t>(threads::thread_count(threads));
  threads::run_on_threads(workers, threads, [&](std::size_t) { work(visit); });
}

void SharedSearch::work(const BacktrackingSearch::Visit& visit) {
  // The subtree is this worker's own copy, so that what two threads write lies apart.
  while (std::optional<Subtree> subtree = next_subtree()) {
    bool complete = false;
    try {
      complete = search_subtree(*subtree, visit);
    } catch (...) {  // the visit threw: the other workers must not wait for this one
      const std::scoped_lock lock(mutex_);
      --busy_;
      control_.stop = true;
      changed_.notify_all();
      throw;
    }
    const std::scoped_lock lock(mutex_);
    --busy_;
    states_ += subtree->search.states();
    if (!complete) subtrees_.push_back(*std::move(subtree));
    if (!complete || busy_ == 0) changed_.notify_all();
  }
}

// Waits for a subtree, and takes it. Nothing when the search is to stop, or is done.
std::optional<SharedSearch::Subtree> SharedSearch::next_subtree() {
  std::unique_lock lock(mutex_);
  while (!control_.stop) {
    if (!subtrees_.empty()) {
      Subtree subtree = subtrees_.back();
      subtrees_.pop_back();
      update_wanted();
      ++busy_;
      return subtree;
    }
    if (busy_ == 0) return std::nullopt;
    ++idle_, update_wanted();
    changed_.wait(lock);
    --idle_, update_wanted();
  }
  return std::nullopt;
}

bool SharedSearch::search_subtree(Subtree& subtree, const BacktrackingSearch::Visit& visit) {
  return subtree.search.run(visit, {wanted_, [&](const BacktrackingSearch& given) {
                                      add_subtree({subtree.start, given});
                                    }});
}

void SharedSearch::add_subtree(Subtree subtree) {
  const std::scoped_lock lock(mutex_);
  subtrees_.push_back(std::move(subtree));
  update_wanted();
  changed_.notify_one();
}

double SharedSearch::remaining_share() const {
  double sum = 0;
  for (const Subtree& subtree : subtrees_) sum += subtree.search.remaining_share();
  return sum;
}

std::vector<std::vector<int>> SharedSearch::remaining() const {
  std::vector<std::vector<int>> remaining;
  for (const Subtree& subtree : subtrees_) {
    remaining.push_back(subtree.search.guiding_path());
    remaining.back().insert(remaining.back().begin(), subtree.start);
  }
  return remaining;
}

void SharedSearch::set_remaining(const std::vector<std::vector<int>>& subtrees) {
  subtrees_.clear();
  for (const std::vector<int>& numbers : subtrees) {
    if (numbers.empty() || numbers[0] < 0 || static_cast<std::size_t>(numbers[0]) >= starts_.size())
      throw std::invalid_argument("there is no such start");
    Subtree subtree{numbers[0], starts_[static_cast<std::size_t>(numbers[0])]};
    subtree.search.go_to({numbers.begin() + 1, numbers.end()});
    subtrees_.push_back(std::move(subtree));
  }
}

}  // namespace requad::enumerate
