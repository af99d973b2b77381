// The report of a campaign as one HTML page that needs no other file and no program: with pictures, for a screen of any
// width, light or dark, and for paper.
#pragma once

#include <string>

#include "verify/campaign.hpp"
#include "verify/report/run_description.hpp"

namespace requad::verify {

// For each claim the page has the statement, what the check compares, the verdict, the totals by family, and the first
// kRowsShown rows of the table. Before these it has the run, a picture of each theorem's configurations that is among
// the claims, the regions, the counts and the times. Everything but the run and the times is the same for the same
// result. Draws about 40 small meshes, which takes about a second.
inline constexpr std::size_t kRowsShown = 60;
std::string report_html(const CampaignResult& result, const Ranges& ranges, const RunDescription& run = {});

}  // namespace requad::verify
