// Geometry and smoothing: measures with known values, nearest points against all triangles, laws geometry-1 to
// geometry-5.
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>

#include "mesh/files/feature_edges.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/geometry/hausdorff_distance.hpp"
#include "mesh/geometry/nearest_points.hpp"
#include "mesh/geometry/smoothing.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;
using namespace requad::tests;
using Eigen::Vector3d;

namespace {

// The cube of side 2 about the origin. It does not depend on the vertex order of tests::cube(): adjacent vertices
// differ in one coordinate.
Positions cube_positions(const QuadMesh& m) {
  Positions p(8, Vector3d::Zero());
  const VertexId first(0);
  p[0] = {-1, -1, -1};
  // Seen from outside, the neighbours of the corner (-1, -1, -1) lie in the directions x, z, y counter-clockwise.
  const std::vector<VertexId> around = m.neighbours(first);
  const std::array<Vector3d, 3> axes{Vector3d(2, 0, 0), Vector3d(0, 0, 2), Vector3d(0, 2, 0)};
  for (std::size_t k = 0; k < 3; ++k) p[around[k].slot()] = p[0] + axes[k];
  for (std::size_t k = 0; k < 3; ++k) {
    for (const VertexId v : m.vertices()) {
      if (v != first && m.adjacent(v, around[k]) && m.adjacent(v, around[(k + 1) % 3]))
        p[v.slot()] = p[0] + axes[k] + axes[(k + 1) % 3];
    }
  }
  for (const VertexId v : m.vertices()) {
    if (p[v.slot()] == Vector3d::Zero()) p[v.slot()] = {1, 1, 1};
  }
  return p;
}

// A mesh of one quad.
struct Quad {
  QuadMesh mesh = QuadMesh::from_faces(4, std::vector<std::array<int, 4>>{{0, 1, 2, 3}});
  Positions positions;
};

// A grid of unit squares in the plane z = 0, whose inner vertices are moved at random.
Surface shaken_grid(int columns, int rows, double by, std::mt19937& random) {
  std::vector<std::array<int, 4>> faces;
  Surface s;
  std::uniform_real_distribution<double> d(-by, by);
  const int w = columns + 1;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      s.positions.emplace_back(i, j, 0);
      if (i > 0 && j > 0 && i < columns && j < rows) s.positions.back() += Vector3d{d(random), d(random), 0};
      if (i < columns && j < rows) faces.push_back({j * w + i, j * w + i + 1, (j + 1) * w + i + 1, (j + 1) * w + i});
    }
  }
  s.mesh = QuadMesh::from_faces(static_cast<int>(s.positions.size()), faces);
  return s;
}

std::vector<double> qualities(const QuadMesh& m, const Positions& positions) {
  std::vector<double> all;
  for (const FaceId f : m.faces()) all.push_back(scaled_jacobian(m, positions, f));
  return all;
}

}  // namespace

TEST_CASE("measures of single quads", "[geometry]") {
  Quad q;
  const FaceId f(0);
  q.positions = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}};
  CHECK(area(q.mesh, q.positions, f) == 3);
  CHECK(face_normal(q.mesh, q.positions, f) == Vector3d(0, 0, 1));
  CHECK(scaled_jacobian(q.mesh, q.positions, f) == 1);
  CHECK(aspect_ratio(q.mesh, q.positions, f) == 2);  // 3 * 8 / (4 * 3)
  CHECK(bounding_box_diagonal(q.mesh, q.positions) == Approx(std::sqrt(10)));
  // A rhombus with an angle of 60 degrees.
  q.positions = {{0, 0, 0}, {1, 0, 0}, {1.5, std::sqrt(3) / 2, 0}, {0.5, std::sqrt(3) / 2, 0}};
  CHECK(scaled_jacobian(q.mesh, q.positions, f) == Approx(std::sqrt(3) / 2));
  // A quad whose fourth vertex lies on the side of a triangle, then beyond that side. The mean normal stays.
  q.positions = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0.5, 0.5, 0}};
  CHECK(scaled_jacobian(q.mesh, q.positions, f) == Approx(0).margin(1e-15));
  q.positions[3] = {0.9, 0.3, 0};
  CHECK(scaled_jacobian(q.mesh, q.positions, f) < 0);
  CHECK(face_normal(q.mesh, q.positions, f).z() > 0);
  // The triangles lie inside the quad: the diagonal ends at the reflex corner.
  double sum = 0;
  for (const Triangle& t : triangles(q.mesh, q.positions, f)) sum += (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
  CHECK(sum == Approx(area(q.mesh, q.positions, f)));
  // A quad without area has no normal and no quality.
  q.positions.assign(4, Vector3d(1, 2, 3));
  CHECK(area(q.mesh, q.positions, f) == 0);
  CHECK(scaled_jacobian(q.mesh, q.positions, f) == 0);
  CHECK(face_normal(q.mesh, q.positions, f) == Vector3d(0, 0, 0));
  CHECK(std::isinf(aspect_ratio(q.mesh, q.positions, f)));
  // A bow-tie has no area either.
  q.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  CHECK(is_inverted(scaled_jacobian(q.mesh, q.positions, f)));
}

TEST_CASE("the cube has the right dihedral angles, mean curvature and features", "[geometry]") {
  const QuadMesh m = cube();
  Positions p = cube_positions(m);
  double volume = 0;
  for (const FaceId f : m.faces()) volume += face_centre(m, p, f).dot(area_vector(m, p, f)) / 3;
  if (volume < 0) {
    for (Vector3d& x : p) x = -x;
    volume = -volume;
  }
  REQUIRE(volume == Approx(8));
  for (const HalfEdgeId h : m.half_edges()) CHECK(dihedral_angle(m, p, h) == Approx(std::numbers::pi / 2));
  // The integral over all vertices is the sum of length * angle / 2 over the edges: 12 * 2 * (pi / 2) / 2.
  double total = 0;
  for (const VertexId v : m.vertices()) {
    CHECK(mean_curvature(m, p, v) == Approx(3 * 2 * (std::numbers::pi / 2) / 4));
    total += mean_curvature(m, p, v);
  }
  CHECK(total == Approx(6 * std::numbers::pi));
  CHECK(sharp_edges(m, p, 89).size() == 12);
  CHECK(sharp_edges(m, p, 91).empty());
  CHECK(feature_corners(m, sharp_edges(m, p, 89)).size() == 8);
  for (Vector3d& x : p) x = -x;  // inside out: valleys
  for (const HalfEdgeId h : m.half_edges()) CHECK(dihedral_angle(m, p, h) == Approx(-std::numbers::pi / 2));
  const Diagnosis d = diagnose(m, p);
  CHECK(d.genus == 0);
  CHECK(d.valences == std::map<int, int>{{3, 8}});
  CHECK(d.scaled_jacobian.least == Approx(1));
  CHECK(d.edge_length.mean == Approx(2));
}

TEST_CASE("diagnosis: genus of several components, boundary turns", "[geometry]") {
  // A torus, a sphere and a disk side by side.
  std::vector<std::array<int, 4>> faces;
  int vertices = 0;
  for (const QuadMesh& part : {torus(4, 5), cube(), grid(3, 2).mesh}) {
    for (auto f : part.compact_faces()) {
      for (int& v : f) v += vertices;
      faces.push_back(f);
    }
    vertices += part.vertex_count();
  }
  const QuadMesh m = QuadMesh::from_faces(vertices, faces);
  const Diagnosis d = diagnose(m, Positions(static_cast<std::size_t>(vertices), Vector3d::Zero()));
  CHECK(d.components == 3);
  CHECK(d.genus == 1);
  CHECK(d.boundary_loops == 1);
  CHECK(d.euler_characteristic == 0 + 2 + 1);
  CHECK(d.valences == std::map<int, int>{{3, 8}, {4, 22}});
  CHECK(d.turns == std::map<int, int>{{0, 6}, {1, 4}});
  CHECK(d.interior_irregular == 8);
  CHECK(d.boundary_irregular == 4);
  CHECK(d.degenerate == m.face_count());
  CHECK(d.inverted == m.face_count());
}

TEST_CASE("nearest point of a triangle against a fine search", "[geometry]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> d(-1, 1);
  const auto point = [&] { return Vector3d{d(random), d(random), d(random)}; };
  for (int trial = 0; trial < 300; ++trial) {
    Triangle t{point(), point(), point()};
    if (trial % 10 == 1) t[2] = t[0] + 0.3 * (t[1] - t[0]);  // flat
    if (trial % 10 == 2) t[1] = t[0];
    if (trial % 10 == 3) t[1] = t[2] = t[0];
    const Vector3d p = 2 * point();
    const double found = (nearest_on_triangle(t, p) - p).norm();
    double best = 1e9;
    constexpr int kSteps = 100;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j)
        best = std::min(best, ((i * t[0] + j * t[1] + (kSteps - i - j) * t[2]) / kSteps - p).norm());
    }
    CHECK(found <= best + 1e-12);
    CHECK(found >= best - 4.0 / kSteps);
    // The plane through the found point, at a right angle to the line to p, has the triangle behind it. So the point is
    // the nearest one.
    const Vector3d q = nearest_on_triangle(t, p);
    for (const Vector3d& corner : t) CHECK((corner - q).dot(p - q) <= 1e-12);
  }
}

TEST_CASE("SurfaceIndex finds what a search through all triangles finds (geometry-1)", "[geometry][real]") {
  std::mt19937 random(4);
  std::vector<Surface> surfaces{shaken_grid(9, 7, 0.4, random)};
  for (const char* name : {"bunny_qex", "fandisk_bommes", "botijo_miq"}) {
    if (const auto path = real_mesh(name)) surfaces.push_back(read_surface(*path, false));
  }
  for (const Surface& s : surfaces) {
    const SurfaceIndex index(s.mesh, s.positions);
    const PointIndex points(s.positions);
    const double size = bounding_box_diagonal(s.mesh, s.positions);
    std::normal_distribution<double> d(0, size);
    for (int trial = 0; trial < 200; ++trial) {
      // Points are on vertices, near the surface, or far away.
      const double off = trial % 3 == 0 ? 0 : trial % 3 == 1 ? 0.02 : 5;
      const Vector3d p = s.positions[random() % s.positions.size()] + off * Vector3d{d(random), d(random), d(random)};
      double best = 1e300;
      for (const FaceId f : s.mesh.faces()) {
        for (const Triangle& t : triangles(s.mesh, s.positions, f))
          best = std::min(best, (nearest_on_triangle(t, p) - p).norm());
      }
      const SurfaceIndex::Nearest found = index.nearest(p);
      CHECK(found.distance == best);
      CHECK((found.point - p).norm() == best);
      // A guess changes nothing, be it the nearest point, another one, or off the surface nearer to p than that.
      for (const Vector3d& guess : {found.point, s.positions[0], p, Vector3d((p + found.point) / 2)}) {
        const SurfaceIndex::Nearest guessed = index.nearest(p, guess);
        CHECK(guessed.distance == best);
        CHECK(guessed.point == found.point);
        CHECK(guessed.face == found.face);
      }
      double on_face = 1e300;
      for (const Triangle& t : triangles(s.mesh, s.positions, found.face))
        on_face = std::min(on_face, (nearest_on_triangle(t, p) - p).norm());
      CHECK(on_face == best);
      double nearest_vertex = 1e300;
      for (const Vector3d& x : s.positions) nearest_vertex = std::min(nearest_vertex, (x - p).norm());
      CHECK((points.nearest(p) - p).norm() == nearest_vertex);
    }
  }
}

TEST_CASE("Hausdorff distance (geometry-2)", "[geometry][real]") {
  std::mt19937 random(5);
  const Surface g = shaken_grid(6, 6, 0.3, random);
  Positions lifted = g.positions, slid = g.positions, spike = g.positions;
  for (Vector3d& p : lifted) p.z() += 0.5;
  for (Vector3d& p : slid) p.x() += 0.25;
  const VertexId inner = [&g] {
    for (const VertexId v : g.mesh.vertices()) {
      if (!g.mesh.is_boundary(v)) return v;
    }
    return VertexId();
  }();
  spike[inner.slot()].z() = 3;
  CHECK(hausdorff_distance({g.mesh, g.positions}, {g.mesh, g.positions}) == Approx(0).margin(1e-12));
  CHECK(hausdorff_distance({g.mesh, g.positions}, {g.mesh, lifted}) == Approx(0.5));
  CHECK(hausdorff_distance({g.mesh, g.positions}, {g.mesh, slid}) == Approx(0.25));  // a part sticks out at each end
  CHECK(hausdorff_distance({g.mesh, g.positions}, {g.mesh, spike}) == Approx(3));    // seen from one side only
  CHECK(hausdorff_distance({g.mesh, spike}, {g.mesh, g.positions}) == Approx(3));
  const SurfaceIndex flat(g.mesh, g.positions);
  CHECK(is_within({g.mesh, spike}, flat, 3.001));
  CHECK_FALSE(is_within({g.mesh, spike}, flat, 2.999));
  CHECK(is_within({g.mesh, g.positions}, flat, 1e-12));
  CHECK_FALSE(is_within({g.mesh, lifted}, flat, 0.499));
  if (const auto path = real_mesh("fandisk_bommes")) {
    const Surface s = read_surface(*path, false);
    Positions moved = s.positions;
    for (Vector3d& p : moved) p += Vector3d(0.01, 0, 0);
    CHECK(hausdorff_distance({s.mesh, s.positions}, {s.mesh, s.positions}) == Approx(0).margin(1e-12));
    const double distance = hausdorff_distance({s.mesh, s.positions}, {s.mesh, moved});
    CHECK(distance <= 0.01 + 1e-12);
    CHECK(distance >= 0.009);  // some side faces x nearly
  }
}

TEST_CASE("smoothing makes a disturbed grid regular again", "[smoothing]") {
  std::mt19937 random(6);
  for (const SmoothingWeights weights : {SmoothingWeights::uniform, SmoothingWeights::chord}) {
    Surface s = shaken_grid(7, 6, 0.3, random);
    SmoothingOptions options;
    options.weights = weights;
    options.iterations = 200;
    smooth(s.mesh, s.positions, s.mesh.vertices(), options);
    for (const double quality : qualities(s.mesh, s.positions)) CHECK(quality > 0.99);
  }
}

TEST_CASE("smoothing does not move fixed vertices (geometry-3)", "[smoothing]") {
  std::mt19937 random(7);
  const Surface s = shaken_grid(8, 8, 0.3, random);
  std::vector<VertexId> given;
  for (const VertexId v : s.mesh.vertices()) {
    if (v.index() % 3 != 0) given.push_back(v);
  }
  SmoothingOptions options;
  options.fixed = [](VertexId v) { return v.index() % 5 == 0; };
  const SurfaceIndex surface(s.mesh, s.positions);
  for (const bool project : {false, true}) {
    options.project_to = project ? &surface : nullptr;
    Positions p = s.positions;
    smooth(s.mesh, p, given, options);
    int moved = 0;
    for (const VertexId v : s.mesh.vertices()) {
      const bool may = !s.mesh.is_boundary(v) && v.index() % 3 != 0 && v.index() % 5 != 0;
      if (!may) CHECK(p[v.slot()] == s.positions[v.slot()]);
      moved += p[v.slot()] != s.positions[v.slot()] ? 1 : 0;
    }
    CHECK(moved > 20);
  }
  // There is nothing to do without vertices or without iterations.
  Positions p = s.positions;
  smooth(s.mesh, p, {}, options);
  options.iterations = 0;
  smooth(s.mesh, p, given, options);
  CHECK(p == s.positions);
}

TEST_CASE("smoothing with a guard makes no face worse (geometry-4), but without a guard it does", "[smoothing]") {
  // An L-shaped boundary pulls its inner vertices over the reflex corner. After a disturbance, some faces are inverted
  // at the start.
  std::mt19937 random(8);
  int inverted_without = 0, mended = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Surface s = shaken_grid(6, 6, 0.2 + 0.01 * trial, random);
    for (Vector3d& p : s.positions) {
      if (p.x() >= 3 && p.y() >= 3) p = Vector3d(3, 3, 0) + 0.05 * (p - Vector3d(3, 3, 0));
    }
    const std::vector<double> before = qualities(s.mesh, s.positions);
    for (const double guard : {0.0, 0.1}) {
      Positions p = s.positions;
      SmoothingOptions options;
      options.guard = guard;
      options.iterations = 20;
      smooth(s.mesh, p, s.mesh.vertices(), options);
      const std::vector<double> after = qualities(s.mesh, p);
      for (std::size_t f = 0; f < after.size(); ++f) {
        CHECK((after[f] > guard || after[f] >= before[f]));
        mended += before[f] <= 0 && after[f] > 0 ? 1 : 0;
      }
      options.guard.reset();
      p = s.positions;
      smooth(s.mesh, p, s.mesh.vertices(), options);
      const std::vector<double> free = qualities(s.mesh, p);
      for (std::size_t f = 0; f < free.size(); ++f) inverted_without += before[f] > 0 && free[f] <= 0 ? 1 : 0;
    }
  }
  CHECK(mended > 100);
  CHECK(inverted_without > 0);
}

TEST_CASE("smoothing with pull_to keeps vertices near the original ones", "[smoothing]") {
  std::mt19937 random(9);
  const Surface s = shaken_grid(8, 8, 0.45, random);
  const PointIndex original(s.positions);
  SmoothingOptions options;
  options.guard.reset();
  const auto farthest = [&](const Positions& p) {
    double most = 0;
    for (const Vector3d& x : p) most = std::max(most, (x - original.nearest(x)).norm());
    return most;
  };
  Positions p = s.positions;
  smooth(s.mesh, p, s.mesh.vertices(), options);
  CHECK(farthest(p) > 0.2);
  options.pull_to = &original;
  options.pull_distance = 0.1;
  p = s.positions;
  smooth(s.mesh, p, s.mesh.vertices(), options);
  CHECK(farthest(p) <= 0.1 + 1e-12);
  CHECK(farthest(p) > 0.09);
}

TEST_CASE("smoothing makes real meshes better, and keeps them on the surface and without inverted faces",
          "[smoothing][real]") {
  for (const char* name : {"spot", "bob", "blub", "bunny_qex", "botijo_miq", "armadillo_gel", "fandisk_bommes"}) {
    const auto path = real_mesh(name);
    if (!path) continue;
    INFO(name);
    const Surface s = read_surface(*path, false);
    const SurfaceIndex surface(s.mesh, s.positions);
    std::vector<bool> on_feature(s.positions.size(), false);
    for (const auto& [a, b] : sharp_edges(s.mesh, s.positions, 50)) on_feature[a.slot()] = on_feature[b.slot()] = true;
    SmoothingOptions options;
    options.project_to = &surface;
    options.fixed = [&on_feature](VertexId v) { return on_feature[v.slot()]; };
    Positions p = s.positions;
    smooth(s.mesh, p, s.mesh.vertices(), options);
    const Diagnosis before = diagnose(s.mesh, s.positions), after = diagnose(s.mesh, p);
    CHECK(after.scaled_jacobian.mean > before.scaled_jacobian.mean);
    const std::vector<double> old_quality = qualities(s.mesh, s.positions), new_quality = qualities(s.mesh, p);
    for (std::size_t f = 0; f < new_quality.size(); ++f) {
      if (new_quality[f] <= 0.1) CHECK(new_quality[f] >= old_quality[f]);
    }
    for (const VertexId v : s.mesh.vertices()) {
      if (on_feature[v.slot()]) CHECK(p[v.slot()] == s.positions[v.slot()]);
      CHECK(surface.nearest(p[v.slot()]).distance <= 1e-9 * before.bounding_box_diagonal);
    }
    // A second run gives the same positions, to the last bit.
    Positions again = s.positions;
    smooth(s.mesh, again, s.mesh.vertices(), options);
    CHECK(again == p);
  }
}
