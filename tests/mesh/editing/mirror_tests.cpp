// Symmetric meshes and edits on both sides. Symmetry is seen here by coordinates alone: faces as sets of points.
#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "mesh/editing/mirror.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/irregular/reduce.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/mesh/editing/workshop.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;

namespace {

using Point = std::array<double, 3>;

// The faces as cycles of points that start with the least one. `mirrored`: with -x for x, and turned round.
std::multiset<std::vector<Point>> faces_as_points(const QuadMesh& m, const Positions& positions, bool mirrored) {
  std::multiset<std::vector<Point>> faces;
  for (const FaceId f : m.faces()) {
    std::vector<Point> face;
    for (const VertexId v : m.corners(f)) {
      const Eigen::Vector3d& p = positions[v.slot()];
      face.push_back({mirrored ? 0 - p.x() : p.x() + 0, p.y(), p.z()});
    }
    if (mirrored) std::reverse(face.begin(), face.end());
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.insert(face);
  }
  return faces;
}
bool is_symmetric(const QuadMesh& m, const Positions& positions) {
  return faces_as_points(m, positions, false) == faces_as_points(m, positions, true);
}

const std::string kDome = REQUAD_SOURCE_DIR "/mesh/examples/figure-15.obj";

// Half of a mesh's coordinates may be off by rounding: makes it symmetric to the last bit.
Surface symmetric_surface(const std::string& path) {
  Surface s = read_surface(path, false);
  Editor editor(s.mesh, nullptr, &s.positions);
  std::optional<Mirror> mirror = Mirror::find(s.mesh, s.positions, Axis::x);
  REQUIRE(mirror);
  for (const VertexId v : s.mesh.vertices()) {
    if (!s.mesh.is_boundary(v)) continue;
    const Eigen::Vector3d p = s.positions[v.slot()];
    const VertexId w = mirror->image(v);
    s.positions[w.slot()] = v == w ? Eigen::Vector3d(0, p.y(), p.z()) : Eigen::Vector3d(-p.x(), p.y(), p.z());
  }
  mirror->symmetrise(editor, s.mesh.vertices());
  return s;
}

}  // namespace

TEST_CASE("images are found where a mesh is symmetric, and a vertex without one is named", "[mirror]") {
  const Surface dome = symmetric_surface(kDome);
  REQUIRE(is_symmetric(dome.mesh, dome.positions));
  const std::optional<Mirror> mirror = Mirror::find(dome.mesh, dome.positions, Axis::x);
  REQUIRE(mirror);
  for (const VertexId v : dome.mesh.vertices()) {
    const VertexId w = mirror->image(v);
    REQUIRE(w.valid());
    CHECK(mirror->image(w) == v);
    CHECK(mirror->side(dome.positions, v) == -mirror->side(dome.positions, w));
    CHECK(dome.positions[v.slot()].x() == -dome.positions[w.slot()].x());
  }
  VertexId without;
  CHECK_FALSE(Mirror::find(dome.mesh, dome.positions, Axis::z, &without));
  CHECK(without.valid());
  // The points are symmetric, but one edge is not.
  QuadMesh flipped = dome.mesh;
  for (const HalfEdgeId h : dome.mesh.half_edges()) {
    const double x = dome.positions[dome.mesh.origin(h).slot()].x(),
                 to = dome.positions[dome.mesh.target(h).slot()].x();
    if (std::min(x, to) > 0.05 && flip(flipped, h, Rotation::counter_clockwise) == Refusal::none) break;
  }
  REQUIRE_FALSE(flipped == dome.mesh);
  CHECK_FALSE(Mirror::find(flipped, dome.positions, Axis::x));
}

TEST_CASE("Law editing-22: edits of one side are followed on the other, or are refused and rolled back", "[mirror]") {
  const Surface dome = symmetric_surface(kDome);
  std::mt19937 random(7);
  std::map<BasicOperation::Kind, int> followed;
  int refused = 0;
  for (int round = 0; round < 40; ++round) {
    QuadMesh m = dome.mesh;
    Positions positions = dome.positions;
    Editor editor(m, nullptr, &positions);
    std::optional<Mirror> mirror = Mirror::find(m, positions, Axis::x);
    REQUIRE(mirror);
    for (int step = 0; step < 12; ++step) {
      const std::vector<BasicOperation> all = operations_inside(m);
      const std::size_t mark = editor.mark(), images = mirror->mark();
      const QuadMesh before = m;
      // One or several operations at once.
      std::vector<BasicOperation::Kind> kinds;
      for (unsigned i = 0; i <= random() % 3; ++i) {
        const BasicOperation operation = all[random() % all.size()];
        if (editor.run(operation).refusal == Refusal::none) kinds.push_back(operation.kind);
      }
      if (mirror->follow(editor, mark)) {
        for (const BasicOperation::Kind kind : kinds) ++followed[kind];
        mirror->symmetrise(editor, m.vertices());
        CHECK(is_symmetric(m, positions));
        CHECK(validate(m).empty());
      } else {
        ++refused;
        editor.roll_back(mark);
        mirror->roll_back(images);
        CHECK(m == before);
      }
    }
    editor.roll_back();
    mirror->roll_back(0);
    CHECK(m == dome.mesh);
    for (const VertexId v : m.vertices())
      CHECK(mirror->side(dome.positions, mirror->image(v)) == -mirror->side(dome.positions, v));
  }
  CHECK(refused > 10);
  for (const auto kind : {BasicOperation::Kind::flip_ccw, BasicOperation::Kind::flip_cw, BasicOperation::Kind::collapse,
                          BasicOperation::Kind::split})
    CHECK(followed[kind] > 20);
}

TEST_CASE("reduce --symmetry leaves a mesh that is its own mirror image", "[mirror][reduce][programs][real]") {
  const auto reduced = [](const std::string& arguments) {
    const tests::Outcome outcome = tests::call("edit", arguments);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return read_surface((tests::scratch() / "less.obj").string(), false);
  };
  Surface dome = symmetric_surface(kDome);
  tests::spill(tests::scratch() / "dome.obj", obj_text(dome.mesh, dome.positions));
  const Surface less = reduced("reduce dome.obj --symmetry x -o less.obj --script edits.txt");
  CHECK_FALSE(less.mesh == dome.mesh);
  CHECK(is_symmetric(less.mesh, less.positions));
  CHECK(tests::call("edit", "apply dome.obj edits.txt -o again.obj").code == 0);
  CHECK(tests::slurp(tests::scratch() / "again.obj") == tests::slurp(tests::scratch() / "less.obj"));
  const tests::Outcome refused = tests::call("edit", "reduce dome.obj --symmetry z -o other.obj");
  CHECK(refused.code == 2);
  CHECK(refused.err.find("requad-edit: reduce: --symmetry: IN is not symmetric in z: vertex ") == 0);
  if (const auto spot = tests::real_mesh("spot")) {
    const Surface cow = reduced("reduce " + *spot + " --symmetry x --max-deviation 0.01 -o less.obj --force");
    CHECK(is_symmetric(cow.mesh, cow.positions));
    const std::vector<VertexId> all = cow.mesh.vertices();
    CHECK(std::count_if(all.begin(), all.end(), [&](VertexId v) { return cow.mesh.valence(v) != 4; }) <= 16);
  }
}
