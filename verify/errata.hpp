// Slips in the paper's text. Each is found by comparing the text with what moves or the search find, and comes with the
// smallest region that shows it. The counts of the theorems stand. The parameter sets of Theorems 7.2 and 7.3 are too large
// as they are written, and two sentences are false in some cases, one of section 6 and one of section 1.
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

// One erratum to a paragraph: where, what is written, what is true, and the region.
std::string errata_text();

}  // namespace requad::verify
