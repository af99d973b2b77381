// Drawings of regions: outlines, and no quad turned over or lying on another.
#include <cmath>
#include <mutex>
#include <numbers>

#include "enumerate/generators.hpp"
#include "enumerate/search/search.hpp"
#include "mesh/geometry/drawing.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/support.hpp"

using namespace requad;
using namespace requad::mesh;
using Eigen::Vector2d;

namespace {

double area(const std::vector<Vector2d>& polygon) {
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    doubled += p.x() * q.y() - p.y() * q.x();
  }
  return doubled / 2;
}

// By other means than drawing_problem(): areas of quads, none negative, add up to that of the boundary; an angle of
// less than 180 degrees is the sign of a turn. The outline is where outline() puts it.
void check_drawing(const Region& region, double least_sine) {
  const QuadMesh& m = region.mesh;
  const std::vector<Vector2d> at = draw(region);
  double smallest = 0;
  REQUIRE(drawing_problem(region, at, &smallest).empty());
  REQUIRE(smallest > least_sine);
  std::vector<Vector2d> boundary;
  for (const HalfEdgeId h : boundary_loop(m, region.root)) boundary.push_back(at[m.origin(h).slot()]);
  REQUIRE(boundary == outline(side_lengths(region), turn(m, m.origin(region.root)) > 0));
  double sum = 0;
  for (const FaceId f : m.faces()) {
    std::vector<Vector2d> quad;
    for (const VertexId v : m.corners(f)) quad.push_back(at[v.slot()]);
    REQUIRE(area(quad) > 0.05);
    sum += area(quad);
    for (std::size_t k = 0; k < 4; ++k) {
      const VertexId v = m.corners(f)[k];
      if (!m.is_boundary(v) && m.valence(v) == 2) continue;
      REQUIRE(area({quad[k], quad[(k + 1) % 4], quad[(k + 3) % 4]}) > 0);
    }
  }
  REQUIRE(sum == Approx(area(boundary)));
}

}  // namespace

TEST_CASE("outlines: corners, lengths, even spacing", "[drawing]") {
  // A regular hexagon of side L: corners at distance L from the centre, 60 degrees apart, the first side lowest.
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
  // A rectangle is one; a triangle with sides 3, 4, 5 has a right angle.
  const std::vector<Vector2d> rectangle = outline({7, 2, 7, 2});
  CHECK(rectangle[0].x() == Approx(-3.5));
  CHECK(rectangle[9].y() == Approx(1));
  const std::vector<Vector2d> triangle = outline({3, 4, 5});
  CHECK((triangle[3] - triangle[0]).dot(triangle[7] - triangle[3]) == Approx(0).margin(1e-9));
  CHECK((triangle[7] - triangle[0]).norm() == Approx(5));
  // Sides in proportion, also where the circle's centre is outside; and a flat one is opened.
  const std::vector<Vector2d> trapezium = outline({9, 4, 4, 4});
  CHECK((trapezium[9] - trapezium[0]).norm() == Approx(9));
  CHECK((trapezium[13] - trapezium[9]).norm() == Approx(4));
  CHECK(area(outline({9, 3, 3, 3})) > 1);
  // A lens: mirror images above and below, every edge of length 1, corners at the ends.
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
  // Arcs as long as the sides, of which the chords are a little less.
  const std::vector<Vector2d> uneven = outline({6, 8});
  for (std::size_t i = 0; i < 14; ++i) CHECK((uneven[(i + 1) % 14] - uneven[i]).norm() == Approx(1).epsilon(0.01));
  // A drop's corner is a right angle, a circle has none.
  const std::vector<Vector2d> drop = outline({40});
  CHECK((drop[1] - drop[0]).dot(drop[39] - drop[0]) == Approx(0).margin(1e-9));
  CHECK(outline({12}, false)[3].norm() == Approx(outline({12}, false)[0].norm()));
}

TEST_CASE("drawings of all regular regions up to side 12 (geometry-7)", "[drawing]") {
  int digons = 0, hexagons = 0;
  for (int length = 2; length <= 12; ++length) {
    for (const theory::PairType type : {theory::kDigon, theory::kHexagon}) {
      const auto sides = theory::IntegerVector::Constant(type.side_count(), length);
      std::vector<theory::Configuration> configurations = theory::merged_configurations({type, sides});
      const auto pairs = theory::parameter_set({type, sides});
      configurations.insert(configurations.end(), pairs.begin(), pairs.end());
      for (const theory::Configuration& c : configurations) {
        check_drawing(enumerate::glue_region(type, c), 0.6);
        ++(type == theory::kDigon ? digons : hexagons);
      }
    }
  }
  // Theorems 7.2 and 7.3: N (N - 1) or N^2, N = L / 2, and one merged vertex for each even side.
  CHECK(digons == 0 + 1 + 2 + 4 + 6 + 9 + 12 + 16 + 20 + 25 + 30 + 6);
  CHECK(hexagons == 3 * (0 + 1 + 2 + 4 + 6 + 9 + 12 + 16 + 20 + 25 + 30) + 6);
}

TEST_CASE("drawings of other regions", "[drawing]") {
  for (const tests::CensusEntry& entry : tests::census(18, true)) check_drawing(entry.region, 0.3);
  // A lone vertex in a triangle, a pentagon and an octagon; three irregular vertices; a drop; a circle.
  const auto search_and_check = [](const enumerate::SearchProblem& problem, std::optional<int> faces, int at_least) {
    enumerate::SearchLimits limits;
    limits.threads = 1;
    limits.faces = faces;
    int count = 0;
    enumerate::search(problem, limits, [&](const enumerate::Filling& filling) {
      check_drawing(enumerate::region_of(filling), 0.05);
      ++count;
    });
    CHECK(count >= at_least);
  };
  search_and_check(enumerate::search_problem({4, 4, 4}, {3}), {}, 1);
  search_and_check(enumerate::search_problem({4, 4, 4, 4, 4}, {5}), {}, 1);
  search_and_check(enumerate::search_problem({3, 3, 3, 3, 3, 3, 3, 3}, {8}), {}, 4);
  search_and_check(enumerate::search_problem({4, 4, 4}, {3, 3, 5}), {}, 3);
  search_and_check(enumerate::search_problem({6}, {3, 3, 3}), {}, 1);
  search_and_check({{2, 2, 2, 2, 2, 2}, {3, 3, 3, 3}}, 14, 1);
}

TEST_CASE("what is not a drawing is named (geometry-6)", "[drawing]") {
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
  // A quad that crosses itself, counter-clockwise in the larger part.
  const Region one = tests::grid(1, 1);
  const auto order = boundary_loop(one.mesh, one.root);
  bad.assign(4, Vector2d::Zero());
  const std::array<Vector2d, 4> crossed{Vector2d(0, 0), Vector2d(4, 0), Vector2d(0.5, 2), Vector2d(3, -0.2)};
  for (std::size_t i = 0; i < 4; ++i) bad[one.mesh.origin(order[i]).slot()] = crossed[i];
  CHECK(drawing_problem(one, bad).find("quad") == 0);
  // A long fan, where whole steps would turn quads over.
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
  // A spiral of quads that covers a part of the plane twice, though no quad is turned over.
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
