// The census of small meshes, on which other tests of mesh/ test every case. Published counts show that none is
// missing.
#include <map>
#include <set>
#include <string>

#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/disks.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/mesh/regions.hpp"

using namespace requad;
using namespace requad::mesh;

TEST_CASE("the census of small disks is complete", "[census]") {
  // These are OEIS A000139 from its third term, and Fuss-Catalan numbers where there is no interior vertex.
  CHECK(tests::number_of_disks(4, 1) == 1);
  CHECK(tests::number_of_disks(4, 2) == 2);
  CHECK(tests::number_of_disks(4, 3) == 6);
  CHECK(tests::number_of_disks(4, 4) == 22);
  CHECK(tests::number_of_disks(4, 5) == 91);
  CHECK(tests::number_of_disks(4, 6) == 408);
  CHECK(tests::number_of_disks(8, 3) == 12);
  CHECK(tests::number_of_disks(10, 4) == 55);
  // In a hexagon, one interior vertex has valence 3 in two ways, or valence 2 in either quad beside a diagonal.
  CHECK(tests::number_of_disks(6, 3) == 2 + 3 * 4);
  for (const auto& [perimeter, faces] : {std::pair{4, 6}, std::pair{6, 5}, std::pair{8, 5}, std::pair{10, 5}}) {
    std::map<int, std::int64_t> found;
    for (const Region& disk : tests::small_disks(perimeter, faces)) {
      REQUIRE(validate(disk.mesh).empty());
      REQUIRE(static_cast<int>(boundary_loop(disk.mesh, disk.root).size()) == perimeter);
      ++found[disk.mesh.face_count()];
    }
    for (const auto& [f, count] : found) {
      INFO("perimeter " << perimeter << ", " << f << " quads");
      CHECK(count == tests::number_of_disks(perimeter, f));
    }
    CHECK(found.rbegin()->first == faces);
  }
}

TEST_CASE("the regions of the census are valid, different, and of the stated shapes", "[census]") {
  std::set<std::string> seen;
  for (const tests::SmallRegion& small : tests::small_regions(16, true, tests::Roots::each_corner)) {
    REQUIRE(validate(small.region.mesh).empty());
    REQUIRE(region_problem(small.region).empty());
    REQUIRE(boundary_loop(small.region.mesh, small.region.root).size() <= 16);
    const int l1 = small.shape.l1, l2 = small.shape.l2;
    std::map<int, int> valences;
    if (l1 != 4) ++valences[l1];
    if (l2 != 0) ++valences[l2];
    REQUIRE(tests::irregular_valences(small.region.mesh) == valences);
    REQUIRE(seen.insert(signature(small.region)).second);
  }
  // Side lengths worked out by hand. The first region has two strips round an adjacent 3-5 pair. The edge of the pair
  // lengthens two of the four sides.
  CHECK(side_lengths(tests::pair_region({3, 5, 1, 0}, {2, 2, 2, 2})) == std::vector<int>{5, 4, 4, 5});
  CHECK(side_lengths(tests::star({1, 2, 3, 4, 5})) == std::vector<int>{7, 4, 6, 8, 5});
}
