// Sheets: figures of several panels with arrows between them, and what operations do to the region of a panel.
#pragma once

#include <array>
#include <vector>

#include "figures/pictures/panel.hpp"
#include "mesh/topology/basic_operations.hpp"

namespace requad::figures {

struct PlacedPanel {
  Panel panel;
  Point centre;
  double unit = 20;  // see paint_panel()
  double angle = 0;
};

struct Sheet {
  std::vector<PlacedPanel> panels;
  std::vector<std::array<Point, 2>> arrows;

  void arrow(Point from, Point to) { arrows.push_back({from, to}); }
};
Paint paint(const Sheet& sheet);

// Throws std::logic_error with the reason if the operation of a figure was refused.
void require_performed(mesh::Refusal refusal);

// An irregular vertex of this valence. Throws std::logic_error if the mesh has none.
mesh::VertexId irregular_vertex(const mesh::QuadMesh& mesh, int valence);

// The region after operations on its mesh, which may have changed the id of the root.
mesh::Region with_mesh(const mesh::Region& before, const mesh::QuadMesh& after);

// The effect of basic operations on a region.
struct RegionChange {
  mesh::Region after;
  std::vector<mesh::FaceId> made;        // faces of `after`
  std::vector<mesh::FaceId> deleted;     // faces of the region before
  std::vector<mesh::VertexId> reshaped;  // vertices whose valence changed, removed ones included
};
// Throws as require_performed().
RegionChange perform_all(const mesh::Region& region, const std::vector<mesh::BasicOperation>& operations);

}  // namespace requad::figures
