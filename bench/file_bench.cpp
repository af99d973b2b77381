// Files. An OBJ of a torus is read, turned into a mesh, validated and written.

#include "bench/file_bench.hpp"

#include "mesh/files/read_polygons.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/topology/validate.hpp"

namespace requad::bench {
namespace {

// How long does it take to read an OBJ of n x n quads, to turn it into a checked mesh, and to write it again?
void obj_read_and_write(benchmark::State& state) {
  const ObjFile file(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const mesh::Surface surface = mesh::read_surface(file.path(), false);
    program::write_text(file.copy(), mesh::obj_text(surface.mesh, surface.positions));
  }
  file.require_same_copy();
  count_file_quads(state);
}
BENCHMARK(obj_read_and_write)->Name("obj_read_and_write/requad")->Apply(sides);

// How much of that time goes into reading the text?
void obj_read(benchmark::State& state) {
  const ObjFile file(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(mesh::read_polygon_mesh(file.path()));
  count_file_quads(state);
}
BENCHMARK(obj_read)->Apply(sides);

// How much goes into building the mesh?
void obj_to_mesh(benchmark::State& state) {
  const ObjFile file(static_cast<int>(state.range(0)));
  const mesh::PolygonMesh polygons = mesh::read_polygon_mesh(file.path());
  for (auto _ : state) benchmark::DoNotOptimize(mesh::to_quad_mesh(polygons));
  count_file_quads(state);
}
BENCHMARK(obj_to_mesh)->Apply(sides);

// How much goes into writing?
void obj_write(benchmark::State& state) {
  const ObjFile file(static_cast<int>(state.range(0)));
  const mesh::Surface surface = mesh::read_surface(file.path(), false);
  for (auto _ : state) program::write_text(file.copy(), mesh::obj_text(surface.mesh, surface.positions));
  count_file_quads(state);
}
BENCHMARK(obj_write)->Apply(sides);

// How long does the validator take to look for every defect?
void validate_mesh(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const mesh::QuadMesh m = mesh::QuadMesh::from_faces(n * n, torus_faces(n));
  for (auto _ : state) benchmark::DoNotOptimize(mesh::validate(m));
  count_file_quads(state);
}
BENCHMARK(validate_mesh)->Apply(sides);

}  // namespace
}  // namespace requad::bench
