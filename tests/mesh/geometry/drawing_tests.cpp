// Drawings of regions: their outlines, and that no quad is turned over or lies on another one.
#include <cmath>

#include "mesh/geometry/drawing.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/drawings.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/mesh/regions.hpp"

using namespace requad;
using namespace requad::mesh;
using Eigen::Vector2d;
using requad::tests::area;

TEST_CASE("outlines have corners, lengths and even spacing", "[drawing]") {
  // A regular hexagon of side L has its corners at distance L from the centre, 60 degrees apart. The first side is the
  // lowest one.
  const std::vector<Vector2d> hexagon = outline({4, 4, 4, 4, 4, 4});
  REQUIRE(hexagon.size() == 24);
  for (std::size_t i = 0; i < 24; i += 4) {
    CHECK(hexagon[i].norm() == Approx(4));
    CHECK((hexagon[(i + 4) % 24] - hexagon[i]).norm() == Approx(4));
    CHECK((hexagon[i + 1] - hexagon[i]).norm() == Approx(1));
  }
  CHECK(hexagon[0].x() == Approx(-2));
  CHECK(hexagon[0].y() == Approx(-2 * std::sqrt(3)));
  CHECK(hexagon[4].y() == Approx(-2 * std::sqrt(3)));
  // A rectangle stays a rectangle. A triangle with sides 3, 4, 5 has a right angle.
  const std::vector<Vector2d> rectangle = outline({7, 2, 7, 2});
  CHECK(rectangle[0].x() == Approx(-3.5));
  CHECK(rectangle[9].y() == Approx(1));
  const std::vector<Vector2d> triangle = outline({3, 4, 5});
  CHECK((triangle[3] - triangle[0]).dot(triangle[7] - triangle[3]) == Approx(0).margin(1e-9));
  CHECK((triangle[7] - triangle[0]).norm() == Approx(5));
  // The sides are in proportion, even if the centre of the circle lies outside. An outline that would be flat is
  // opened.
  const std::vector<Vector2d> trapezium = outline({9, 4, 4, 4});
  CHECK((trapezium[9] - trapezium[0]).norm() == Approx(9));
  CHECK((trapezium[13] - trapezium[9]).norm() == Approx(4));
  CHECK(area(outline({9, 3, 3, 3})) > 1);
  // A digon is a lens. Its lower half mirrors the upper one, every edge has length 1, and the corners are at the ends.
  for (int length = 2; length <= 9; ++length) {
    const std::vector<Vector2d> lens = outline({length, length});
    for (std::size_t i = 0; i < lens.size(); ++i) {
      const Vector2d& mirrored = lens[(lens.size() - i) % lens.size()];
      CHECK(lens[i].x() == Approx(mirrored.x()).margin(1e-9));
      CHECK(lens[i].y() == Approx(-mirrored.y()).margin(1e-9));
      CHECK((lens[(i + 1) % lens.size()] - lens[i]).norm() == Approx(1));
      CHECK(lens[i].x() >= lens[0].x());
    }
  }
  // Unequal sides become arcs of their lengths. The chords are a little shorter.
  const std::vector<Vector2d> uneven = outline({6, 8});
  for (std::size_t i = 0; i < 14; ++i) CHECK((uneven[(i + 1) % 14] - uneven[i]).norm() == Approx(1).epsilon(0.01));
  // A drop has one corner, a right angle. A circle has none.
  const std::vector<Vector2d> drop = outline({40});
  CHECK((drop[1] - drop[0]).dot(drop[39] - drop[0]) == Approx(0).margin(1e-9));
  CHECK(outline({12}, false)[3].norm() == Approx(outline({12}, false)[0].norm()));
}

TEST_CASE("drawings of small regions", "[drawing]") {
  for (const tests::SmallRegion& small : tests::small_regions(16, true)) tests::check_drawing(small.region, 0.3);
}

TEST_CASE("positions that are no drawing are refused (geometry-6)", "[drawing]") {
  const Region grid = tests::grid(3, 3);
  const std::vector<Vector2d> good = draw(grid);
  double smallest = 0;
  REQUIRE(drawing_problem(grid, good, &smallest).empty());
  CHECK(smallest == Approx(1));  // squares
  const std::size_t inner = 5, corner = 0;
  auto bad = good;
  bad[inner] = good[2 * inner];  // onto the other end of the diagonal
  CHECK(drawing_problem(grid, bad).find("quad") == 0);
  bad = good;
  bad[inner] += Vector2d(0.9, 0.9);  // a dart, still simple: one reflex angle
  CHECK(drawing_problem(grid, bad, &smallest).empty());
  CHECK(smallest < 0);
  bad = good;
  for (Vector2d& p : bad) p.x() = -p.x();
  CHECK(!drawing_problem(grid, bad).empty());
  bad = good;
  bad[corner] = good[15] + Vector2d(1, 1);
  CHECK(!drawing_problem(grid, bad).empty());
  // This quad crosses itself, and its larger part is counter-clockwise.
  const Region one = tests::grid(1, 1);
  const auto order = boundary_loop(one.mesh, one.root);
  bad.assign(4, Vector2d::Zero());
  const std::array<Vector2d, 4> crossed{Vector2d(0, 0), Vector2d(4, 0), Vector2d(0.5, 2), Vector2d(3, -0.2)};
  for (std::size_t i = 0; i < 4; ++i) bad[one.mesh.origin(order[i]).slot()] = crossed[i];
  CHECK(drawing_problem(one, bad).find("quad") == 0);
  // In this long fan, full steps of the optimisation would turn quads over.
  const Region wide = tests::grid(30, 6);
  std::vector<Vector2d> fan(static_cast<std::size_t>(wide.mesh.vertex_capacity()));
  for (const VertexId v : wide.mesh.vertices()) {
    const double x = v.index() / 7 / 30.0, y = v.index() % 7 / 6.0;
    fan[v.slot()] = {x, y * (0.02 + x * x)};
  }
  const auto before = fan;
  draw_inside(wide.mesh, fan);
  CHECK(drawing_problem(wide, fan).empty());
  CHECK(fan[7] == before[7]);  // on the boundary
  // This spiral of quads covers a part of the plane twice, but no quad is turned over.
  tests::FaceList strip;
  std::vector<Vector2d> at;
  for (int i = 0; i <= 20; ++i) {
    const double angle = 0.4 * i, radius = 3 - 0.04 * i;
    at.emplace_back(2 * std::cos(angle), 2 * std::sin(angle));
    at.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    if (i > 0) strip.push_back({2 * i - 2, 2 * i - 1, 2 * i + 1, 2 * i});
  }
  Region spiral{QuadMesh::from_faces(42, strip), HalfEdgeId(0)};
  CHECK(drawing_problem(spiral, at) == "the boundary crosses itself");
}
