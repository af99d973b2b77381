// A folder of certificates and its MANIFEST.
//
//   requad manifest 2
//   family regular-digons sides 3..24            up to five lines, in the order of families() (region.hpp)
//   family other-digons perimeters 4..24
//   certificates 67
//   3-3-3-3.txt ed50a2f3                         a file for each region, and the CRC-32 of its bytes
//   ...
//   end
//
// The claim: every region of these families and sizes has as many configurations as the closed form says, and those
// that have any have the configurations and the moves of their certificates. So the files are those of all regions for
// which the closed form is not 0, in the order of for_each_region(), and no others. The recurrence counts the fillings
// of the other regions, too: they have none.
//
// The checksum tells an accident from a claim that is false. It does not keep a prover from cheating, who writes it
// himself: against him, every line of every file is checked. Files that the MANIFEST does not name are no part of it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verify/check/certificate.hpp"
#include "verify/check/region.hpp"

namespace check {

struct FamilyCounts {
  const Family* family;
  int first;
  int last;
  long long empty = 0;  // regions without configurations
  Counts counts;
};

// Checks a folder. Throws Rejected, with the file and the line before what is wrong, and Undecided.
std::vector<FamilyCounts> check_folder(const std::string& folder);

}  // namespace check
