// A panel: one of several meshes in a figure, with marks on it and words below it.
#pragma once

#include <functional>

#include "mesh/pictures/mesh_picture.hpp"
#include "theory/pair_system.hpp"

namespace requad::figures {

using namespace pictures;

struct Panel {
  mesh::Region region;
  std::vector<std::string> words = {};  // below the mesh; each begins a new line
  std::vector<mesh::FaceId> stay = {};  // quads that stay; drawn pale
  std::vector<mesh::FaceId> grey = {};
  std::vector<mesh::FaceId> blue = {};
  std::vector<mesh::FaceId> made = {};
  std::vector<mesh::FaceId> deleted = {};
  struct Line {
    enum class Kind { path, feature, thin };
    std::vector<mesh::HalfEdgeId> path;
    Kind kind = Kind::path;
  };
  std::vector<Line> lines = {};
  mesh::HalfEdgeId direction = {};        // of a move: an arrow from its origin,
  double aside = 0;                       // so many units to the left of it
  std::vector<mesh::VertexId> dots = {};  // marked regular vertices
  double unit = 20;                       // an edge is about so long
  double angle = 0;                       // by which the mesh is turned, in radians
  // What a figure adds to the mesh, on top, and how far it reaches beyond the mesh at a size of letters.
  std::function<void(Canvas&, const MeshPicture&)> overlay = {};
  std::function<Point(const Canvas&)> margin = {};
};

// The region of a pair with these parameters, or of the merged vertex if d1 = d2 = 0. See enumerate::glue_region().
mesh::Region region_with(theory::PairType type, theory::Integer d1, theory::Integer d2,
                         const std::vector<theory::Integer>& strips);

// Strokes of paths on a mesh, the same in all figures.
Stroke stroke_of(const Canvas& canvas, Panel::Line::Kind kind);

// Draws the panel on the picture of its region, without its words.
void paint_panel(Canvas& canvas, const Panel& panel, const MeshPicture& picture);

}  // namespace requad::figures
