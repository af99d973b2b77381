#include <stdexcept>

#include "figures/panels/sheet.hpp"
#include "figures/pictures/paper_pictures.hpp"
#include "mesh/topology/separatrix.hpp"
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

std::vector<Panel::Line> path(std::vector<HalfEdgeId> edges) { return {{std::move(edges)}}; }

constexpr int kSide = 5;  // of all grids of the figure

void add_collapse(Sheet& sheet, const Region& patch) {
  const HalfEdgeId middle = grid_edge(patch, kSide, 2, 2, 1, 0);
  const RegionChange collapse = perform_all(patch, {{BasicOperation::Kind::collapse, middle, {}, 0}});
  Panel panel{patch, {"a quad between two regular vertices"}};
  panel.deleted = collapse.deleted;
  panel.dots = {patch.mesh.origin(middle), patch.mesh.target(QuadMesh::next(middle))};
  const auto before = sheet.add(panel, 0, 0);
  sheet.arrow(before, sheet.add({collapse.after, {"quad collapse"}}, 0, 1));
}

void add_split(Sheet& sheet, const Region& patch) {
  const HalfEdgeId right = grid_edge(patch, kSide, 2, 2, 1, 0), from_left = grid_edge(patch, kSide, 1, 2, 1, 0);
  const RegionChange split = perform_all(patch, {{BasicOperation::Kind::split, right, from_left, 0}});
  Panel panel{patch, {"two edges of a path"}};
  panel.lines = path({from_left, right});
  const auto before = sheet.add(panel, 0, 2);
  panel = {split.after, {"edge split"}};
  panel.made = split.made;
  sheet.arrow(before, sheet.add(panel, 0, 3));
}

void add_flips(Sheet& sheet, const Region& patch, HalfEdgeId edge) {
  Panel panel{patch, {"an edge"}};
  panel.lines = path({edge});
  const auto before = sheet.add(panel, 1, 1.5);
  for (const auto kind : {BasicOperation::Kind::flip_ccw, BasicOperation::Kind::flip_cw}) {
    const bool left = kind == BasicOperation::Kind::flip_ccw;
    const BasicOperation operation{kind, edge, {}, 0};
    const RegionChange flip = perform_all(patch, {operation});
    Panel result{flip.after, {left ? "edge flip, counter-clockwise" : "edge flip, clockwise"}};
    result.lines = path({turned_edge(operation)});
    sheet.arrow(before, sheet.add(result, 1, left ? 0.5 : 2.5));
  }
}

// The edge is u -> v, with p, q on its left and r, s on its right. The split parts v along p - v - s, and the new
// vertex gets the edge. The collapse merges the new vertex with r across the face on the right.
void add_flip_of_two(Sheet& sheet, const Region& patch, HalfEdgeId edge) {
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
  panel.lines = path({QuadMesh::previous(back), QuadMesh::next(edge)});
  const auto before = sheet.add(panel, 2, 0.5);
  panel = {first.after, {"then collapse the crossed quad"}};
  panel.made = first.made;
  panel.deleted = {QuadMesh::face(back)};
  const auto between = sheet.add(panel, 2, 1.5);
  panel = {both.after, {"the edge is flipped, counter-clockwise"}};
  // The flipped edge joins the two v5s.
  const QuadMesh& m = both.after.mesh;
  std::vector<VertexId> fives;
  for (const VertexId v : mesh::irregular_vertices(m)) {
    if (m.valence(v) == 5) fives.push_back(v);
  }
  panel.lines = path({m.find_half_edge(fives.at(0), fives.at(1))});
  const auto after = sheet.add(panel, 2, 2.5);
  sheet.arrow(before, between);
  sheet.arrow(between, after);
}

}  // namespace

Paint paint_basic_operations() {
  Sheet sheet;
  const Region patch = grid(kSide, kSide);
  const HalfEdgeId edge = grid_edge(patch, kSide, 2, 2, 0, 1);
  add_collapse(sheet, patch);
  add_split(sheet, patch);
  add_flips(sheet, patch, edge);
  add_flip_of_two(sheet, patch, edge);
  return sheet.paint();
}

}  // namespace requad::figures
