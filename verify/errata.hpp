// Slips in the paper's text. Each is found by comparing the text with what moves find, and comes with the smallest
// region that shows it. All of them are matters of wording: the theorems hold as the claims here state them.
#pragma once

#include <string>
#include <vector>

namespace requad::verify {

struct Erratum {
  std::string where;
  std::string written;   // what the text says
  std::string found;     // what is true
  std::string instance;  // the region that shows it
};

// Looks for each slip in regular regions of increasing side. Lists the slips for which a region is found.
std::vector<Erratum> find_errata();

}  // namespace requad::verify
