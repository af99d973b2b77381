// The gain from a second core. One search and one sweep of regions run with one thread and with two, in real time.

#include <benchmark/benchmark.h>

#include "bench/require.hpp"
#include "enumerate/search/search.hpp"
#include "verify/campaign.hpp"

namespace requad::bench {
namespace {

void one_and_two(benchmark::internal::Benchmark* b) {
  b->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
}

// How much faster does one large search become?
void search_threads(benchmark::State& state) {
  enumerate::SearchLimits limits;
  limits.threads = static_cast<int>(state.range(0));
  const enumerate::SearchProblem problem = enumerate::search_problem({14, 14, 14}, {3, 3, 5});
  std::int64_t states = 0;
  for (auto _ : state) states = enumerate::search(problem, limits, {}).states;
  state.SetItemsProcessed(state.iterations() * states);
}
BENCHMARK(search_threads)->Apply(one_and_two);

// How much faster does the check of every claim on many regions become?
void sweep_threads(benchmark::State& state) {
  verify::Ranges ranges;
  ranges.digon = {3, 20};
  ranges.hexagon = {3, 8};
  ranges.quad_perimeter = {8, 16};
  const std::vector<verify::RegionCase> cases = verify::list_cases(
      ranges, {verify::Family::regular_digon, verify::Family::regular_hexagon, verify::Family::quad});
  std::vector<const verify::Claim*> claims;
  for (const verify::Claim& claim : verify::claims()) claims.push_back(&claim);
  verify::Running running;
  running.threads = static_cast<int>(state.range(0));
  running.quiet = true;
  for (auto _ : state) {
    for (const auto& result : verify::run_campaign(claims, cases, {verify::Method::moves}, running).claims) {
      require(!result.violation, "a claim fails");
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cases.size()));
}
BENCHMARK(sweep_threads)->Apply(one_and_two);

}  // namespace
}  // namespace requad::bench
