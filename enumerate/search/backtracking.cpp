#include "enumerate/search/backtracking.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace requad::enumerate {

namespace {

// The number of states after which a search asks whether it is to stop or to give work away.
constexpr std::int64_t kStatesBetweenLooks = 1024;

}  // namespace

BacktrackingSearch::BacktrackingSearch(PartialMesh start, SearchControl& control)
    : mesh_(std::move(start)), control_(&control), levels_(1) {
  list_children();
}

void BacktrackingSearch::set_share(double share) {
  levels_.front().share *= share / share_;
  share_ = share;
}

double BacktrackingSearch::remaining_share() const {
  double sum = 0;
  for (std::size_t i = 0; i < levels_.size(); ++i) sum += untried(i) * levels_[i].share;
  return sum;
}

// --- the search tree -------------------------------------------------------------------------------------------------

int BacktrackingSearch::untried(std::size_t level) const {
  const auto end = level + 1 < levels_.size() ? levels_[level + 1].first : static_cast<int>(placements_.size());
  return end - levels_[level].first;
}

void BacktrackingSearch::list_children() {
  const std::size_t last = levels_.size() - 1;
  Level& level = levels_[last];
  level.first = static_cast<int>(placements_.size());
  if (mesh_.has_hole()) level.v = list_placements(mesh_, *control_, placements_);
  level.share = (last > 0 ? levels_[last - 1].share : share_) / std::max(untried(last), 1);
}

// Goes to a child of the last level, and leaves only the first `untried` of the others to be tried there.
void BacktrackingSearch::descend(int chosen, int untried) {
  Level& level = levels_.back();
  level.chosen = chosen;
  mesh_.place(level.v, placements_[static_cast<std::size_t>(level.first + chosen)]);
  placements_.erase(placements_.begin() + level.first + untried, placements_.end());
  levels_.emplace_back();
  list_children();
}

// Goes back to the parent. Precondition: nothing is untried on the last level, which is not the root.
void BacktrackingSearch::ascend() {
  mesh_.undo();
  levels_.pop_back();
}

bool BacktrackingSearch::run(const Visit& visit, const WorkSharing& sharing) {
  states_ = 0;
  finished_ = 0;
  for (;;) {
    if (const int count = untried(levels_.size() - 1); count > 0) {
      descend(count - 1, count - 1);
      if (!mesh_.has_hole() && mesh_.budget().empty() && visit) visit(mesh_.filling());
      if (untried(levels_.size() - 1) == 0) finished_ += levels_.back().share;  // a leaf
      if (++states_ % kStatesBetweenLooks == 0) {
        if (control_->should_stop(kStatesBetweenLooks, std::exchange(finished_, 0))) return false;
        if (sharing.wanted.load(std::memory_order_relaxed)) donate_work(sharing);
      }
    } else if (levels_.size() > 1) {
      ascend();
    } else {
      control_->should_stop(states_ % kStatesBetweenLooks,
                            finished_);  // the rest is reported; there is nothing to stop
      return true;
    }
  }
}

// --- work sharing and guiding paths ----------------------------------------------------------------------------------

void BacktrackingSearch::donate_work(const WorkSharing& sharing) {
  std::size_t i = 0;
  while (i + 1 < levels_.size() && untried(i) == 0) ++i;
  const int given = untried(i);
  if (given == static_cast<int>(placements_.size())) return;  // this search would have none left
  BacktrackingSearch other = *this;
  other.placements_.resize(static_cast<std::size_t>(given));
  while (other.levels_.size() > i + 1) other.ascend();
  placements_.erase(placements_.begin(), placements_.begin() + given);
  for (++i; i < levels_.size(); ++i) levels_[i].first -= given;
  sharing.donate(other);
}

BacktrackingSearch::GuidingPath BacktrackingSearch::guiding_path() const {
  GuidingPath path;
  for (std::size_t i = 0; i + 1 < levels_.size(); ++i) path.insert(path.end(), {levels_[i].chosen, untried(i)});
  path.push_back(untried(levels_.size() - 1));
  return path;
}

void BacktrackingSearch::go_to(const GuidingPath& path) {
  if (path.size() % 2 == 0) throw std::invalid_argument("a guiding path has an odd number of numbers");
  const auto check = [](int number, int low, int high) {
    if (number < low || number > high) throw std::invalid_argument("no such placement: " + std::to_string(number));
    return number;
  };
  placements_.clear();
  while (levels_.size() > 1) ascend();
  list_children();
  for (std::size_t i = 0; i + 1 < path.size(); i += 2) {
    const int chosen = check(path[i], 0, untried(levels_.size() - 1) - 1);
    descend(chosen, check(path[i + 1], 0, chosen));
  }
  const int rest = check(path.back(), 0, untried(levels_.size() - 1));
  placements_.erase(placements_.begin() + levels_.back().first + rest, placements_.end());
}

}  // namespace requad::enumerate
