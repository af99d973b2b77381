#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "figures/panels/sheet.hpp"
#include "figures/pictures/paper_pictures.hpp"
#include "mesh/irregular/atomic_operations.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::figures {

namespace {

using mesh::AtomicKind;
using mesh::AtomicName;
using mesh::Editor;
using mesh::FaceId;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;

std::vector<FaceId> faces_at(const QuadMesh& m, std::initializer_list<VertexId> vertices) {
  std::vector<FaceId> result;
  for (const FaceId f : m.faces()) {
    const auto c = m.corners(f);
    if (std::any_of(vertices.begin(), vertices.end(),
                    [&c](VertexId v) { return std::find(c.begin(), c.end(), v) != c.end(); })) {
      result.push_back(f);
    }
  }
  return result;
}

// "collapse on the left", as seen along the operation or, where it lies downwards on the page, from below.
std::string step_text(const mesh::TransportStep& step, bool upwards) {
  return std::string(mesh::name(step.kind)) + " on the " +
         ((step.hand == mesh::Hand::left) == upwards ? "left" : "right");
}

// An atomic operation on a region: the panels before and after it. The quad, edge or edges that it takes are marked
// before, what becomes of them after.
struct AtomicResult {
  Panel before, after;
};
AtomicResult perform_atomic(const Region& start, const mesh::AtomicOperation& atomic) {
  QuadMesh m = start.mesh;
  Editor editor(m);
  require_performed(mesh::perform(editor, atomic).refusal);
  AtomicResult result{{start}, {with_mesh(start, m)}};
  const mesh::Edit& edit = editor.edits().back();
  const mesh::BasicOperation& operation = edit.operation;
  switch (operation.kind) {
    case mesh::BasicOperation::Kind::collapse: result.before.deleted = {edit.removed_face()}; break;
    case mesh::BasicOperation::Kind::split:
      result.before.lines = {{{operation.last, operation.h}}};
      result.after.made = {edit.made_face()};
      break;
    default: result.before.lines = {{{operation.h}}}; result.after.lines = {{{turned_edge(operation)}}};
  }
  return result;
}

// The atomic operations that a vertex of a region has according to the valences, refused ones included.
std::vector<mesh::AtomicOperation> operations_at(const Region& start, VertexId v) {
  QuadMesh m = start.mesh;
  const Editor editor(m);
  std::vector<mesh::AtomicOperation> result;
  for (const mesh::AtomicChoice& choice : mesh::atomic_operations(editor, v)) result.push_back(choice.operation);
  return result;
}

// The half-edge to the neighbour that is drawn highest if the region is turned by this angle.
HalfEdgeId upwards(const Region& region, VertexId v, double angle) {
  const MeshPicture probe(region, Point::Zero(), 1, angle);
  const auto height = [&](HalfEdgeId h) { return probe.at(region.mesh.target(h)).y(); };
  HalfEdgeId up;
  region.mesh.for_each_out(v, [&](HalfEdgeId h) {
    if (!up.valid() || height(h) > height(up) + 1e-6) up = h;
  });
  return up;
}

// Two rows of Figure 4: each move upwards of the vertex of this valence, before and after.
void add_vertex_moves(Sheet& sheet, const Region& start, int valence, AtomicKind kind, int row, double unit) {
  constexpr double kHalfTurn = std::numbers::pi;  // the flat side is above, so a separatrix runs straight up
  const VertexId v = irregular_vertex(start.mesh, valence);
  const HalfEdgeId up = upwards(start, v, kHalfTurn);
  int column = 0;
  for (const mesh::AtomicOperation& operation : operations_at(start, v)) {
    if (operation.name.kind != kind || operation.along != up) continue;
    AtomicResult result = perform_atomic(start, operation);
    result.before.direction = up;
    result.before.aside = operation.name.step.hand == mesh::Hand::left ? -7 : 7;  // clear of what is marked
    result.after.words = {step_text(operation.name.step, true)};
    for (Panel* panel : {&result.before, &result.after}) {
      panel->unit = unit;
      panel->angle = kHalfTurn;
    }
    const auto before = sheet.add(result.before, row, column);
    sheet.arrow(before, sheet.add(result.after, row + 1, column));
    ++column;
  }
}

// True for the operation that parts a v2 into two v3s, or a v6 into two v5s.
bool parts_evenly(const AtomicName& name, int valence) {
  return valence == 2 ? name.kind == AtomicKind::raise : name.kind == AtomicKind::lower && 2 * name.turn == valence;
}

// A half of Figure 5: a vertex before and after it parts.
void add_parting(Sheet& sheet, const Region& start, int valence, int column, double unit, const char* before_words,
                 const char* after_words) {
  const auto operations = operations_at(start, irregular_vertex(start.mesh, valence));
  const auto operation = std::find_if(operations.begin(), operations.end(), [valence](const auto& candidate) {
    return parts_evenly(candidate.name, valence);
  });
  if (operation == operations.end()) throw std::logic_error("no such change of type");
  AtomicResult result = perform_atomic(start, *operation);
  result.before.words = {before_words};
  result.after.words = {after_words};
  result.before.unit = result.after.unit = unit;
  const auto before = sheet.add(result.before, 0, column);
  sheet.arrow(before, sheet.add(result.after, 0, column + 1));
}

}  // namespace

Paint paint_adjacent_pair_moves() {
  const Region start = region_with(theory::kQuad, 1, 0, {2, 2, 2, 3});
  const VertexId three = irregular_vertex(start.mesh, 3), five = irregular_vertex(start.mesh, 5);
  // Turned so that the v3 is above the v5.
  const MeshPicture probe(start, Point::Zero(), 1);
  const Point down = probe.at(five) - probe.at(three);
  const double angle = -std::numbers::pi / 2 - std::atan2(down.y(), down.x());
  Sheet sheet(60, 36);
  Panel panel{start, {"an adjacent 3-5 pair"}};
  panel.angle = angle;
  panel.grey = faces_at(start.mesh, {three, five});
  std::vector<std::size_t> results;
  for (const mesh::AtomicOperation& operation : operations_at(start, three)) {
    const mesh::TransportStep& step = operation.name.step;
    if (operation.name.kind != AtomicKind::move_35) continue;
    const AtomicResult result = perform_atomic(start, operation);
    panel.deleted.insert(panel.deleted.end(), result.before.deleted.begin(), result.before.deleted.end());
    Panel after = result.after;
    const QuadMesh& m = after.region.mesh;
    after.words = {step_text(step, false)};
    after.angle = angle;
    after.grey = faces_at(m, {irregular_vertex(m, 3), irregular_vertex(m, 5)});
    const int column = step.hand == mesh::Hand::left ? 2 : 0;  // the left of one who looks down is on the right
    const int row = step.kind == mesh::TransportStep::Kind::collapse ? 0
                    : step.kind == mesh::TransportStep::Kind::flip   ? 1
                                                                     : 2;
    results.push_back(sheet.add(after, row, column));
  }
  const auto middle = sheet.add(panel, 1, 1);
  for (const std::size_t result : results) sheet.arrow(middle, result);
  return sheet.paint();
}

Paint paint_vertex_moves() {
  Sheet sheet(26, 38);
  add_vertex_moves(sheet, region_with({4, 3}, 0, 0, {3, 3, 3}), 3, AtomicKind::move_v3, 0, 27);
  add_vertex_moves(sheet, region_with({5, 4}, 0, 0, {3, 3, 3, 3, 3}), 5, AtomicKind::move_v5, 2, 18);
  return sheet.paint();
}

Paint paint_type_changes() {
  Sheet sheet;
  add_parting(sheet, region_with(theory::kDigon, 0, 0, {2, 2}), 2, 0, 36, "a v2", "two v3s, by one collapse");
  add_parting(sheet, region_with(theory::kHexagon, 0, 0, {2, 2, 2, 2, 2, 2}), 6, 2, 17, "a v6",
              "two v5s, by one split");
  return sheet.paint();
}

}  // namespace requad::figures
