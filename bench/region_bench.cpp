// The cost of regions: of generating them, of naming them by signatures, of exploring them by moves with a mesh for
// each configuration, and of walking through the configurations on a single mesh.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include <benchmark/benchmark.h>

#include "bench/regions.hpp"
#include "bench/require.hpp"
#include "bench/subjects.hpp"
#include "enumerate/exploration.hpp"
#include "enumerate/walk.hpp"

namespace requad::bench {
namespace {

using theory::IntegerVector;
using theory::PairType;
using theory::RegionShape;

// How long does it take to make a digon strip by strip? It has d x d quads between the pair and d strips along each
// side, 7 d^2 quads in all.
void grow(benchmark::State& state) {
  const theory::Integer d = state.range(0);
  const theory::Configuration configuration{{d, d, IntegerVector::Constant(2, d)}, 1};
  std::int64_t quads = 0;
  for (auto _ : state) quads = enumerate::grow_region(theory::kDigon, configuration).mesh.face_count();
  state.SetItemsProcessed(state.iterations() * quads);
  state.SetComplexityN(quads);
}
BENCHMARK(grow)->Name("generate/grow")->ArgName("d")->RangeMultiplier(4)->Range(4, 256)->Complexity(benchmark::oNLogN);

// How long does it take to glue the digon from rectangles?
void glue(benchmark::State& state) {
  const theory::Integer d = state.range(0);
  std::int64_t quads = 0;
  for (auto _ : state) quads = spread_pair(theory::kDigon, d, d).mesh.face_count();
  state.SetItemsProcessed(state.iterations() * quads);
  state.SetComplexityN(quads);
}
BENCHMARK(glue)->Name("generate/glue")->ArgName("d")->RangeMultiplier(4)->Range(4, 256)->Complexity(benchmark::oN);

// Is the time for the signature of a region linear in its faces?
void region_signature(benchmark::State& state) {
  const mesh::Region region = spread_pair(theory::kDigon, 1, state.range(0) / 2 - 1);
  for (auto _ : state) benchmark::DoNotOptimize(mesh::signature(region));
  state.SetItemsProcessed(state.iterations() * 4 * region.mesh.face_count());
  state.SetComplexityN(region.mesh.face_count());
}
BENCHMARK(region_signature)->ArgName("L")->RangeMultiplier(2)->Range(16, 512)->Complexity(benchmark::oN);

// How does the time of a whole exploration of a regular digon grow with its side?
void exploration(benchmark::State& state) {
  const auto shape = RegionShape::regular(theory::kDigon, state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(enumerate::explore_all(shape, theory::Apex::without));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(exploration)->ArgName("L")->DenseRange(6, 24, 6)->Unit(benchmark::kMillisecond)->Complexity();

// --- the walk --------------------------------------------------------------------------------------------------------

// Basic operations: flips on the one hand, collapses and splits on the other.
struct Operations {
  std::int64_t flips = 0;
  std::int64_t others = 0;
};

// The operations of a walk, which makes every move of the predicted graph once in each direction (see pair_moves.hpp).
// Open and close take as many splits or collapses as the path is long, on average over its two ends. A slide flips
// along the diagonal of a rectangle and goes straight on for the rest. The sides of the rectangle are those of R_alpha
// before or after: the lesser ones for a 3-3 pair, the greater ones for a 5-5 pair. Those of a 3-5 pair do not change.
Operations operations_of_walk(const RegionShape& shape) {
  const PairType type = shape.type();
  Operations sum;
  const theory::ConfigurationMap map = theory::configuration_map(shape, theory::Apex::with);
  for (const theory::MapNode& node : map.nodes) {
    for (std::size_t slot = 0; slot < node.moves.size(); ++slot) {
      if (node.moves[slot].target < 0) continue;
      const theory::Configuration& from = node.labellings[slot];
      const theory::Configuration to = theory::stepped(type, from, node.steps[slot]);
      const theory::GridPoint offset = theory::step_offset(type, node.steps[slot]);
      const bool slides = type.symmetric() ? offset.m != offset.n : offset.n == 0;
      if (slides) {
        const auto side = [type](theory::Integer before, theory::Integer after) {
          return type.l2 == 3 ? std::min(before, after) : std::max(before, after);
        };
        const theory::Integer a = side(from.d1(), to.d1()), b = side(from.d2(), to.d2());
        sum.flips += std::min(a, b);
        sum.others += std::abs(a - b);
      } else {
        sum.others += (from.d1() + from.d2() + to.d1() + to.d2()) / 2;
      }
    }
  }
  return sum;
}

// Sides of length L. A regular region holds no 3-5 pair: there the sides have length L on average.
RegionShape walked_shape(PairType type, theory::Integer length) {
  if (type.symmetric()) return RegionShape::regular(type, length);
  const theory::Integer third = length / 3;
  return {type, theory::region_sides(type, {{third, third, IntegerVector::Constant(type.side_count(), third)}, 1})};
}

struct WalkBench {
  WalkBench(PairType type, std::int64_t length)
      : table(walked_shape(type, length)), start(enumerate::glue_region(type, table.smallest())) {}

  theory::ConfigurationTable table;
  mesh::Region start;
};

// How long does the bare kernel take for as many flips, collapses and splits as the walk makes? They are made at random
// sites of a torus. It has as many quads as the largest configuration of the region.
void walk_limit(benchmark::State& state, PairType type) {
  const WalkBench bench(type, state.range(0));
  const Operations todo = operations_of_walk(bench.table.shape());
  require(todo.flips + todo.others == enumerate::walk(bench.table, bench.start).operations,
          "these are not the operations of the walk");
  // random_sites() requires a multiple of 4.
  const int n = std::max(8, static_cast<int>(std::sqrt(static_cast<double>(bench.table.most_faces()))) / 4 * 4);
  KernelSubject subject(n);
  std::vector<KernelSubject::Site> sites;
  for (const auto& [a, b] : random_sites(n)) sites.push_back(subject.site(a, b));
  std::size_t i = 0;
  const auto at_sites = [&](std::int64_t pairs, auto&& there_and_back) {
    for (; pairs > 0; --pairs) {
      sites[i] = there_and_back(sites[i]);
      if (++i == sites.size()) i = 0;
    }
  };
  for (auto _ : state) {
    at_sites(todo.flips / 2, [&](int h) { return subject.flip_back(subject.flip(h)); });
    at_sites(todo.others / 2, [&](int h) { return subject.split(subject.collapse(h)); });
  }
  state.SetItemsProcessed(state.iterations() * (todo.flips + todo.others));
  state.counters["flips"] = static_cast<double>(todo.flips);
  state.SetComplexityN(state.range(0));
}

// Does the time of a walk over all configurations of a region grow with the cube of its side? How much more is it than
// the time of the bare operations? The walk plans and checks them, and traces separatrices to identify configurations.
void walk_requad(benchmark::State& state, PairType type) {
  const WalkBench bench(type, state.range(0));
  enumerate::WalkResult result;
  for (auto _ : state) {
    result = enumerate::walk(bench.table, bench.start);
    require(result.complete(), "the walk is incomplete");
  }
  state.SetItemsProcessed(state.iterations() * result.operations);
  state.counters["moves"] = static_cast<double>(result.moves);
  state.counters["traced"] = static_cast<double>(result.traced);
  state.SetComplexityN(state.range(0));
}

const int registered_regions = [] {
  const auto add = [](PairType type, std::int64_t least, std::int64_t most) {
    const auto shaped = [least, most](benchmark::internal::Benchmark* b) {
      b->ArgName("L")->Unit(benchmark::kMillisecond)->Complexity(benchmark::oNCubed);
      for (std::int64_t length = least; length <= most; length *= 2) b->Arg(length);
    };
    const std::string name = "walk/" + type.name();
    shaped(benchmark::RegisterBenchmark((name + "/limit").c_str(), walk_limit, type));
    shaped(benchmark::RegisterBenchmark((name + "/requad").c_str(), walk_requad, type));
  };
  add(theory::kDigon, 25, 400);
  add(theory::kHexagon, 15, 120);
  add(theory::kQuad, 24, 192);
  return 0;
}();

}  // namespace
}  // namespace requad::bench
