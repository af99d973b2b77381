// The same operations by every subject (subjects.hpp). Each benchmark is registered once for each subject, so that one
// run gives the ratios.
#pragma once

#include <benchmark/benchmark.h>

#include "bench/subjects.hpp"

namespace requad::bench {

// The number of iterations is fixed, so that each large mesh is built only once. It is four times the number of sites
// of the larger torus.
constexpr benchmark::IterationCount kRounds = 1 << 18;

// Throws if the subject does not make the same meshes as requad. Only the first call tests this.
template <class Subject>
void require_same_meshes_once() {
  static const bool same = (require_same_meshes<Subject>(), true);
  benchmark::DoNotOptimize(same);
}

// Times there_and_back(subject, site) at random sites of a torus. The function returns the site's new handle.
template <class Subject, class ThereAndBack>
void at_random_sites(benchmark::State& state, ThereAndBack&& there_and_back) {
  require_same_meshes_once<Subject>();
  const int n = static_cast<int>(state.range(0));
  Subject subject(n);
  std::vector<typename Subject::Site> sites;
  for (const auto& [a, b] : random_sites(n)) sites.push_back(subject.site(a, b));
  std::size_t i = 0;
  for (auto _ : state) {
    auto& site = sites[i];
    site = there_and_back(subject, site);
    if (++i == sites.size()) i = 0;
  }
}

// How long do a flip and the flip back take at random sites of a torus of n x n quads?
template <class Subject>
void flip_and_back(benchmark::State& state) {
  at_random_sites<Subject>(state, [](Subject& subject, auto& site) { return subject.flip_back(subject.flip(site)); });
}

// How long do a collapse and the split that undoes it take at random sites of a torus of n x n quads?
template <class Subject>
void collapse_and_split(benchmark::State& state) {
  at_random_sites<Subject>(state, [](Subject& subject, auto& site) { return subject.split(subject.collapse(site)); });
}

template <class Subject>
void register_operations() {
  const auto add = [](const char* name, void (*function)(benchmark::State&)) {
    benchmark::RegisterBenchmark((std::string(name) + "/" + Subject::kName).c_str(), function)
        ->ArgName("side")
        ->Arg(128)
        ->Arg(1024)
        ->Iterations(kRounds);
  };
  add("flip_and_back", flip_and_back<Subject>);
  if constexpr (requires { typename Subject::Undo; }) add("collapse_and_split", collapse_and_split<Subject>);
}

}  // namespace requad::bench
