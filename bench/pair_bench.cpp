// The cost of a whole pair move compared with that of its basic operations alone, by kind of pair, step and distance.

#include <algorithm>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/regions.hpp"
#include "bench/require.hpp"
#include "mesh/irregular/pair_moves.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::bench {
namespace {

using mesh::PairMove;
using mesh::PairStep;
using mesh::QuadMesh;

// A pair that spans d x d quads, and one of its moves.
struct Start {
  Start(theory::PairType type, PairStep step, std::int64_t d) : mesh(spread_pair(type, d, 4).mesh) {
    const auto pair = mesh::irregular_vertices(mesh);
    const auto moves = mesh::pair_moves(mesh, pair[0], pair[1]);
    move = *std::find_if(moves.begin(), moves.end(), [step](const PairMove& m) { return m.step == step; });
  }

  QuadMesh mesh;
  PairMove move;
};

void by_distance(benchmark::internal::Benchmark* b) {
  b->ArgName("d")->RangeMultiplier(4)->Range(4, 256)->Complexity(benchmark::oN);
}

// How long do the basic operations of a move and their inverses take, as checked calls that are known beforehand?
void operations(benchmark::State& state, theory::PairType type, PairStep step) {
  Start start(type, step, state.range(0));
  QuadMesh copy = start.mesh;
  const mesh::MoveReport report = mesh::move_pair(copy, start.move);
  std::vector<mesh::BasicOperation> there_and_back = report.operations;
  there_and_back.insert(there_and_back.end(), report.undo.begin(), report.undo.end());
  for (auto _ : state) {
    for (const mesh::BasicOperation& operation : there_and_back) {
      require(mesh::apply(start.mesh, operation).refusal == mesh::Refusal::none, "an operation was refused");
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(there_and_back.size()));
  state.SetComplexityN(2 * state.range(0));
}

// How long do the move and its inverse take, which find their operations themselves? Each move changes ids. So a round
// of moves is prepared beforehand, and is repeated from the same mesh. The time does not include the search for frames.
void mover(benchmark::State& state, theory::PairType type, PairStep step) {
  constexpr int kRound = 256;
  const Start start(type, step, state.range(0));
  std::vector<PairMove> round{start.move};
  QuadMesh m = start.mesh;
  for (int i = 1; i < 2 * kRound; ++i) round.push_back(mesh::move_pair(m, round.back()).inverse);

  m = start.mesh;
  mesh::PairMover mover(m);
  std::int64_t made = 0;
  std::size_t next = 0;
  for (auto _ : state) {
    for (const std::size_t end = next + 2; next < end; ++next) {
      const mesh::PairMover::Moved moved = mover.move(round[next]);
      require(moved.refusal == mesh::Refusal::none, "an operation was refused");
      made += moved.operations;
    }
    if (next == round.size()) {
      state.PauseTiming();
      m = start.mesh;
      next = 0;
      state.ResumeTiming();
    }
  }
  state.SetItemsProcessed(made);
  state.SetComplexityN(2 * state.range(0));
}

const int registered_pairs = [] {
  for (const theory::PairType type : {theory::kDigon, theory::kHexagon, theory::kQuad}) {
    for (const PairStep step : mesh::kPairSteps) {
      const std::string name = "pair_move/" + type.name() + "/" + mesh::name(step);
      by_distance(benchmark::RegisterBenchmark((name + "/operations").c_str(), operations, type, step));
      by_distance(benchmark::RegisterBenchmark((name + "/mover").c_str(), mover, type, step));
    }
  }
  return 0;
}();

}  // namespace
}  // namespace requad::bench
