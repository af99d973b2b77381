#include "figures/pictures/sheet.hpp"

#include <stdexcept>
#include <string>

#include "mesh/editing/editor.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::figures {

using mesh::FaceId;
using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;

Paint paint(const Sheet& sheet) {
  return [sheet](Canvas& canvas) {
    for (const PlacedPanel& p : sheet.panels) paint_panel(canvas, p.panel, p.centre, p.unit, p.angle);
    for (const auto& [from, to] : sheet.arrows) canvas.arrow(from, to, {ink::kBlack, 1.2}, 7);
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
