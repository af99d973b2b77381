// The reduction of generated and real meshes to their topological minimum.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>

#include <nlohmann/json.hpp>

#include "mesh/editing/untangling.hpp"
#include "mesh/files/feature_edges.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/geometry/hausdorff_distance.hpp"
#include "mesh/geometry/measures.hpp"
#include "mesh/irregular/reduce.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;
using requad::tests::irregular_valences;

namespace {

// As far as the topology allows, whatever the quads look like then.
ReduceOptions without_fits() {
  ReduceOptions how;
  how.sweeps = 0;
  how.final_rounds = 0;
  how.allow_inverted = true;
  how.patience = 0;
  return how;
}

}  // namespace

TEST_CASE("Laws irregular-31 to irregular-33: real meshes reach what discrete Gauss-Bonnet leaves, and roll back",
          "[reduce][real]") {
  struct Expected {
    const char* name;
    std::map<int, int> left;  // the sum of 4 - l(v) is 4 chi: eight v3s for genus 0, none for 1, 32 v5s for 5.
                              // A mesh with only v6s stays as it is.
  };
  for (const Expected& expected : {Expected{"spot", {{3, 8}}},
                                   {"fandisk_bommes", {{3, 8}}},
                                   {"bunny_qex", {{3, 8}}},
                                   {"bob", {}},
                                   {"botijo_miq", {{5, 32}}},
                                   {"anet_complete01", {{6, 8}}}}) {
    INFO(expected.name);
    const auto path = tests::real_mesh(expected.name);
    if (!path) continue;
    const Surface input = read_surface(*path, false);
    std::string first;
    const int rounds = input.mesh.face_count() < 1000 ? 2 : 1;
    for (int round = 0; round < rounds; ++round) {
      QuadMesh m = input.mesh;
      Positions positions = input.positions;
      Editor editor(m, nullptr, &positions);
      int least = static_cast<int>(irregular_vertices(m).size());
      ReduceOptions how = without_fits();
      how.progress = [&](int irregular) { least = irregular; };
      const ReduceReport report = reduce(editor, how);
      CHECK(report.before == static_cast<int>(irregular_vertices(input.mesh).size()));
      CHECK(report.after == least);
      CHECK(report.minimal);
      CHECK(irregular_valences(m) == expected.left);
      CHECK(validate(m).empty());
      CHECK(euler_characteristic(m) == euler_characteristic(input.mesh));
      // A second run gives the same, although memory holds other values.
      const std::string now = std::to_string(report.operations) + " " + std::to_string(m.face_count());
      if (round == 0) first = now;
      CHECK(now == first);
      editor.roll_back();
      CHECK(m == input.mesh);
      for (const VertexId v : m.vertices()) CHECK(positions[v.slot()] == input.positions[v.slot()]);
    }
  }
}

TEST_CASE("reduce stops at the given number of vertices, and keeps to the given deviation", "[reduce][real]") {
  const auto path = tests::real_mesh("spot");
  if (!path) return;
  const Surface input = read_surface(*path, false);
  const double diagonal = bounding_box_diagonal(input.mesh, input.positions);
  for (const ReduceCost cost : {ReduceCost::curvature, ReduceCost::fit}) {
    QuadMesh m = input.mesh;
    Positions positions = input.positions;
    Editor editor(m, nullptr, &positions);
    ReduceOptions how;
    how.cost = cost;
    how.until = 60;
    how.final_rounds = 0;  // these only move vertices
    const ReduceReport report = reduce(editor, how);
    CHECK(report.after <= 60);
    CHECK(report.after >= 56);  // a cancellation removes at most four
    CHECK(report.after == static_cast<int>(irregular_vertices(m).size()));
  }
  QuadMesh m = input.mesh;
  Positions positions = input.positions;
  Editor editor(m, nullptr, &positions);
  ReduceOptions how;
  how.max_deviation = 3e-3 * diagonal;
  const ReduceReport report = reduce(editor, how);
  CHECK(report.too_far > 0);
  CHECK_FALSE(report.minimal);
  CHECK(report.after > 8);
  CHECK(report.after < report.before);
}

TEST_CASE("Law irregular-35: what leads too far early costs little of what comes after it", "[reduce][real]") {
  // On osd_car this is the parting of the v6s, with 0.01; on spot a cancellation, between the samples.
  const auto [name, bound, patience, least] =
      GENERATE(table<const char*, double, int, int>({{"osd_car", 0.01, 64, 25}, {"spot", 0.003, 8, 25}}));
  const auto path = tests::real_mesh(name);
  if (!path) return;
  const Surface input = read_surface(*path, false);
  const double diagonal = bounding_box_diagonal(input.mesh, input.positions);
  QuadMesh m = input.mesh;
  Positions positions = input.positions;
  Editor editor(m, nullptr, &positions);
  ReduceOptions how;
  how.max_deviation = bound * diagonal;
  how.patience = patience;
  const ReduceReport report = reduce(editor, how);
  CHECK(report.cancelled >= least);
  CHECK(hausdorff_distance({m, positions}, {input.mesh, input.positions}) <= how.max_deviation);
}

TEST_CASE("Laws irregular-33 and 35: the result does not depend on the order of tasks, and the usual bound holds",
          "[reduce][real]") {
  const auto path = tests::real_mesh("bigguy");
  if (!path) return;
  const Surface input = read_surface(*path, false);
  const double diagonal = bounding_box_diagonal(input.mesh, input.positions);
  std::vector<Positions> results;
  for (const bool divided : {false, true}) {
    QuadMesh m = input.mesh;
    Positions positions = input.positions;
    Editor editor(m, nullptr, &positions);
    ReduceOptions how;
    if (divided) how.run = tests::backwards;
    const ReduceReport report = reduce(editor, how);
    CHECK(report.cancelled > 50);
    CHECK(count_inverted(m, positions) <= count_inverted(input.mesh, input.positions));
    CHECK(hausdorff_distance({m, positions}, {input.mesh, input.positions}) <= 0.02 * diagonal);
    results.push_back(positions);
  }
  REQUIRE(results[0].size() == results[1].size());
  for (std::size_t i = 0; i < results[0].size(); ++i) CHECK(same_bits(results[0][i], results[1][i]));
}

TEST_CASE("features and boundaries are kept bit by bit", "[reduce][real]") {
  for (const char* name : {"fandisk_bommes", "pawn"}) {
    INFO(name);
    const auto path = tests::real_mesh(name);
    if (!path) continue;
    const Surface input = read_surface(*path, false);
    FeatureSet features;
    for (const auto& [a, b] : sharp_edges(input.mesh, input.positions, 40)) features.insert(a, b);
    REQUIRE(features.size() > 0);
    QuadMesh m = input.mesh;
    Positions positions = input.positions;
    Editor editor(m, &features, &positions);
    reduce(editor, {});
    for (const auto& [a, b] : features.edges()) {
      REQUIRE(m.is_live(a));
      REQUIRE(m.is_live(b));
      CHECK(m.adjacent(a, b));
      CHECK(positions[a.slot()] == input.positions[a.slot()]);
      CHECK(positions[b.slot()] == input.positions[b.slot()]);
    }
    for (const VertexId v : input.mesh.vertices()) {
      if (!input.mesh.is_boundary(v)) continue;
      REQUIRE(m.is_live(v));
      CHECK(m.is_boundary(v));
      CHECK(positions[v.slot()] == input.positions[v.slot()]);
    }
  }
}

TEST_CASE("requad-edit edits pairs, or gives the reason for a refusal", "[programs][real]") {
  using nlohmann::json;
  using tests::call;
  const auto path = tests::real_mesh("spot");
  if (!path) return;
  const Surface input = read_surface(*path, false);
  // The numbers of a v3, a v5 and a regular vertex in the file.
  std::map<int, int> number;
  for (const VertexId v : input.mesh.vertices()) number.emplace(input.mesh.valence(v), input.file_vertex[v.slot()] + 1);
  const std::string three = std::to_string(number.at(3)), four = std::to_string(number.at(4)),
                    five = std::to_string(number.at(5));
  const auto cancelled = call("edit", "cancel " + *path + " " + three + " " + five + " -o cancelled.obj --json -");
  REQUIRE(cancelled.code == 0);
  const json report = json::parse(cancelled.out);
  CHECK(report["after"]["interior_irregular"] < report["before"]["interior_irregular"]);
  CHECK(report["couriers"] > 0);
  const auto again = call("edit", "info cancelled.obj --json -");
  CHECK(json::parse(again.out)["interior_irregular"] == report["after"]["interior_irregular"]);
  CHECK(json::parse(again.out)["genus"] == 0);

  const auto wrong = call("edit", "cancel " + *path + " " + three + " " + four + " -o none.obj");
  CHECK(wrong.code == 1);
  CHECK(wrong.err.find("do not have the valences") != std::string::npos);
  CHECK(!std::filesystem::exists(tests::scratch() / "none.obj"));
  CHECK(call("edit", "cancel " + *path + " 1 0 -o none.obj").code == 2);
  CHECK(call("edit", "merge " + *path + " " + three + " -o none.obj").code == 2);
  CHECK(call("edit", "part " + *path + " -o parted.obj --json -").code == 0);
  const json parted = json::parse(call("edit", "info parted.obj --json -").out)["valences"];
  CHECK(parted.size() == 3);
  const auto listed = call("edit", "moves " + *path + " " + three + " " + five + " --json -");
  REQUIRE(listed.code == 0);
  CHECK(json::parse(listed.out)["moves"].size() >= 4);
}

TEST_CASE("Law editing-21: untangling removes folds, and fixed vertices stay", "[smoothing]") {
  // A flat grid with a feature across it. Its inner vertices are moved far at random.
  std::mt19937 random(1);
  const Region start = tests::grid(12, 10);
  QuadMesh m = start.mesh;
  Positions positions(static_cast<std::size_t>(m.vertex_capacity()));
  std::uniform_real_distribution<double> noise(-2, 2);
  for (const VertexId v : m.vertices()) {
    const int x = v.index() / 11, y = v.index() % 11;  // as tests::grid() numbers them
    positions[v.slot()] = {double(x), double(y), 0};
    if (!m.is_boundary(v) && x != 6) positions[v.slot()] += Eigen::Vector3d(noise(random), noise(random), 0);
  }
  FeatureSet features;
  for (int y = 0; y < 10; ++y) features.insert(VertexId(66 + y), VertexId(67 + y));
  const Positions before = positions;
  const auto inverted = [&] {
    const auto faces = m.faces();
    return static_cast<int>(std::count_if(faces.begin(), faces.end(),
                                          [&](FaceId f) { return is_inverted(scaled_jacobian(m, positions, f)); }));
  };
  const int folds = inverted();
  REQUIRE(folds > 20);
  Editor editor(m, &features, &positions);
  const Untangling result = untangle(editor, {});
  CHECK(result.before == folds);
  CHECK(result.after == inverted());
  CHECK(result.after == 0);
  for (const VertexId v : m.vertices()) {
    if (editor.is_fixed(v)) CHECK(positions[v.slot()] == before[v.slot()]);
  }
  // If every vertex is fixed, nothing changes.
  FeatureSet all;
  for (const HalfEdgeId h : m.half_edges()) all.insert(m.origin(h), m.target(h));
  positions = before;
  Editor stuck(m, &all, &positions);
  const Untangling nothing = untangle(stuck, {});
  CHECK(nothing.after == nothing.before);
  CHECK(positions == before);
}

namespace {

// A disk whose centre has this many quads, with rings of twice as many quads round it. A v3 lies between every two
// neighbouring spokes.
struct Disk {
  QuadMesh mesh;
  Positions positions;
};
Disk disk(int spokes, int rings) {
  const int round = 2 * spokes;
  const auto at = [round](int ring, int i) { return 1 + (ring - 1) * round + i % round; };
  Disk d;
  d.positions.emplace_back(0, 0, 0);
  std::vector<std::array<int, 4>> faces;
  for (int i = 0; i < spokes; ++i) faces.push_back({0, at(1, 2 * i), at(1, 2 * i + 1), at(1, 2 * i + 2)});
  for (int ring = 1; ring <= rings; ++ring) {
    for (int i = 0; i < round; ++i) {
      const double angle = 2 * std::acos(-1.0) * i / round;
      d.positions.emplace_back(ring * std::cos(angle), ring * std::sin(angle), 0);
      if (ring < rings) faces.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
  }
  d.mesh = QuadMesh::from_faces(1 + rings * round, faces);
  return d;
}

// The number of pairs of irregular vertices that a separatrix joins. Such a pair is already aligned.
int aligned_pairs(Editor& editor, std::optional<std::array<VertexId, 2>>& nearest_to_aligned) {
  const auto irregular = irregular_vertices(editor.mesh());
  int aligned = 0;
  int fewest = 1 << 20;
  nearest_to_aligned.reset();
  for (std::size_t i = 0; i < irregular.size(); ++i) {
    for (std::size_t j = i + 1; j < irregular.size(); ++j) {
      const std::size_t mark = editor.mark();
      const PairResult result = align_pair(editor, irregular[i], irregular[j]);
      editor.roll_back(mark);
      if (result.refusal != Refusal::none) continue;
      if (result.moves == 0) ++aligned;
      if (result.moves > 0 && result.moves < fewest) {
        fewest = result.moves;
        nearest_to_aligned = {irregular[i], irregular[j]};
      }
    }
  }
  return aligned;
}

}  // namespace

TEST_CASE("Figure 15: a disk with 36 v3s round a v36 becomes one with four aligned v3s", "[reduce][figure15]") {
  Disk d = disk(36, 8);
  CHECK(irregular_valences(d.mesh) == std::map<int, int>{{3, 36}, {36, 1}});
  const QuadMesh before = d.mesh;
  Editor editor(d.mesh, nullptr, &d.positions);
  const ReduceReport report = reduce(editor, without_fits());
  CHECK(report.minimal);
  CHECK(irregular_valences(d.mesh) == std::map<int, int>{{3, 4}});
  // The nearest pair is aligned again and again, until the four vertices are the corners of a rectangle. Four of the
  // six pairs are then aligned.
  std::optional<std::array<VertexId, 2>> next;
  int alignments = 0;
  while (aligned_pairs(editor, next) < 4 && next && alignments < 12) {
    REQUIRE(align_pair(editor, (*next)[0], (*next)[1]).refusal == Refusal::none);
    ++alignments;
  }
  CHECK(aligned_pairs(editor, next) >= 4);
  CHECK(irregular_valences(d.mesh) == std::map<int, int>{{3, 4}});
  CHECK(validate(d.mesh).empty());
  CHECK(untangle(editor, {}).after == 0);
  editor.roll_back();
  CHECK(d.mesh == before);
}
