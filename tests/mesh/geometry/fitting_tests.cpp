// Correspondences, quad shapes and fits.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Eigenvalues>

#include "mesh/editing/editor.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/geometry/correspondence.hpp"
#include "mesh/geometry/fitting.hpp"
#include "mesh/geometry/in_chunks.hpp"
#include "mesh/geometry/quad_shape.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;
using Eigen::Vector3d;

namespace {

// A bumpy sheet: z = sin x cos y over a grid.
struct BumpySheet {
  QuadMesh mesh;
  Positions positions;
};
BumpySheet bumpy_sheet(int width, int height) {
  BumpySheet result{tests::grid(width, height).mesh, {}};
  result.positions.resize(static_cast<std::size_t>(result.mesh.vertex_capacity()));
  for (const VertexId v : result.mesh.vertices()) {
    const double x = v.index() / (height + 1), y = v.index() % (height + 1);  // as tests::grid() numbers them
    result.positions[v.slot()] = {x, y, std::sin(x) * std::cos(y)};
  }
  return result;
}

// Every home with the order of each face's samples, as numbers that can be compared.
std::vector<double> state(const QuadMesh& m, const Correspondence& homes) {
  std::vector<double> all;
  for (int f = 0; f < m.face_capacity(); ++f) {
    homes.for_each_sample(FaceId(f), [&](std::size_t i) {
      all.push_back(static_cast<double>(i));
      all.insert(all.end(), homes.home(i).weights.begin(), homes.home(i).weights.end());
    });
    all.push_back(-1);
  }
  return all;
}

// Makes legal collapses, splits and flips at random.
int edit_at_random(Editor& editor, int wanted, unsigned seed) {
  std::mt19937 random(seed);
  int made = 0;
  for (int attempt = 0; attempt < 100 * wanted && made < wanted; ++attempt) {
    const std::vector<HalfEdgeId> all = editor.mesh().half_edges();
    const HalfEdgeId h = all[random() % all.size()];
    BasicOperation op{BasicOperation::Kind::flip_ccw, h, {}, 0};
    const auto kind = random() % 3;
    if (kind == 1) op.kind = BasicOperation::Kind::collapse;
    if (kind == 2) {
      op = {BasicOperation::Kind::split, h, h, 0};
      if (editor.mesh().is_boundary(editor.mesh().origin(h))) continue;
      for (unsigned i = 0; i < 1 + random() % 3; ++i) op.last = editor.mesh().ccw(op.last);
      if (op.last == h) continue;
    }
    if (editor.run(op).refusal == Refusal::none) ++made;
  }
  return made;
}

}  // namespace

TEST_CASE("a loop in chunks makes each round once", "[fitting]") {
  for (const std::size_t count : {0U, 1U, 7U, 16U, 17U, 100U, 1000U}) {
    std::vector<int> visits(count);
    std::size_t tasks = 0;
    const RunTasks counted = [&](std::size_t n, const std::function<void(std::size_t)>& task) {
      tasks = n;
      tests::backwards(n, task);
    };
    for (const RunTasks& run : {RunTasks(), RunTasks(counted)}) {
      std::fill(visits.begin(), visits.end(), 0);
      in_chunks(run, count, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) ++visits[i];
      });
      CHECK(std::count(visits.begin(), visits.end(), 1) == static_cast<std::ptrdiff_t>(count));
    }
    CHECK((tasks > 1) == (count >= 16));  // a short loop is not worth it
  }
}

TEST_CASE("Law geometry-11: a fit is the same in whatever order its tasks run", "[fitting]") {
  for (const bool joint : {false, true}) {
    std::vector<Positions> results;
    std::vector<std::vector<double>> homes_then;
    for (const bool divided : {false, true}) {
      const BumpySheet sheet = bumpy_sheet(20, 18);
      QuadMesh m = sheet.mesh;
      Positions positions = sheet.positions;
      const SurfaceIndex surface(m, positions);
      Correspondence homes(m, positions);
      Editor editor(m, nullptr, &positions);
      editor.keep(&homes);
      REQUIRE(edit_at_random(editor, 30, 3) == 30);
      FitOptions how;
      how.joint = joint;
      if (divided) how.run = tests::backwards;
      editor.fit(m.vertices(), surface, how);
      results.push_back(positions);
      homes_then.push_back(state(m, homes));
      editor.keep(nullptr);
    }
    REQUIRE(results[0].size() == results[1].size());
    for (std::size_t i = 0; i < results[0].size(); ++i) CHECK(same_bits(results[0][i], results[1][i]));
    CHECK(homes_then[0] == homes_then[1]);
  }
}

TEST_CASE("at the start every sample of a surface is at home where it lies", "[fitting]") {
  const BumpySheet s = bumpy_sheet(9, 7);
  const Correspondence homes(s.mesh, s.positions);
  // Face centres, edge midpoints and vertices.
  CHECK(homes.size() == std::size_t(63 + (9 * 8 + 10 * 7) + 80));
  std::size_t listed = 0;
  for (const FaceId f : s.mesh.faces()) homes.for_each_sample(f, [&](std::size_t) { ++listed; });
  CHECK(listed == homes.size());
  double largest = 0, total = 0;
  for (std::size_t i = 0; i < homes.size(); ++i) {
    largest = std::max(largest, homes.residual(s.mesh, s.positions, i).norm());
    total += homes.sample(i).weight * homes.sample(i).area;
  }
  CHECK(largest < 1e-12);
  CHECK(total > 0);
}

TEST_CASE("Law geometry-8: edits and fits that are rolled back restore every home", "[fitting]") {
  BumpySheet s = bumpy_sheet(12, 11);
  const QuadMesh mesh = s.mesh;
  const Positions positions = s.positions;
  Correspondence homes(s.mesh, s.positions);
  const SurfaceIndex surface(s.mesh, s.positions);
  Editor editor(s.mesh, nullptr, &s.positions);
  editor.keep(&homes);
  std::vector<std::vector<double>> states{state(s.mesh, homes)};
  std::vector<std::size_t> marks{editor.mark()};
  for (unsigned round = 0; round < 6; ++round) {
    REQUIRE(edit_at_random(editor, 8, round) == 8);
    if (round == 2) {
      editor.carry();
    } else {
      FitOptions how;
      how.joint = round == 4;
      editor.fit(s.mesh.vertices(), surface, how);
    }
    states.push_back(state(s.mesh, homes));
    marks.push_back(editor.mark());
    // No sample is lost, and each lies on a live face.
    std::size_t listed = 0;
    for (const FaceId f : s.mesh.faces()) homes.for_each_sample(f, [&](std::size_t) { ++listed; });
    CHECK(listed == homes.size());
  }
  CHECK(states.front() != states.back());
  for (std::size_t i = marks.size(); i-- > 0;) {
    editor.roll_back(marks[i]);
    CHECK(state(s.mesh, homes) == states[i]);
  }
  CHECK(s.mesh == mesh);
  for (const VertexId v : mesh.vertices()) CHECK(s.positions[v.slot()] == positions[v.slot()]);
}

TEST_CASE("the derivatives of a quad's shape agree with differences", "[fitting]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-0.4, 0.4);
  for (int trial = 0; trial < 20; ++trial) {
    QuadCorners c{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(1, 1, 0), Vector3d(0, 1, 0)};
    for (Vector3d& corner : c) corner += Vector3d(noise(random), noise(random), noise(random));
    const IdealQuad ideal{Vector3d(noise(random), noise(random), 1).normalized(), 0.8};
    QuadDerivatives all;
    add_shape(c, ideal, 2, all);
    for (std::size_t k = 0; k < 4; ++k) {
      CornerDerivatives one;
      add_shape(c, k, ideal, 2, one);
      for (int x = 0; x < 3; ++x) {
        constexpr double kStep = 1e-6;
        QuadCorners less = c, more = c;
        less[k][x] -= kStep;
        more[k][x] += kStep;
        const double slope = 2 * (shape_energy(more, ideal) - shape_energy(less, ideal)) / (2 * kStep);
        CHECK(std::abs(one.gradient[x] - slope) < 1e-4 * (1 + std::abs(slope)));
        CHECK(std::abs(all.gradient[static_cast<Eigen::Index>(3 * k) + x] - slope) < 1e-4 * (1 + std::abs(slope)));
      }
      const auto at = static_cast<Eigen::Index>(3 * k);
      CHECK((all.hessian.block<3, 3>(at, at) - one.hessian).norm() < 1e-9 * (1 + one.hessian.norm()));
    }
    CHECK((all.hessian - all.hessian.transpose()).norm() < 1e-9 * all.hessian.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(all.hessian);
    const Eigen::VectorXd& eigenvalues = solver.eigenvalues();
    CHECK(eigenvalues.minCoeff() > -1e-9 * eigenvalues.maxCoeff());
  }
  // The ideal square has no energy, and a folded corner has much.
  const QuadCorners square{Vector3d(0, 0, 0), Vector3d(2, 0, 0), Vector3d(2, 2, 0), Vector3d(0, 2, 0)};
  const IdealQuad ideal{Vector3d::UnitZ(), 4};
  CHECK(std::abs(shape_energy(square, ideal)) < 0.1);
  CHECK(shape_energy({square[0], square[3], square[2], square[1]}, ideal) > 100 * shape_energy(square, ideal) + 1);
  // A rectangle is better than a parallelogram with its area and the same sum of squared lengths.
  const double angle = std::numbers::pi / 3, ratio = std::sqrt(std::sin(angle));
  const double s = 2 / ratio, a = std::sqrt(s * s + std::sqrt(s * s * s * s - 16)), b = 4 / a;
  const Vector3d slanted(s * std::cos(angle), s * std::sin(angle), 0);
  const QuadCorners rhombus{Vector3d(0, 0, 0), Vector3d(s, 0, 0), Vector3d(s, 0, 0) + slanted, slanted};
  const QuadCorners rectangle{Vector3d(0, 0, 0), Vector3d(a, 0, 0), Vector3d(a, b, 0), Vector3d(0, b, 0)};
  CHECK(shape_energy(rectangle, ideal) < 0.5 * shape_energy(rhombus, ideal));
}

TEST_CASE("Laws geometry-9 and 10: a fit brings the mesh back to the surface, and moves nothing else", "[fitting]") {
  const bool joint = GENERATE(false, true);
  const BumpySheet input = bumpy_sheet(14, 12);
  QuadMesh m = input.mesh;
  Positions positions = input.positions;
  Correspondence homes(m, positions);
  const SurfaceIndex surface(m, positions);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-0.3, 0.3);
  std::vector<VertexId> given;
  for (const VertexId v : m.vertices()) {
    if (v.index() % 5 == 0) continue;
    given.push_back(v);
    if (!m.is_boundary(v) && v.index() % 3 != 0)
      positions[v.slot()] += Vector3d(noise(random), noise(random), noise(random));
  }
  const Positions before = positions;
  FitOptions how;
  how.rounds = 10;
  how.joint = joint;
  how.fixed = [](VertexId v) { return v.index() % 3 == 0; };
  const auto far = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < homes.size(); ++i) sum += homes.residual(m, positions, i).squaredNorm();
    return sum;
  };
  const double start = far();
  fit(m, positions, given, homes, surface, how);
  for (const VertexId v : m.vertices()) {
    if (m.is_boundary(v) || v.index() % 3 == 0 || v.index() % 5 == 0) {
      CHECK(positions[v.slot()] == before[v.slot()]);
    } else {
      CHECK((positions[v.slot()] - input.positions[v.slot()]).norm() < 0.15);
    }
  }
  CHECK(far() < 0.1 * start);
}

TEST_CASE("a mesh that lost half its rows stretches over what sticks out", "[fitting]") {
  // A box that stands on a plane. All rows of quads of its upper part are folded down to the plane.
  BumpySheet s = bumpy_sheet(16, 16);
  for (const VertexId v : s.mesh.vertices()) {
    const int x = v.index() / 17, y = v.index() % 17;
    const int d = std::max(std::abs(x - 8), std::abs(y - 8));
    s.positions[v.slot()] = d >= 4 ? Vector3d(x, y, 0) : Vector3d(8 + (x - 8) * 0.5, 8 + (y - 8) * 0.5, 8.0 - 2 * d);
  }
  const Positions input = s.positions;
  Correspondence homes(s.mesh, s.positions);
  const SurfaceIndex surface(s.mesh, s.positions);
  for (const VertexId v : s.mesh.vertices()) {
    if (s.positions[v.slot()].z() > 3) s.positions[v.slot()].z() = 3;
  }
  FitOptions how;
  how.rounds = 20;
  how.joint = true;
  fit(s.mesh, s.positions, s.mesh.vertices(), homes, surface, how);
  const SurfaceIndex fitted(s.mesh, s.positions);
  double largest = 0;
  for (const Vector3d& p : input) largest = std::max(largest, fitted.nearest(p).distance);
  CHECK(largest < 0.6);  // it was 5
}
