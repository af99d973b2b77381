// Two censuses of regions with a pair: that of the tests of mesh/, and the one that theory/ lists and enumerate/ glues.
#include <set>
#include <string>

#include "mesh/topology/signature.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/enumerate/census.hpp"
#include "tests/support/mesh/regions.hpp"

using namespace requad;

TEST_CASE("regions that are grown without theory/ are those that theory/ lists", "[census]") {
  for (const bool with_merged : {false, true}) {
    std::set<std::string> listed, grown;
    for (const tests::CensusEntry& entry : tests::census(18, with_merged)) {
      listed.insert(mesh::canonical_signature(entry.region.mesh));
    }
    for (const tests::SmallRegion& small : tests::small_regions(18, with_merged)) {
      if (small.shape.l1 == 4) continue;  // no pair merges into a regular vertex
      grown.insert(mesh::canonical_signature(small.region.mesh));
    }
    CHECK(listed.size() > 150);
    CHECK(listed == grown);
  }
}
