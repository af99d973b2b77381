// A panel: one mesh of a figure that has several, with its marks and the words below it.
#pragma once

#include "mesh/pictures/mesh_picture.hpp"
#include "theory/pair_system.hpp"

namespace requad::figures {

using namespace pictures;

struct Panel {
  mesh::Region region;
  std::vector<std::string> words = {};
  std::vector<mesh::FaceId> stay = {};  // strips that stay
  std::vector<mesh::FaceId> grey = {};
  std::vector<mesh::FaceId> blue = {};
  std::vector<mesh::FaceId> made = {};
  std::vector<mesh::FaceId> deleted = {};
  struct Line {
    std::vector<mesh::HalfEdgeId> path;
    Stroke stroke;
    bool arrow = false;  // at its end
  };
  std::vector<Line> lines = {};
  std::vector<mesh::VertexId> dots = {};  // regular vertices to be seen
};

// The region with a pair (or, with d1 = d2 = 0, the merged vertex) and these strips; see enumerate::glue_region.
mesh::Region region_with(theory::PairType type, theory::Integer d1, theory::Integer d2,
                         const std::vector<theory::Integer>& strips);

inline constexpr Stroke kGreenLine{ink::kGreen, 2.4};

// With edges about `unit` long; the words below, `text` points high.
void paint_panel(Canvas& canvas, const Panel& panel, Point centre, double unit, double angle = 0, double text = 10);

}  // namespace requad::figures
