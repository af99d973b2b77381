// Helpers for the tests of edit scripts: a surface, and an editor that makes random edits on a copy of it.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "mesh/editing/script.hpp"
#include "mesh/files/surface.hpp"

namespace requad::tests {

// A surface, and an editor on a copy of it.
struct Workshop {
  mesh::Surface input;
  mesh::QuadMesh m;
  mesh::Positions positions;
  mesh::FeatureSet features;
  mesh::Editor editor;

  explicit Workshop(mesh::Surface surface)
      : input(std::move(surface)), m(input.mesh), positions(input.positions), editor(m, &features, &positions) {}
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  // Performs this many random legal operations. After every twentieth a vertex is placed, sometimes at -0. After every
  // hundredth some vertices are smoothed.
  void edit(int operations, std::mt19937& random);
  mesh::Script record() const;
};

// The surface of an OBJ text.
mesh::Surface read_back(const std::string& text);
// A torus with random positions, so that it has no symmetry.
mesh::Surface crooked_torus(int columns, int rows);
// Whether every vertex of the mesh has the same position in `a` and `b`, to the last bit.
bool same_positions(const mesh::QuadMesh& mesh, const mesh::Positions& a, const mesh::Positions& b);

// The text with the first occurrence of `what` replaced. Fails the test if there is none.
std::string replaced(std::string text, const std::string& what, const std::string& by);
std::vector<std::string> lines_of(const std::string& text);

}  // namespace requad::tests
