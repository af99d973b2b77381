#include "enumerate/search/search_control.hpp"

#include <algorithm>

namespace requad::enumerate {

SearchControl::SearchControl(const SearchLimits& limits)
    : pruning(limits.pruning),
      most_faces(std::min(limits.faces.value_or(kMostFaces), kMostFaces)),
      progress(limits.progress) {
  if (limits.seconds) {
    deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*limits.seconds));
  }
}

bool SearchControl::should_stop(std::int64_t states, double share) {
  if (progress) progress(states, share, /*before=*/false);
  const auto passed = [now = Clock::now()](const std::optional<Clock::time_point>& time) {
    return time && now > *time;
  };
  if (passed(deadline) || passed(pause)) stop = true;
  return stop;
}

}  // namespace requad::enumerate
