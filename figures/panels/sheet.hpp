// Sheets: figures of several panels with arrows between them, and what operations do to the region of a panel.
//
// Term
//   cell  What a sheet places: a panel, or anything else that can be painted round a point, with words below it.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "figures/panels/panel.hpp"
#include "mesh/topology/basic_operations.hpp"

namespace requad::figures {

struct Cell {
  Point size;  // of what is painted, in units
  std::function<void(Canvas&, const Point& centre)> paint;
  std::vector<std::string> words = {};              // below it; each begins a new line
  std::function<Point(const Canvas&)> margin = {};  // see Panel
};
Cell cell(Panel panel);

// Cells in rows and columns. All columns are equally wide, and so far apart that meshes and words have room. In a row,
// the middles of the meshes are level, and so are the first lines of their words.
class Sheet {
 public:
  // The least distance between the meshes of neighbouring columns, and between a row and the next one.
  explicit Sheet(double column_gap = 56, double row_gap = 26) : column_gap_(column_gap), row_gap_(row_gap) {}

  // Adds a cell, and returns its number. Columns may lie between others, as 0.5 does.
  std::size_t add(Cell cell, int row, double column);
  std::size_t add(Panel panel, int row, double column) { return add(cell(std::move(panel)), row, column); }
  // Adds an arrow between two cells.
  void arrow(std::size_t from, std::size_t to) { arrows_.push_back({from, to}); }

  Paint paint() const;

 private:
  struct Placed {
    Cell cell;
    int row;
    double column;
  };
  struct Layout;
  Layout layout(const Canvas& canvas) const;
  void paint_arrow(Canvas& canvas, const Layout& layout, std::size_t from, std::size_t to) const;

  double column_gap_, row_gap_;
  std::vector<Placed> cells_;
  std::vector<std::array<std::size_t, 2>> arrows_;
};

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
// The edge that a flip has turned, afterwards. Precondition: the operation is a flip.
mesh::HalfEdgeId turned_edge(const mesh::BasicOperation& flip);

// Throws as require_performed().
RegionChange perform_all(const mesh::Region& region, const std::vector<mesh::BasicOperation>& operations);

}  // namespace requad::figures
