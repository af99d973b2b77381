#include "tests/verify/small_campaign.hpp"

#include "tests/support/sanitizers.hpp"
#include "tests/verify/falsifying.hpp"

namespace requad::tests {

using namespace verify;

Ranges small_ranges() {
  Ranges r;
  r.digon = {3, kSanitized ? 6 : 8};
  r.hexagon = {3, kSanitized ? 4 : 5};
  r.quad_perimeter = {8, 20};  // enough for claim A1
  r.other_perimeter = {4, kOtherPerimeter};
  return r;
}

CampaignResult run_small(int threads) {
  std::vector<const Claim*> all;
  std::set<Family> families;
  for (const Claim& c : claims()) {
    all.push_back(&c);
    families.insert(c.families.begin(), c.families.end());
  }
  return run_campaign(all, list_cases(small_ranges(), families), kAll, {.threads = threads, .quiet = true});
}

}  // namespace requad::tests
