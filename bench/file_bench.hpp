// The file on which loading and writing are measured.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <benchmark/benchmark.h>

#include "bench/require.hpp"
#include "bench/subjects.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/program/run/outputs.hpp"

namespace requad::bench {

// Ten thousand, a hundred thousand and a million quads.
inline void sides(benchmark::internal::Benchmark* b) {
  b->ArgName("side")->Arg(100)->Arg(316)->Arg(1000)->Unit(benchmark::kMillisecond)->Complexity(benchmark::oN);
}
inline void count_file_quads(benchmark::State& state) {
  const std::int64_t quads = state.range(0) * state.range(0);
  state.SetItemsProcessed(state.iterations() * quads);
  state.SetComplexityN(quads);
}

// An OBJ of a torus of n x n quads in the folder for temporary files, and a path for a copy. The destructor removes
// both.
class ObjFile {
 public:
  explicit ObjFile(int n) : path_(std::filesystem::temp_directory_path() / "requad-bench.obj") {
    program::write_text(path(), mesh::obj_text(mesh::QuadMesh::from_faces(n * n, torus_faces(n)), torus_positions(n)));
  }
  ~ObjFile() {
    std::remove(path().c_str());
    std::remove(copy().c_str());
  }
  ObjFile(const ObjFile&) = delete;
  ObjFile& operator=(const ObjFile&) = delete;

  std::string path() const { return path_.string(); }
  std::string copy() const { return path_.string() + ".copy.obj"; }
  void require_same_copy() const {
    const auto text = [](const std::string& name) {
      std::ifstream in(name, std::ios::binary);
      return std::string(std::istreambuf_iterator<char>(in), {});
    };
    require(text(path()) == text(copy()), "the copy of the file differs");
  }

 private:
  std::filesystem::path path_;
};

}  // namespace requad::bench
