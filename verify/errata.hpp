// Slips in the paper's text, each found by comparing what is written with what moves find, and listed with the smallest
// instance that shows it. They are matters of wording: the theorems hold once read as the claims here read them.
#pragma once

#include <string>
#include <vector>

namespace requad::verify {

struct Erratum {
  std::string where;
  std::string written;   // what the text says
  std::string found;     // what is the case
  std::string instance;  // the region that shows it
};

// Looks for each slip in regular regions of increasing side; lists those for which an instance turns up.
std::vector<Erratum> find_errata();

}  // namespace requad::verify
