// Reads a quad mesh, makes the first pair move that its first two irregular vertices have, and writes the result.
#include <iostream>

#include <requad/mesh/editing/editor.hpp>
#include <requad/mesh/files/surface.hpp>
#include <requad/mesh/files/write_obj.hpp>
#include <requad/mesh/irregular/pair_moves.hpp>
#include <requad/mesh/topology/separatrix.hpp>

int main(int argc, char** argv) {
  using namespace requad::mesh;
  if (argc != 2) return 2;
  Surface surface = read_surface(argv[1], /*subdivided=*/false);
  const std::vector<VertexId> irregular = irregular_vertices(surface.mesh);
  if (irregular.size() < 2) return 1;

  Editor editor(surface.mesh, /*features=*/nullptr, &surface.positions);
  for (const PairMove& move : pair_moves(surface.mesh, irregular[0], irregular[1])) {
    const MoveReport report = move_pair(editor, move);
    std::cerr << name(move.step) << ": " << report.refusal.clause() << '\n';
    if (report.refusal != Refusal::none) continue;  // the mesh is as it was
    std::cout << obj_text(surface.mesh, surface.positions);
    return 0;
  }
  return 1;
}
