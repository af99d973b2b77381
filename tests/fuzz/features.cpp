// Lists of feature edges.
#include "mesh/files/feature_edges.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/open_cube.hpp"

const requad::fuzz::Memory requad::fuzz::kMemory{32 << 10, 100};

void requad::fuzz::try_input(std::string_view text) {
  mesh::FeatureEdges edges;
  if (!accepts([&] { edges = mesh::parse_feature_edges(text, "features", open_cube()); })) return;
  std::string list;
  for (const auto& [a, b] : edges) {
    const mesh::HalfEdgeId h = open_cube().mesh.find_half_edge(a, b);
    require(h.valid() && !open_cube().mesh.is_boundary(h), "a feature that is no inner edge");
    list += std::to_string(open_cube().file_vertex[a.slot()] + 1) + " ";
    list += std::to_string(open_cube().file_vertex[b.slot()] + 1) + "\n";
  }
  require(mesh::parse_feature_edges(list, "again", open_cube()) == edges, "what was written reads differently");
}
