// Quads of OBJ files and their distance, by brute force: nothing of the library is used, so the two can be compared.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <vector>

#include <Eigen/Core>

namespace requad::tests {

struct Quads {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::size_t, 4>> faces;
};

// Positions and faces of an OBJ file, as its lines have them.
Quads read_quads(const std::filesystem::path& path);

// The largest distance, both ways, of the vertices and the midpoints of edges of one file from the quads of the other,
// over the diagonal of the input. A quad has two ways to be cut into triangles. The nearer one counts, for nobody knows
// which one a reader takes.
double shape_lost(const std::filesystem::path& input, const std::filesystem::path& output);

}  // namespace requad::tests
