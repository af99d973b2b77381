// Slips in the paper's text. Each is found by comparing the text with what moves or the search find, and comes with the
// smallest region that shows it. All but the last are matters of wording: the theorems hold as the claims here state
// them. The last is a sentence of section 1 that is false of three v5s.
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

// The slips for which a region is found. Looks for each in regions of increasing size, once: the first call takes about
// a second.
const std::vector<Erratum>& find_errata();

}  // namespace requad::verify
