#include "mesh/irregular/reduction_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace requad::mesh {

namespace {

using Reason = ReductionMemory::Reason;

// Fits with more effort of a cancellation that is not acceptable: usually, and with care.
constexpr int kRescues = 2;
constexpr int kCarefulRescues = 4;
// how_far_from_acceptable(): beyond it no fit helps, neither for good quads nor with more effort.
constexpr double kHopeless = 1.5;
constexpr double kHopelessStraightened = 0.7;
constexpr int kMostOnTheWay = 10;  // inverted quads, beside those before

}  // namespace

// Whether the affected region is as good as it must be. If not, reason_ says why.
bool ReductionJudge::is_acceptable() {
  const ReductionValue change = values_.change(fit_.affected());
  inverted_ = options_.allow_inverted ? 0 : std::max(0, change.inverted) / 4;
  if (change.inside > 0) {
    reason_ = Reason::inward;
  } else if (is_worn(change)) {
    reason_ = Reason::worn;
  } else if (!options_.allow_inverted && change.inverted > 0) {
    reason_ = Reason::folded;
  } else if (fit_.is_too_far()) {
    reason_ = Reason::too_far;
  } else {
    return true;
  }
  return false;
}

// Whether the mean quality of all faces falls too low.
bool ReductionJudge::is_worn(const ReductionValue& change) const {
  if (options_.max_quality_loss < 0) return false;
  const double now = values_.mean_quality_after(change);
  return now < values_.mean_quality() && now < fit_.input_quality() - options_.max_quality_loss;
}

bool ReductionJudge::accepts(std::size_t mark, bool careful) {
  fit_.fit_made(mark);
  if (is_acceptable()) return true;
  if (reason_ == Reason::inward || reason_ == Reason::worn || options_.sweeps == 0) return false;
  if (how_far_from_acceptable() > kHopeless) return false;
  if (is_acceptable_straightened()) return true;
  double trouble = std::numeric_limits<double>::infinity();
  const int rescues = careful ? kCarefulRescues : kRescues;
  const double hopeless = careful ? kHopeless : kHopelessStraightened;
  for (int rescue = 0; rescue < rescues; ++rescue) {
    const double left = how_far_from_acceptable();
    if (left > hopeless || left > 0.95 * trouble) break;
    trouble = left;
    fit_.fit_again(mark);
    if (is_acceptable() || is_acceptable_straightened()) return true;
  }
  return false;
}

bool ReductionJudge::is_lost(std::size_t mark) {
  if (options_.allow_inverted) return false;
  reason_ = Reason::folded;
  fit_.look_since(mark, 1);
  return values_.change(fit_.affected()).inverted / 4 > kMostOnTheWay;
}

bool ReductionJudge::is_acceptable_straightened() {
  if (reason_ != Reason::folded) return false;
  fit_.straighten();
  return is_acceptable();
}

// Too large a deviation, by how many bounds, and a tenth for each quad that is inverted.
double ReductionJudge::how_far_from_acceptable() const {
  const double bound = fit_.bound();
  const double far = bound > 0 && std::isfinite(bound) ? std::max(0.0, fit_.deviation() / bound - 0.9) : 0;
  return far + inverted_ / 10.0;
}

}  // namespace requad::mesh
