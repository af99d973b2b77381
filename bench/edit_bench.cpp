// The cost of edits through an editor, which checks them, updates positions and can roll back. Does editing stay
// interactive? First the same edit is made in the middle of meshes of ten thousand, a hundred thousand and a million
// quads. Then the mesh keeps its size and the paths grow longer. Last come reductions of whole meshes.

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/regions.hpp"
#include "bench/require.hpp"
#include "bench/subjects.hpp"
#include "mesh/irregular/atomic_operations.hpp"
#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/irregular/reduce.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::bench {
namespace {

using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::VertexId;

constexpr std::int64_t kPath = 8;         // the length of the path if the size of the mesh varies
constexpr std::int64_t kQuads = 100'000;  // the size of the mesh if the length of the path varies

// A mesh with the editor of an interactive program.
struct Scene {
  explicit Scene(QuadMesh m)
      : Scene(m, mesh::Positions(static_cast<std::size_t>(m.vertex_capacity()), Eigen::Vector3d::Zero())) {}
  Scene(QuadMesh m, mesh::Positions p)
      : mesh(std::move(m)), positions(std::move(p)), editor(mesh, nullptr, &positions) {}

  QuadMesh mesh;
  mesh::Positions positions;
  mesh::Editor editor;
};

// A digon of about this many quads whose two v3s span d x d quads in the middle. With e strips along each side it has
// d^2 + 4 d e + 2 e^2 quads.
QuadMesh digon(std::int64_t quads, std::int64_t d) {
  const auto strips = static_cast<std::int64_t>(std::sqrt(static_cast<double>(quads + d * d) / 2)) - d;
  return spread_pair(theory::kDigon, d, strips).mesh;
}

// A region of about this many quads with one v3. The v3 then moves by an edge. The adjacent 3-5 pair that it leaves
// behind is transported by `steps` flips, in a straight line.
struct ThreeVertices {
  Scene scene;
  VertexId alone;
  VertexId three;
  VertexId five;

  ThreeVertices(std::int64_t quads, std::int64_t steps) : scene(spread_pair({4, 3}, 0, side(quads)).mesh) {
    mesh::Editor& editor = scene.editor;
    const VertexId start = mesh::irregular_vertices(scene.mesh)[0];
    const HalfEdgeId along = scene.mesh.out(start);
    alone = scene.mesh.target(along);
    mesh::AtomicReport made = perform(editor, {*mesh::parse_atomic_name("move-v3 flip left"), along});
    for (std::int64_t i = 1; i < steps; ++i) {
      // made.inverse.along is the edge of the pair as it is now.
      made = perform(editor, {*mesh::parse_atomic_name("move-35 flip left"), made.inverse.along});
    }
    three = scene.mesh.origin(made.inverse.along);
    five = scene.mesh.target(made.inverse.along);
    editor.forget();
  }

 private:
  static std::int64_t side(std::int64_t quads) { return std::llround(std::sqrt(static_cast<double>(quads) / 3)); }
};

void three_sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"quads", "path"});
  for (const std::int64_t quads : {10'000, 100'000, 1'000'000}) b->Args({quads, kPath});
}
void longer_paths(benchmark::internal::Benchmark* b) {
  b->ArgNames({"quads", "path"});
  for (std::int64_t path = 4; path <= 64; path *= 2) b->Args({kQuads, path});
}

void count_quads(benchmark::State& state, const QuadMesh& m) {
  state.counters["quads"] = static_cast<double>(m.face_count());
}

// How long do an atomic operation and its inverse take?
void atomic_move_and_back(benchmark::State& state) {
  Scene scene(digon(state.range(0), kPath));
  const HalfEdgeId along = scene.mesh.out(mesh::irregular_vertices(scene.mesh)[0]);
  const mesh::AtomicName name = *mesh::parse_atomic_name("move-v3 collapse left");
  mesh::AtomicOperation there{name, along};
  for (auto _ : state) {
    const mesh::AtomicReport made = perform(scene.editor, there);
    const mesh::AtomicReport back = perform(scene.editor, made.inverse);
    require(back.refusal == mesh::Refusal::none, "an operation was refused");
    there = back.inverse;
    scene.editor.forget();
  }
  count_quads(state, scene.mesh);
}
BENCHMARK(atomic_move_and_back)->ArgName("quads")->Arg(10'000)->Arg(100'000)->Arg(1'000'000);

// How long do a move of a 3-3 pair and its inverse take, each with a report? The pair spans d x d quads, and closes
// over 2 d + 1 of them.
void pair_move_and_back(benchmark::State& state) {
  Scene scene(digon(state.range(0), state.range(1)));
  const auto pair = mesh::irregular_vertices(scene.mesh);
  mesh::PairMove move;
  for (const mesh::PairMove& m : mesh::pair_moves(scene.mesh, pair[0], pair[1])) {
    if (m.step == mesh::PairStep::close) move = m;
  }
  std::size_t operations = 0;
  for (auto _ : state) {
    const mesh::MoveReport there = move_pair(scene.editor, move);
    const mesh::MoveReport back = move_pair(scene.editor, there.inverse);
    require(back.refusal == mesh::Refusal::none, "an operation was refused");
    move = back.inverse;
    operations = there.operations.size();
    scene.editor.forget();
  }
  count_quads(state, scene.mesh);
  state.counters["operations"] = static_cast<double>(operations);
  state.SetComplexityN(state.range(1));
}
BENCHMARK(pair_move_and_back)->Apply(three_sizes);
BENCHMARK(pair_move_and_back)->Apply(longer_paths)->Complexity(benchmark::oN);

// How long does it take to list the four moves of such a pair?
void list_pair_moves(benchmark::State& state) {
  const QuadMesh m = digon(state.range(0), state.range(1));
  const auto pair = mesh::irregular_vertices(m);
  for (auto _ : state) benchmark::DoNotOptimize(mesh::pair_moves(m, pair[0], pair[1]));
  count_quads(state, m);
  state.SetComplexityN(state.range(1));
}
BENCHMARK(list_pair_moves)->Apply(three_sizes);
BENCHMARK(list_pair_moves)->Apply(longer_paths)->Complexity();

// How long does it take to transport an adjacent 3-5 pair from one v3 to another over d x d quads, and to roll back?
void transport(benchmark::State& state, bool new_each_time) {
  Scene scene(digon(state.range(0), state.range(1)));
  const auto pair = mesh::irregular_vertices(scene.mesh);
  const mesh::AdjacentPair start{scene.mesh.out(pair[0])};
  const std::array<VertexId, 1> targets{pair[1]};
  mesh::PairTransport kept(scene.editor);
  mesh::TransportReport report;
  for (auto _ : state) {
    if (new_each_time) {
      mesh::PairTransport transport(scene.editor);
      report = transport.carry(start, targets);
    } else {
      report = kept.carry(start, targets);
    }
    require(report.refusal == mesh::Refusal::none, "an operation was refused");
    scene.editor.roll_back();
  }
  count_quads(state, scene.mesh);
  state.counters["operations"] = report.steps;
  state.counters["states"] = static_cast<double>(report.states);
  state.SetComplexityN(state.range(1));
}
BENCHMARK_CAPTURE(transport, kept, false)->Apply(three_sizes);
BENCHMARK_CAPTURE(transport, kept, false)->Apply(longer_paths)->Complexity();
// How long does the same take with a new PairTransport each time, which then allocates its working memory?
BENCHMARK_CAPTURE(transport, new, true)->Apply(three_sizes);

// How long does it take to cancel a v3 and a v5 with the help of a second v3 beside the v5, and to roll back? A flip
// moves the v5 by two edges, and the v3 and the v5 are `path` flips apart. Each edge between them takes one transport,
// whose search covers a disk.
void cancel_and_roll_back(benchmark::State& state) {
  ThreeVertices start(state.range(0), state.range(1));
  mesh::PairTransport transport(start.scene.editor);
  mesh::Cancellation result;
  for (auto _ : state) {
    result = cancel_pair(start.scene.editor, transport, start.alone, start.five, {start.three});
    require(result.refusal == mesh::Refusal::none, "an operation was refused");
    start.scene.editor.roll_back();
  }
  count_quads(state, start.scene.mesh);
  state.counters["operations"] = result.steps;
  state.counters["transports"] = result.transports;
  state.SetComplexityN(state.range(1));
}
BENCHMARK(cancel_and_roll_back)->Apply(three_sizes);
BENCHMARK(cancel_and_roll_back)
    ->ArgNames({"quads", "path"})
    ->RangeMultiplier(2)
    ->Ranges({{kQuads, kQuads}, {4, 32}})
    ->Complexity(benchmark::oNCubed);

// How long does the first split of a mesh take, if the arrays must first grow?
void first_split(benchmark::State& state) {
  const Scene untouched(digon(state.range(0), kPath));
  const HalfEdgeId inner = untouched.mesh.out(mesh::irregular_vertices(untouched.mesh)[0]);
  std::optional<Scene> scene;
  for (auto _ : state) {
    state.PauseTiming();
    scene.emplace(untouched.mesh);
    state.ResumeTiming();
    const mesh::Applied done =
        scene->editor.run({mesh::BasicOperation::Kind::split, inner, QuadMesh::previous(inner), 0});
    require(done.refusal == mesh::Refusal::none, "an operation was refused");
  }
  count_quads(state, untouched.mesh);
  state.SetComplexityN(untouched.mesh.face_count());
}
BENCHMARK(first_split)
    ->ArgName("quads")
    ->RangeMultiplier(10)
    ->Range(10'000, 1'000'000)
    ->Unit(benchmark::kMicrosecond)
    ->Complexity(benchmark::oN);

// Performs one legal atomic operation for every hundred quads, at random vertices.
void disturb(Scene& scene) {
  std::mt19937 random(2011);
  const auto pick = [&random](std::size_t count) { return random() % count; };
  for (int left = scene.mesh.face_count() / 100; left > 0;) {
    const VertexId v(static_cast<int>(pick(static_cast<std::size_t>(scene.mesh.vertex_capacity()))));
    if (!scene.mesh.is_live(v)) continue;
    const auto choices = mesh::atomic_operations(scene.editor, v);
    if (choices.empty()) continue;
    left -= perform(scene.editor, choices[pick(choices.size())].operation).refusal == mesh::Refusal::none ? 1 : 0;
  }
}

// How does the time of a reduction grow with the quads of a disturbed torus? All its irregular vertices can be
// cancelled.
void reduce_disturbed_torus(benchmark::State& state) {
  const auto n = static_cast<int>(state.range(0));
  Scene disturbed(QuadMesh::from_faces(n * n, torus_faces(n)), torus_positions(n));
  disturb(disturbed);
  mesh::ReduceReport report;
  for (auto _ : state) {
    state.PauseTiming();
    Scene scene(disturbed.mesh, disturbed.positions);
    state.ResumeTiming();
    report = mesh::reduce(scene.editor, {});
    require(report.minimal, "the reduction is not minimal");
  }
  count_quads(state, disturbed.mesh);
  state.counters["irregular"] = report.before;
  state.counters["cancelled"] = report.cancelled;
  state.SetComplexityN(disturbed.mesh.face_count());
}
BENCHMARK(reduce_disturbed_torus)
    ->ArgName("side")
    ->RangeMultiplier(2)
    ->Range(16, 128)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

}  // namespace
}  // namespace requad::bench
