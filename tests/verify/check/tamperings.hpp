// What provers who cheat do to a certificate, each with the reason for which the checker must refuse it.
//
// After each tampering the numbers of configurations, merged vertices and edges, the names of meshes and the checksums
// are those that fit (proof.hpp).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/verify/check/proof.hpp"

namespace requad::tests {

struct Tampering {
  std::string name;
  std::string reason;  // parts of the checker's message, one of which must be there, with | between them
  // Does it to a region's file, and perhaps to others. Returns false if the region offers nothing to do it with.
  std::function<bool(Proof&, Proof::File&)> apply;
};
const std::vector<Tampering>& tamperings();

}  // namespace requad::tests
