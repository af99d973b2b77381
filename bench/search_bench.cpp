// The cost of the exhaustive search on one core: states per second, states per filling, and savings by pruning rules.

#include <benchmark/benchmark.h>

#include "bench/require.hpp"
#include "enumerate/search/search.hpp"
#include "enumerate/search/spheres.hpp"

namespace requad::bench {
namespace {

using namespace enumerate;

SearchProblem regular_polygon(std::int64_t corners, std::int64_t side, std::vector<int> irregular) {
  return search_problem(std::vector<int>(static_cast<std::size_t>(corners), static_cast<int>(side)),
                        std::move(irregular));
}

SearchOutcome time_search(benchmark::State& state, const SearchProblem& problem, SearchLimits limits = {}) {
  limits.threads = 1;
  SearchOutcome found;
  for (auto _ : state) found = search(problem, limits, {});
  state.SetItemsProcessed(state.iterations() * found.states);
  state.counters["states"] = static_cast<double>(found.states);
  state.counters["fillings"] = static_cast<double>(found.count);
  if (found.count > 0)
    state.counters["states/filling"] = static_cast<double>(found.states) / static_cast<double>(found.count);
  return found;
}

// How many states per second does the search visit in a digon with a 3-3 pair? How does the time grow with the side?
void digon_33(benchmark::State& state) {
  time_search(state, regular_polygon(2, state.range(0), {3, 3}));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(digon_33)->ArgName("L")->DenseRange(8, 32, 8)->Unit(benchmark::kMillisecond)->Complexity();

// The same questions for a hexagon with a 5-5 pair.
void hexagon_55(benchmark::State& state) {
  time_search(state, regular_polygon(6, state.range(0), {5, 5}));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(hexagon_55)->ArgName("L")->DenseRange(4, 10, 2)->Unit(benchmark::kMillisecond)->Complexity();

// The same questions for a four-sided region with a 3-5 pair.
void quad_35(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  time_search(state, search_problem({side, side - 2, side + 2, side}, {3, 5}));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(quad_35)->ArgName("L")->DenseRange(6, 15, 3)->Unit(benchmark::kMillisecond)->Complexity();

// The same questions for a triangle with three irregular vertices.
void triangle_335(benchmark::State& state) {
  time_search(state, regular_polygon(3, state.range(0), {3, 3, 5}));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(triangle_335)->ArgName("L")->DenseRange(4, 10, 2)->Unit(benchmark::kMillisecond)->Complexity();

// The same questions for a region without corners, with a bound on the number of faces.
void without_corners(benchmark::State& state) {
  SearchLimits limits;
  limits.faces = static_cast<int>(state.range(0));
  time_search(state, {std::vector<int>(10, 2), {3, 3, 3, 3}}, limits);
  state.SetComplexityN(state.range(0));
}
BENCHMARK(without_corners)->ArgName("faces")->DenseRange(20, 40, 10)->Unit(benchmark::kMillisecond)->Complexity();

// How many more states does the search visit without one pruning rule (0 Gauss-Bonnet, 1 parity, 2 face bound)?
void without_rule(benchmark::State& state, const SearchProblem& problem, int faces) {
  constexpr bool SearchPruning::*kRules[] = {&SearchPruning::gauss_bonnet, &SearchPruning::parity,
                                             &SearchPruning::face_bound};
  SearchLimits limits;
  limits.faces = faces;
  limits.threads = 1;
  const SearchOutcome with = search(problem, limits, {});
  limits.pruning.*kRules[state.range(0)] = false;
  const SearchOutcome without = time_search(state, problem, limits);
  require(without.by_faces == with.by_faces, "a rule changed what was found");
  state.counters["states_with"] = static_cast<double>(with.states);
  state.counters["times_more"] = static_cast<double>(without.states) / static_cast<double>(with.states);
}
BENCHMARK_CAPTURE(without_rule, digon_33, regular_polygon(2, 12, {3, 3}), 144)
    ->ArgName("rule")
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(without_rule, hexagon_55, regular_polygon(6, 5, {5, 5}), 80)
    ->ArgName("rule")
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(without_rule, triangle_335, regular_polygon(3, 6, {3, 3, 5}), 40)
    ->ArgName("rule")
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(without_rule, no_corners, SearchProblem{std::vector<int>(10, 2), {3, 3, 3, 3}}, 30)
    ->ArgName("rule")
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(without_rule, concave, SearchProblem{{3, 3, 1, 3, 3, 1}, {2, 3, 3, 3, 3}}, 14)
    ->ArgName("rule")
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond);

// How long does it take to find the closed spheres with eight v3s, up to a number of vertices?
void octahedrites(benchmark::State& state) {
  SearchLimits limits;
  limits.threads = 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(search_spheres(std::vector<int>(8, 3), static_cast<int>(state.range(0)), limits));
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(octahedrites)->ArgName("vertices")->DenseRange(16, 24, 4)->Unit(benchmark::kMillisecond)->Complexity();

}  // namespace
}  // namespace requad::bench
