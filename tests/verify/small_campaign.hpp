// A campaign of all claims on small ranges.
#pragma once

#include "verify/campaign.hpp"

namespace requad::tests {

inline constexpr int kOtherPerimeter = 16;  // enough for an instance of every claim
verify::Ranges small_ranges();
verify::CampaignResult run_small(int threads);

}  // namespace requad::tests
