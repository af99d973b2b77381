#include "figures/pictures/basic_operation_pictures.hpp"

#include <stdexcept>

#include "figures/pictures/sheet.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::figures {

namespace {

using mesh::BasicOperation;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;

// A grid of regular vertices, rooted at its lower left. Vertex (column, row) has the id column (rows + 1) + row.
Region grid(int columns, int rows) {
  const auto at = [=](int i, int j) { return i * (rows + 1) + j; };
  std::vector<std::array<int, 4>> faces;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  Region region{QuadMesh::from_faces((columns + 1) * (rows + 1), faces), {}};
  region.root = region.mesh.out(VertexId(0));
  return region;
}

// The half-edge from vertex (i, j) of a grid to (i + di, j + dj).
HalfEdgeId grid_edge(const Region& g, int rows, int i, int j, int di, int dj) {
  return g.mesh.find_half_edge(VertexId(i * (rows + 1) + j), VertexId((i + di) * (rows + 1) + j + dj));
}

// The layout of this figure: panels in columns and rows, with arrows between neighbouring columns.
class OperationSheet {
 public:
  void add(Panel panel, double column, double row) {
    sheet_.panels.push_back({std::move(panel), {column * kX, row * kY}, kUnit});
  }
  // Adds an arrow between a column and the next one. It points to the right for direction 1, to the left for -1.
  void arrow(double column, double row, double direction) {
    const double x = (column + 0.5) * kX;
    sheet_.arrow({x - direction * 14, row * kY}, {x + direction * 14, row * kY});
  }
  const Sheet& sheet() const { return sheet_; }

 private:
  static constexpr double kUnit = 20, kX = 165, kY = -150;
  Sheet sheet_;
};

void add_collapse(OperationSheet& sheet) {
  const Region five = grid(5, 5);
  const HalfEdgeId middle = grid_edge(five, 5, 2, 2, 1, 0);
  const RegionChange collapse = perform_all(five, {{BasicOperation::Kind::collapse, middle, {}, 0}});
  Panel panel{five, {"a quad between two regular vertices"}};
  panel.deleted = collapse.deleted;
  panel.dots = {five.mesh.origin(middle), five.mesh.target(QuadMesh::next(middle))};
  sheet.add(panel, 0, 0);
  sheet.add({collapse.after, {"quad collapse"}}, 1, 0);
  sheet.arrow(0, 0, 1);
}

void add_split(OperationSheet& sheet) {
  const Region four = grid(4, 4);
  const HalfEdgeId right = grid_edge(four, 4, 2, 2, 1, 0), from_left = grid_edge(four, 4, 1, 2, 1, 0);
  const RegionChange split = perform_all(four, {{BasicOperation::Kind::split, right, from_left, 0}});
  Panel panel{four, {"two edges of a path"}};
  panel.lines = {{{from_left, right}, kGreenLine}};
  sheet.add(panel, 2.2, 0);
  panel = {split.after, {"edge split"}};
  panel.made = split.made;
  sheet.add(panel, 3.2, 0);
  sheet.arrow(2.2, 0, 1);
}

void add_flips(OperationSheet& sheet, const Region& patch, HalfEdgeId edge) {
  Panel panel{patch, {"an edge"}};
  panel.lines = {{{edge}, kGreenLine}};
  sheet.add(panel, 1.6, 1);
  for (const auto kind : {BasicOperation::Kind::flip_cw, BasicOperation::Kind::flip_ccw}) {
    const bool left = kind == BasicOperation::Kind::flip_ccw;
    const RegionChange flip = perform_all(patch, {{kind, edge, {}, 0}});
    Panel result{flip.after, {left ? "edge flip, counter-clockwise" : "edge flip, clockwise"}};
    result.lines = {{{left ? QuadMesh::next(edge) : QuadMesh::previous(edge)}, kGreenLine}};
    sheet.add(result, left ? 0.6 : 2.6, 1);
    sheet.arrow(left ? 0.6 : 1.6, 1, left ? -1 : 1);
  }
}

// The edge is u -> v, with p, q on its left and r, s on its right. The split parts v along p - v - s, and the new
// vertex gets the edge. The collapse merges the new vertex with r across the face on the right.
void add_flip_of_two(OperationSheet& sheet, const Region& patch, HalfEdgeId edge) {
  const HalfEdgeId back = patch.mesh.twin(edge);
  const BasicOperation split{BasicOperation::Kind::split, QuadMesh::next(edge), QuadMesh::previous(back), 0};
  const BasicOperation collapse{BasicOperation::Kind::collapse, QuadMesh::opposite(back), {}, 0};
  const BasicOperation flip{BasicOperation::Kind::flip_ccw, edge, {}, 0};
  const RegionChange first = perform_all(patch, {split});
  const RegionChange both = perform_all(patch, {split, collapse});
  if (mesh::signature(both.after) != mesh::signature(perform_all(patch, {flip}).after)) {
    throw std::logic_error("a split and a collapse do not make a flip");
  }
  Panel panel{patch, {"split along these two edges"}};
  panel.lines = {{{QuadMesh::previous(back), QuadMesh::next(edge)}, kGreenLine}};
  sheet.add(panel, 0.6, 2);
  panel = {first.after, {"then collapse the crossed quad"}};
  panel.made = first.made;
  panel.deleted = {QuadMesh::face(back)};
  sheet.add(panel, 1.6, 2);
  sheet.add({both.after, {"the flip, counter-clockwise"}}, 2.6, 2);
  sheet.arrow(0.6, 2, 1);
  sheet.arrow(1.6, 2, 1);
}

}  // namespace

Paint paint_basic_operations() {
  OperationSheet sheet;
  add_collapse(sheet);
  add_split(sheet);
  const Region patch = grid(4, 5);
  const HalfEdgeId edge = grid_edge(patch, 5, 2, 2, 0, 1);
  add_flips(sheet, patch, edge);
  add_flip_of_two(sheet, patch, edge);
  return paint(sheet.sheet());
}

}  // namespace requad::figures
