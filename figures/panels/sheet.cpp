#include "figures/panels/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include "mesh/editing/editor.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::figures {

using mesh::FaceId;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;

// Where everything lies on a canvas.
struct Sheet::Layout {
  struct Box {
    Point low, high;
  };
  std::vector<Point> centres;                   // of the meshes
  std::vector<std::vector<std::string>> words;  // in lines
  std::vector<double> baselines;                // of the first lines
  std::vector<Box> boxes;                       // of the meshes with their words
};

Cell cell(Panel panel) {
  const MeshPicture picture = MeshPicture(panel.region, Point::Zero(), panel.unit, panel.angle).centred();
  Cell cell{picture.high() - picture.low(), {}, panel.words, panel.margin};
  cell.paint = [picture, panel = std::move(panel)](Canvas& canvas, const Point& centre) {
    paint_panel(canvas, panel, picture.moved(centre));
  };
  return cell;
}

std::size_t Sheet::add(Cell cell, int row, double column) {
  cells_.push_back({std::move(cell), row, column});
  return cells_.size() - 1;
}

Sheet::Layout Sheet::layout(const Canvas& canvas) const {
  const double em = canvas.em();
  const auto margin = [&](const Cell& cell) { return cell.margin ? cell.margin(canvas) : Point(0, 0); };
  double pitch = 0;
  for (const auto& [cell, row, column] : cells_) {
    pitch = std::max(pitch, cell.size.x() + 2 * margin(cell).x() + column_gap_);
    // No word may be wider than a column.
    for (const std::string& word : canvas.caption_lines(cell.words, 0))
      pitch = std::max(pitch, canvas.width_of(word) + em);
  }
  struct Row {
    double height = 0, middle = 0, bottom = 0;
    std::size_t lines = 0;
  };
  std::map<int, Row> rows;
  Layout result;
  for (const Placed& placed : cells_) {
    result.words.push_back(canvas.caption_lines(placed.cell.words, pitch - 1.5 * em));
    Row& row = rows[placed.row];
    row.height = std::max(row.height, placed.cell.size.y() + 2 * margin(placed.cell).y());
    row.lines = std::max(row.lines, result.words.back().size());
  }
  double top = 0;
  for (auto& [number, row] : rows) {
    row.middle = top - row.height / 2;
    row.bottom = top - row.height;
    const double words = row.lines > 0 ? 0.6 * em + canvas.line_height() * static_cast<double>(row.lines) : 0;
    top = row.bottom - words - row_gap_;
  }
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Placed& placed = cells_[i];
    const Row& row = rows.at(placed.row);
    const Point centre(placed.column * pitch, row.middle);
    result.centres.push_back(centre);
    result.baselines.push_back(row.bottom - 1.5 * em);
    Layout::Box box{centre - placed.cell.size / 2, centre + placed.cell.size / 2};
    if (!result.words[i].empty())
      box.low.y() = result.baselines[i] - canvas.line_height() * static_cast<double>(result.words[i].size() - 1);
    result.boxes.push_back(box);
  }
  return result;
}

// The arrow lies in the middle of what the boxes of the panels leave free between their centres.
void Sheet::paint_arrow(Canvas& canvas, const Layout& layout, std::size_t from, std::size_t to) const {
  constexpr double kLongest = 28, kGap = 4;
  const Point along = (layout.centres[to] - layout.centres[from]).normalized();
  const auto reach = [&](std::size_t cell, const Point& direction) {  // from the centre to the rim of the box
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 2; ++k) {
      if (std::abs(direction[k]) < 1e-9) continue;
      const double side = direction[k] > 0 ? layout.boxes[cell].high[k] : layout.boxes[cell].low[k];
      least = std::min(least, (side - layout.centres[cell][k]) / direction[k]);
    }
    return least;
  };
  const Point start = layout.centres[from] + along * reach(from, along);
  const Point end = layout.centres[to] - along * reach(to, -along);
  const double length = std::clamp((end - start).dot(along) - 2 * kGap, 10.0, kLongest);
  const Point middle = (start + end) / 2;
  canvas.arrow(middle - length / 2 * along, middle + length / 2 * along, {canvas.palette().ink, 1.2}, 7);
}

Paint Sheet::paint() const {
  return [sheet = *this](Canvas& canvas) {
    const Layout layout = sheet.layout(canvas);
    for (std::size_t i = 0; i < sheet.cells_.size(); ++i) {
      sheet.cells_[i].cell.paint(canvas, layout.centres[i]);
      canvas.caption({layout.centres[i].x(), layout.baselines[i]}, layout.words[i]);
    }
    for (const auto& [from, to] : sheet.arrows_) sheet.paint_arrow(canvas, layout, from, to);
  };
}

void require_performed(mesh::Refusal refusal) {
  if (refusal != mesh::Refusal::none) {
    throw std::logic_error("a figure's operation was refused: " + std::string(refusal.clause()));
  }
}

VertexId irregular_vertex(const QuadMesh& m, int valence) {
  for (const VertexId v : mesh::irregular_vertices(m)) {
    if (m.valence(v) == valence) return v;
  }
  throw std::logic_error("a figure lacks its irregular vertex");
}

Region with_mesh(const Region& before, const QuadMesh& after) {
  return {after, after.out(before.mesh.origin(before.root))};
}

HalfEdgeId turned_edge(const mesh::BasicOperation& flip) {
  return flip.kind == mesh::BasicOperation::Kind::flip_ccw ? QuadMesh::next(flip.h) : QuadMesh::previous(flip.h);
}

RegionChange perform_all(const Region& region, const std::vector<mesh::BasicOperation>& operations) {
  QuadMesh m = region.mesh;
  mesh::Editor editor(m);
  RegionChange change;
  std::vector<bool> is_new(static_cast<std::size_t>(m.face_capacity()) + operations.size(), false);
  for (const mesh::BasicOperation& operation : operations) {
    require_performed(editor.run(operation).refusal);
    const mesh::Edit& edit = editor.edits().back();
    if (edit.made_face().valid()) is_new[edit.made_face().slot()] = true;
    if (edit.removed_face().valid()) {
      if (!is_new[edit.removed_face().slot()]) change.deleted.push_back(edit.removed_face());
      is_new[edit.removed_face().slot()] = false;
    }
    for (const VertexId v : edit.changed) {
      if (v.valid()) change.reshaped.push_back(v);
    }
    if (edit.removed_vertex().valid()) change.reshaped.push_back(edit.removed_vertex());
  }
  for (const FaceId f : m.faces()) {
    if (is_new[f.slot()]) change.made.push_back(f);
  }
  change.after = with_mesh(region, m);
  return change;
}

}  // namespace requad::figures
