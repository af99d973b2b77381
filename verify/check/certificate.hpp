// The certificate of one region: verify/certificate.hpp describes the format. What it shows, if it holds:
//   - The meshes are all fillings of the region with the pair, and all with the merged vertex: each is a quadrangulated
//     disk with these sides and irregular vertices (disk.hpp), no two are isomorphic by a map that fixes the boundary,
//     and there are as many as the recurrence over holes counts (fillings.hpp).
//   - Their number is the one of the closed form of the region's family (region.hpp).
//   - Their labels are those that their separatrices have (labels.hpp).
//   - The edges are all moves of all configurations, each once and each a single move (moves.hpp). Its script leads
//     from one mesh to the other by legal operations, and changes the label as the step says.
//   - The moves connect all meshes.
#pragma once

#include "verify/check/fillings.hpp"
#include "verify/check/reading.hpp"
#include "verify/check/region.hpp"

namespace check {

struct Counts {
  long long regions = 0;
  long long configurations = 0;
  long long merged = 0;
  long long edges = 0;
};

// Checks the certificate of a region; of any region if `expected` is null. Throws Rejected if it does not hold. Linear
// in the length of the file, beside the count.
Counts check_certificate(Lines& lines, const Region* expected, FillingCounter& counter);

// Throws Rejected unless the closed form gives this number, which is what the recurrence counts.
void check_closed_form(const Region& region, std::uint64_t fillings);

}  // namespace check
