// A panel: one of several meshes in a figure, with marks on it and words below it.
#pragma once

#include "mesh/pictures/mesh_picture.hpp"
#include "theory/pair_system.hpp"

namespace requad::figures {

using namespace pictures;

struct Panel {
  mesh::Region region;
  std::vector<std::string> words = {};  // lines of text below the mesh
  std::vector<mesh::FaceId> stay = {};  // quads that stay; drawn pale
  std::vector<mesh::FaceId> grey = {};
  std::vector<mesh::FaceId> blue = {};
  std::vector<mesh::FaceId> made = {};
  std::vector<mesh::FaceId> deleted = {};
  struct Line {
    std::vector<mesh::HalfEdgeId> path;
    Stroke stroke;
    bool arrow = false;  // an arrow from the first to the last vertex
  };
  std::vector<Line> lines = {};
  std::vector<mesh::VertexId> dots = {};  // marked regular vertices
};

// The region of a pair with these parameters, or of the merged vertex if d1 = d2 = 0. See enumerate::glue_region().
mesh::Region region_with(theory::PairType type, theory::Integer d1, theory::Integer d2,
                         const std::vector<theory::Integer>& strips);

inline constexpr Stroke kGreenLine{ink::kGreen, 2.4};

// Draws the panel around `centre`, turned by an angle in radians. Edges are about `unit` points long, and letters are
// `text` points high.
void paint_panel(Canvas& canvas, const Panel& panel, Point centre, double unit, double angle = 0, double text = 10);

}  // namespace requad::figures
