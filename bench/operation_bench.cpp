// Basic operations, traversal and building against the bare kernel.

#include "bench/operation_bench.hpp"

namespace requad::bench {
namespace {

void sides(benchmark::internal::Benchmark* b) {
  b->ArgName("side")->RangeMultiplier(2)->Range(128, 1024)->Unit(benchmark::kMicrosecond)->Complexity(benchmark::oN);
}

// How long does it take to pair the edges of a torus of n x n quads, without testing whether it is a mesh?
void build_kernel(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const FaceList faces = torus_faces(n);
  for (auto _ : state) {
    Kernel kernel;
    kernel.build(n * n, faces);
    benchmark::DoNotOptimize(kernel.twin(0));
  }
  state.SetComplexityN(n * n);
}
BENCHMARK(build_kernel)->Name("build/kernel")->Apply(sides);

// How long does it take with every test, and with a half-edge for each vertex?
void build_requad(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const FaceList faces = torus_faces(n);
  for (auto _ : state) benchmark::DoNotOptimize(mesh::QuadMesh::from_faces(n * n, faces));
  state.SetComplexityN(n * n);
}
BENCHMARK(build_requad)->Name("build/requad")->Apply(sides);

// How long does it take to visit the neighbours of every vertex?
void one_rings_kernel(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  KernelSubject subject(n);
  Kernel& kernel = subject.kernel;
  for (auto _ : state) {
    std::int64_t sum = 0;
    for (int v = 0; v < n * n; ++v) {
      const int first = kernel.out(v);
      int h = first;
      do {
        sum += kernel.origin(Kernel::next(h));
        h = kernel.twin(Kernel::previous(h));
      } while (h != first);
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetComplexityN(n * n);
}
BENCHMARK(one_rings_kernel)->Name("one_rings/kernel")->Apply(sides);

// How long does it take with a test for the boundary at each half-edge?
void one_rings_requad(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const mesh::QuadMesh m = mesh::QuadMesh::from_faces(n * n, torus_faces(n));
  for (auto _ : state) {
    std::int64_t sum = 0;
    for (int v = 0; v < n * n; ++v)
      m.for_each_out(mesh::VertexId(v), [&](mesh::HalfEdgeId h) { sum += m.target(h).index(); });
    benchmark::DoNotOptimize(sum);
  }
  state.SetComplexityN(n * n);
}
BENCHMARK(one_rings_requad)->Name("one_rings/requad")->Apply(sides);

const int registered_operations = [] {
  register_operations<KernelSubject>();
  register_operations<RequadSubject<false>>();
  register_operations<RequadSubject<true>>();
  return 0;
}();

}  // namespace
}  // namespace requad::bench
