// The meshes in mesh/examples: Figures 16, 17 and 18, which the commands of the script there repair.
//
// Each input was made from a clean model by the paper's repair in reverse. So the result of the repair is known: it has
// the irregular vertices of the model.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numbers>

#include <nlohmann/json.hpp>

#include "mesh/editing/affected_region.hpp"
#include "mesh/editing/untangling.hpp"
#include "mesh/files/feature_edges.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/geometry/nearest_points.hpp"
#include "mesh/geometry/smoothing.hpp"
#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;
using nlohmann::json;

namespace {

constexpr double kFeatureAngle = 40;  // as in the script

// A model whose vertices are named by three integers while it is built.
struct Model {
  Positions positions;
  std::vector<std::array<int, 4>> faces;
  std::map<std::array<int, 3>, int> names;

  int add(std::array<int, 3> name, const Eigen::Vector3d& at) {
    const auto [place, is_new] = names.emplace(name, static_cast<int>(positions.size()));
    if (is_new) positions.push_back(at);
    return place->second;
  }
  VertexId operator()(int x, int y, int z) const { return VertexId(names.at({x, y, z})); }
};

// A cube with n x n quads on each side, and with rounded edges if wanted. Vertices have their coordinates 0..n as
// names.
Model block(int n, bool rounded) {
  constexpr double kNorm = 4;
  Model m;
  const auto at = [&](std::array<int, 3> c) {
    Eigen::Vector3d x = Eigen::Vector3d(c[0], c[1], c[2]) * (2.0 / n) - Eigen::Vector3d::Ones();
    if (rounded) x /= std::pow(x.array().abs().pow(kNorm).sum(), 1 / kNorm);
    return m.add(c, x);
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool far : {false, true}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> c{};
            c[axis] = far ? n : 0;
            c[(axis + 1) % 3] = i + di;
            c[(axis + 2) % 3] = j + dj;
            return at(c);
          };
          if (far) m.faces.push_back({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
          if (!far) m.faces.push_back({corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)});
        }
      }
    }
  }
  return m;
}

// A cylinder with sharp rims. Each cap is a square of n x n quads, with four v3s at its corners, and rings of 4 n quads
// round the square. A vertex inside the square has the name (-1 - level, x, y). Any other vertex has the name (level,
// ring, position along the ring), where ring 0 is the boundary of the square.
Model cylinder(int n, int rings, int levels) {
  constexpr double kSquare = 0.55, kHeight = 1.2;  // half the square's side; the radius is 1
  Model m;
  const int round = 4 * n;
  const auto outer = [&](int level, int ring, int i) {
    i %= round;
    const double t = -1 + 2.0 * (i % n) / n;
    const std::array<Eigen::Vector2d, 4> sides{{{t, -1}, {1, t}, {-t, 1}, {-1, -t}}};
    const Eigen::Vector2d on_square = sides[static_cast<std::size_t>(i / n)];
    const double w = static_cast<double>(ring) / rings;
    const Eigen::Vector2d p = (1 - w) * kSquare * on_square + w * on_square.normalized();
    return m.add({level, ring, i}, {p.x(), p.y(), kHeight * level / levels});
  };
  const auto inner = [&](int level, int x, int y) {
    if (y == 0 && x < n) return outer(level, 0, x);
    if (x == n && y < n) return outer(level, 0, n + y);
    if (y == n && x > 0) return outer(level, 0, 2 * n + (n - x));
    if (x == 0) return outer(level, 0, 3 * n + (n - y));
    return m.add({-1 - level, x, y},
                 {(-1 + 2.0 * x / n) * kSquare, (-1 + 2.0 * y / n) * kSquare, kHeight * level / levels});
  };
  for (const int level : {0, levels}) {
    // The calls below list corners clockwise, in braces. The order of the calls decides the numbers of the vertices, on
    // which the script relies.
    const auto face = [&](const std::array<int, 4>& f) {
      m.faces.push_back(level > 0 ? std::array{f[3], f[2], f[1], f[0]} : std::array{f[3], f[0], f[1], f[2]});
    };
    for (int x = 0; x < n; ++x) {
      for (int y = 0; y < n; ++y)
        face({inner(level, x, y + 1), inner(level, x + 1, y + 1), inner(level, x + 1, y), inner(level, x, y)});
    }
    for (int r = 0; r < rings; ++r) {
      for (int i = 0; i < round; ++i)
        face({outer(level, r, i + 1), outer(level, r + 1, i + 1), outer(level, r + 1, i), outer(level, r, i)});
    }
  }
  for (int level = 0; level < levels; ++level) {
    for (int i = 0; i < round; ++i) {
      m.faces.push_back({outer(level, rings, i), outer(level, rings, i + 1), outer(level + 1, rings, i + 1),
                         outer(level + 1, rings, i)});
    }
  }
  return m;
}

// A model with its features and an editor.
struct Bench {
  explicit Bench(const Model& model)
      : mesh(QuadMesh::from_faces(static_cast<int>(model.positions.size()), model.faces)),
        positions(model.positions),
        surface(mesh, positions),
        editor(mesh, &features, &positions, &plan),
        transport(editor) {
    for (const auto& [a, b] : sharp_edges(mesh, positions, kFeatureAngle)) features.insert(a, b);
    plan = plan_by_angles(mesh, features, positions);
  }
  void flip(VertexId a, VertexId b, BasicOperation::Kind kind) {
    REQUIRE(editor.run({kind, mesh.find_half_edge(a, b), {}, 0}).refusal == Refusal::none);
  }
  // Sends the adjacent 3-5 pair to the target.
  void send(VertexId three, VertexId five, VertexId target) {
    REQUIRE(transport.carry({mesh.find_half_edge(three, five), false}, std::array{target}).refusal == Refusal::none);
  }
  // Moves the v5 by an edge. The v3 absorbs the adjacent pair that this leaves behind.
  void move(VertexId five, VertexId to, VertexId three) {
    REQUIRE(transport.carry({mesh.find_half_edge(five, to), true}, std::array{three}).refusal == Refusal::none);
  }
  Surface result() {
    SmoothingOptions how;
    how.project_to = &surface;
    BreadthFirstDistances around;
    editor.smooth(affected_region_since(editor, around, 0, 2).near, how);
    untangle(editor, how);
    REQUIRE(validate(mesh).empty());
    return {mesh, positions, {}, {}};
  }

  QuadMesh mesh;
  Positions positions;
  SurfaceIndex surface;
  FeatureSet features;
  SectorPlan plan;
  Editor editor;
  PairTransport transport;
};

using Kind = BasicOperation::Kind;

// Figure 16: on a rounded corner, the v3 is an edge away from its proper place. A v3 and a v5 are beside it.
Surface figure_16() {
  const Model model = block(8, true);
  Bench bench(model);
  bench.flip(model(8, 1, 5), model(8, 0, 5), Kind::flip_ccw);
  bench.send(model(8, 1, 5), model(8, 1, 6), model(8, 0, 8));
  return bench.result();
}

// Figure 17: one of four v3s on a cap is misaligned. A v3 and a v5 are below it.
Surface figure_17() {
  constexpr int kTop = 4;
  const Model model = cylinder(6, 4, kTop);
  Bench bench(model);
  bench.flip(model(-1 - kTop, 1, 3), model(-1 - kTop, 1, 4), Kind::flip_ccw);
  bench.send(model(-1 - kTop, 1, 4), model(kTop, 0, 20), model(kTop, 0, 0));
  return bench.result();
}

// Figure 18: one of four irregular vertices on a side of a sharp block has moved to an edge of the block. Three
// transports from the v5s moved it, by an edge each.
Surface figure_18() {
  const Model model = block(8, false);
  Bench bench(model);
  bench.flip(model(4, 3, 8), model(4, 4, 8), Kind::flip_ccw);
  bench.move(model(5, 3, 8), model(5, 2, 8), model(4, 3, 8));
  bench.move(model(3, 4, 8), model(5, 3, 8), model(4, 2, 8));
  bench.move(model(5, 3, 8), model(6, 3, 8), model(4, 1, 8));
  CHECK(bench.editor.sectors().lacks(model(4, 0, 8)));
  return bench.result();
}

}  // namespace

TEST_CASE("the examples' inputs are the models with their defects", "[examples]") {
  for (const auto& [name, make] :
       {std::pair{"figure-16", &figure_16}, std::pair{"figure-17", &figure_17}, std::pair{"figure-18", &figure_18}}) {
    INFO(name);
    const Surface made = make();
    const std::string written = (tests::scratch() / (std::string(name) + ".obj")).string();
    tests::spill(written, obj_text(made.mesh, made.positions));
    INFO("as it is now: " << written);
    CHECKED_ELSE(std::filesystem::exists(tests::example_mesh(name))) { continue; }
    const Surface now = read_surface(written, false);
    const Surface kept = read_surface(tests::example_mesh(name), false);
    CHECK(now.mesh == kept.mesh);
    REQUIRE(now.positions.size() == kept.positions.size());
    double farthest = 0;  // mathematical functions may differ in their last bits
    for (std::size_t i = 0; i < now.positions.size(); ++i)
      farthest = std::max(farthest, (now.positions[i] - kept.positions[i]).norm());
    CHECK(farthest < 1e-6);
  }
}

TEST_CASE("Figures 16-18: the examples' script repairs them", "[examples][programs]") {
  const std::filesystem::path out = tests::scratch() / "examples";
  const std::string command = "bash '" REQUAD_SOURCE_DIR "/mesh/examples/run' '" REQUAD_PROGRAM_DIR "/requad-edit' '" +
                              out.string() + "' >'" + (tests::scratch() / "examples.txt").string() + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  const auto read = [&](const std::string& name) { return read_surface((out / (name + ".obj")).string(), false); };
  const auto inverted = [](const Surface& s) { return diagnose(s.mesh, s.positions).inverted; };
  // The clean models have a v3 at each corner of a block, and four v3s on each cap of a cylinder.
  const std::map<int, int> eight{{3, 8}};
  const Surface corner = read("figure-16-repaired");
  CHECK(tests::irregular_valences(corner.mesh) == eight);
  CHECK(inverted(corner) == 0);
  // A v3 is the vertex nearest to the corner of the block, or a neighbour of that vertex.
  const Eigen::Vector3d at = Eigen::Vector3d(1, -1, 1) / std::pow(3, 1.0 / 4);
  double nearest = 2;
  for (const VertexId v : corner.mesh.vertices()) {
    if (corner.mesh.valence(v) == 3) nearest = std::min(nearest, (corner.positions[v.slot()] - at).norm());
  }
  CHECK(nearest < 0.15);

  Surface cap = read("figure-17-repaired");
  CHECK(tests::irregular_valences(cap.mesh) == eight);
  CHECK(inverted(cap) == 0);
  // Separatrices join four of the six pairs of v3s on the cap: the sides of a square, but not its diagonals.
  std::vector<VertexId> threes;
  for (const VertexId v : cap.mesh.vertices()) {
    if (cap.mesh.valence(v) == 3 && cap.positions[v.slot()].z() > 1) threes.push_back(v);
  }
  REQUIRE(threes.size() == 4);
  int joined = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (const PairFrame& frame : find_frames(cap.mesh, threes[i], threes[j])) {
        if (frame.d1 != 0) continue;
        CHECK(frame.d2 == 6);
        ++joined;
      }
    }
  }
  CHECK(joined == 4);

  const Surface defect = read_surface(tests::example_mesh("figure-18"), false);
  const Surface pulled = read("figure-18-repaired");
  const VertexId edge(221);
  CHECK(defect.mesh.valence(edge) == 3);
  CHECK(inverted(defect) == 1);
  CHECK(pulled.mesh.valence(edge) == 4);
  CHECK(inverted(pulled) == 0);
  CHECK(tests::irregular_valences(pulled.mesh) == std::map<int, int>{{3, 10}, {5, 2}});
  CHECK(tests::irregular_valences(read("figure-18-reduced").mesh) == eight);
  const auto features = sharp_edges(defect.mesh, defect.positions, kFeatureAngle);
  CHECK(features.size() == 96);
  for (const auto& [a, b] : features) {
    CHECK(pulled.mesh.adjacent(a, b));
    CHECK(pulled.positions[a.slot()] == defect.positions[a.slot()]);
    CHECK(pulled.positions[b.slot()] == defect.positions[b.slot()]);
  }
  // While one of the vertices is on the edge, the ten v3s and two v5s cannot be reduced.
  const auto before =
      tests::call("edit", "reduce '" + tests::example_mesh("figure-18") + "' --feature-angle 40 -o less.obj --json -");
  REQUIRE(before.code == 0);
  CHECK(json::parse(before.out)["irregular"]["after"] == 4);
}
