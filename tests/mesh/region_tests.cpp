// Regions, separatrices and frames of pairs, all read off the mesh.
#include <cmath>

#include "mesh/irregular/pair_frame.hpp"
#include "mesh/topology/distances.hpp"
#include "mesh/topology/region.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/mesh/regions.hpp"

using namespace requad;
using namespace requad::mesh;

TEST_CASE("sides, turns and curvature (topology-10)", "[region]") {
  const Region g = tests::grid(5, 3);
  CHECK(region_problem(g).empty());
  CHECK(side_lengths(g) == std::vector<int>{5, 3, 5, 3});
  CHECK(total_turn(g.mesh) == 4);
  CHECK(total_index(g.mesh) == 0);
  // Equation 1 on closed meshes: the index is 4 chi, which is 8 for the cube and 0 for the torus.
  CHECK(total_index(tests::cube()) == 8);
  CHECK(total_index(tests::torus(3, 4)) == 0);
  const auto positions = boundary_positions(g);
  CHECK(positions[g.mesh.origin(g.root).slot()] == BoundaryPosition{0, 0});
  CHECK(positions[g.mesh.target(g.root).slot()] == BoundaryPosition{0, 1});
}

TEST_CASE("a region that is not convex is refused with the reason", "[region]") {
  // An L of three quads has a concave vertex.
  Region corner{QuadMesh::from_faces(8, tests::FaceList{{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}}), HalfEdgeId(0)};
  CHECK(region_problem(corner).find("concave") != std::string::npos);
  Region closed{tests::cube(), HalfEdgeId(0)};
  CHECK(region_problem(closed).find("root") != std::string::npos);
  Region two{QuadMesh::from_faces(8, tests::FaceList{{0, 1, 2, 3}, {4, 5, 6, 7}}), HalfEdgeId(0)};
  CHECK(region_problem(two).find("disk") != std::string::npos);
  Region side = tests::grid(3, 3);
  side.root = side.mesh.next_on_boundary(side.root);
  CHECK(region_problem(side).find("start a side") != std::string::npos);
}

TEST_CASE("separatrices run straight to the boundary", "[region]") {
  const Region g = tests::grid(5, 3);
  const Separatrix s = trace(g.mesh, g.mesh.find_half_edge(VertexId(1), VertexId(5)));
  CHECK(s.length() == 5);
  CHECK(s.end == Separatrix::End::boundary);
  CHECK(trace(tests::torus(4, 3), HalfEdgeId(0)).end == Separatrix::End::closed);
  CHECK(trace(tests::cube(), HalfEdgeId(0)).end == Separatrix::End::irregular);
}

TEST_CASE("frames have the right extents from both ends, and the right R_alpha", "[region]") {
  for (const tests::SmallRegion& entry : tests::small_regions(18, false)) {
    const QuadMesh& m = entry.region.mesh;
    const auto irregular = irregular_vertices(m);
    REQUIRE(irregular.size() == 2);
    const auto frames = find_frames(m, irregular[0], irregular[1]);
    REQUIRE(frames.size() == ((entry.shape.d1 == 0 || entry.shape.d2 == 0) ? 2U : 1U));
    for (const PairFrame& f : frames) {
      // The extents are the same seen from v1 and from v2. A segment has d1 = 0 or d2 = 0.
      REQUIRE(f.distance() == entry.shape.d1 + entry.shape.d2);
      if (!f.degenerate()) {
        REQUIRE(f.d1 == entry.shape.d1);
        REQUIRE(f.d2 == entry.shape.d2);
      }
      const PairFrame other = seen_from_other_end(m, f);
      REQUIRE(other.v1 == f.v2);
      REQUIRE(frame_at(m, other.first_leg, f.d1, f.d2) == other);
      REQUIRE(seen_from_other_end(m, other) == f);
      const auto faces = grid(m, f);
      REQUIRE(faces.has_value());
      REQUIRE(static_cast<int>(faces->size()) == f.d1 * f.d2);
      REQUIRE(static_cast<int>(outward(m, f).size()) == m.valence(f.v1) - 2);
      REQUIRE(graph_distance(m, f.v1, f.v2) == f.distance());
    }
  }
}
