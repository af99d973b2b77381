// The file that loading and writing are measured on.
#pragma once

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include <benchmark/benchmark.h>

#include "bench/subjects.hpp"
#include "mesh/obj.hpp"

namespace requad::bench {

// 100^2 and 1000^2 quads.
inline void sides(benchmark::internal::Benchmark* b) {
  b->ArgName("side")->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
}

// A torus of n x n quads in the folder for temporary files, and a place for a copy; both go with this object.
class ObjFile {
 public:
  explicit ObjFile(int n) : path_(std::filesystem::temp_directory_path() / "requad-bench.obj") {
    mesh::Positions positions;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const double s = 2 * std::numbers::pi * i / n, t = 2 * std::numbers::pi * j / n;
        positions.emplace_back((3 + std::cos(t)) * std::cos(s), (3 + std::cos(t)) * std::sin(s), std::sin(t));
      }
    }
    mesh::save_obj(path(), mesh::QuadMesh::from_faces(n * n, torus_faces(n)), positions);
  }
  ~ObjFile() {
    std::remove(path().c_str());
    std::remove(copy().c_str());
  }
  ObjFile(const ObjFile&) = delete;
  ObjFile& operator=(const ObjFile&) = delete;

  std::string path() const { return path_.string(); }
  std::string copy() const { return path_.string() + ".copy.obj"; }
  void require_same_copy(benchmark::State& state) const {
    const auto text = [](const std::string& name) {
      std::ifstream in(name, std::ios::binary);
      return std::string(std::istreambuf_iterator<char>(in), {});
    };
    if (text(path()) != text(copy())) state.SkipWithError("the copy differs");
  }

 private:
  std::filesystem::path path_;
};

}  // namespace requad::bench
