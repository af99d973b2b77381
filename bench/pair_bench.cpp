// What pair moves, signatures and explorations cost, by the size of the region.

#include <benchmark/benchmark.h>

#include "enumerate/exploration.hpp"
#include "enumerate/generators.hpp"
#include "enumerate/walk.hpp"
#include "mesh/separatrix.hpp"
#include "mesh/signature.hpp"

namespace {

using namespace requad;

mesh::Region digon(std::int64_t length, std::int64_t d1, std::int64_t d2) {
  theory::Configuration c;
  c.parameters = {d1, d2, theory::IntegerVector::Constant(2, (length - d1 - d2) / 2)};
  return enumerate::glue_region(theory::kDigon, c);
}

// How long does a flip and its inverse take, checked?
void flip_and_back(benchmark::State& state) {
  mesh::Region region = digon(64, 10, 10);
  const mesh::HalfEdgeId h = mesh::QuadMesh::half_edge(mesh::FaceId(40), 1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(mesh::flip(region.mesh, h, mesh::Turn::counter_clockwise));
    benchmark::DoNotOptimize(mesh::flip(region.mesh, mesh::QuadMesh::next(h), mesh::Turn::clockwise));
  }
}
BENCHMARK(flip_and_back);

// Does a pair move and its inverse cost time linear in d1 + d2, whatever the size of the mesh?
void open_and_close(benchmark::State& state) {
  const std::int64_t d = state.range(0);
  mesh::Region region = digon(state.range(1), d, d);
  mesh::PairMove move;
  for (const mesh::VertexId v : region.mesh.vertices()) {
    if (!region.mesh.is_boundary(v) && region.mesh.valence(v) == 3 && !move.frame.v1.valid()) {
      region.mesh.for_each_out(v, [&](mesh::HalfEdgeId h) {
        const auto frame = mesh::frame_at(region.mesh, h, static_cast<int>(d), static_cast<int>(d));
        if (frame && region.mesh.valence(frame->v2) == 3) move = {*frame, mesh::PairStep::open};
      });
    }
  }
  for (auto _ : state) {
    const auto report = mesh::move_pair(region.mesh, move);
    if (report.refusal != mesh::Refusal::none) state.SkipWithError("refused");
    const auto back = mesh::move_pair(region.mesh, report.inverse);
    move = back.inverse;
  }
  state.SetComplexityN(2 * d);
}
BENCHMARK(open_and_close)->Args({4, 128})->Args({8, 128})->Args({16, 128})->Args({32, 128})->Args({32, 256})->Args({32, 512});

// Is the signature of a region linear in its faces?
void region_signature(benchmark::State& state) {
  const mesh::Region region = digon(state.range(0), 1, 1);
  for (auto _ : state) benchmark::DoNotOptimize(mesh::signature(region));
  state.SetItemsProcessed(state.iterations() * 4 * region.mesh.face_count());
  state.SetComplexityN(region.mesh.face_count());
}
BENCHMARK(region_signature)->RangeMultiplier(2)->Range(16, 512)->Complexity(benchmark::oN);

// How does a whole exploration of a regular digon grow with its side?
void exploration(benchmark::State& state) {
  const theory::IntegerVector sides = theory::IntegerVector::Constant(2, state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(enumerate::explore_all(theory::kDigon, sides, theory::Apex::without));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(exploration)->DenseRange(6, 24, 6)->Unit(benchmark::kMillisecond)->Complexity();

// Does a walk over all configurations of a regular digon, each identified by its separatrices, grow with the cube of its
// side? (Time for a basic operation: what the operations and the tracing of separatrices cost together.)
void walk(benchmark::State& state) {
  const theory::ConfigurationTable table(theory::kDigon, theory::IntegerVector::Constant(2, state.range(0)));
  const mesh::Region start = enumerate::glue_region(theory::kDigon, table.smallest());
  enumerate::WalkResult result;
  for (auto _ : state) {
    result = enumerate::walk(table, start);
    if (!result.complete()) state.SkipWithError("incomplete");
  }
  state.SetItemsProcessed(state.iterations() * result.operations);
  state.counters["moves"] = static_cast<double>(result.moves);
  state.counters["operations"] = static_cast<double>(result.operations);
  state.counters["traced"] = static_cast<double>(result.traced);
  state.SetComplexityN(state.range(0));
}
BENCHMARK(walk)->RangeMultiplier(2)->Range(25, 400)->Unit(benchmark::kMillisecond)->Complexity(benchmark::oNCubed);

// What does a pair move without a report cost for each of its operations, by the distance of the pair?
void mover_open_and_close(benchmark::State& state) {
  const auto d = static_cast<int>(state.range(0));
  mesh::Region region = digon(4 * d, d, d);
  const auto v = mesh::irregular_vertices(region.mesh);
  mesh::PairMove open{mesh::find_frames(region.mesh, v[0], v[1]).front(), mesh::PairStep::open};
  mesh::PairMover mover(region.mesh);
  std::int64_t operations = 0;
  for (auto _ : state) {
    const auto there = mover.move(open);
    state.PauseTiming();
    const auto close = mesh::PairMove{mesh::find_frames(region.mesh, there.v1, there.v2).front(), mesh::PairStep::close};
    state.ResumeTiming();
    const auto back = mover.move(close);
    state.PauseTiming();
    open.frame = mesh::find_frames(region.mesh, back.v1, back.v2).front();
    state.ResumeTiming();
    operations += there.operations + back.operations;
  }
  state.SetItemsProcessed(operations);
}
BENCHMARK(mover_open_and_close)->Arg(64)->Arg(256);

}  // namespace
