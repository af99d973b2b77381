#include "figures/pictures/vertex_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "figures/pictures/sheet.hpp"
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

// "flip, left hand".
std::string step_text(const mesh::TransportStep& step) {
  return std::string(mesh::name(step.kind)) + (step.hand == mesh::Hand::left ? ", left hand" : ", right hand");
}

// The result of an atomic operation on a region: the panel after it, and the face that it removes, if any.
struct AtomicResult {
  Panel after;
  FaceId removed;
};
AtomicResult perform_atomic(const Region& start, const mesh::AtomicOperation& operation) {
  QuadMesh m = start.mesh;
  Editor editor(m);
  require_performed(mesh::perform(editor, operation).refusal);
  AtomicResult result{{with_mesh(start, m), {step_text(operation.name.step)}}, editor.edits().back().removed_face()};
  const FaceId made = editor.edits().back().made_face();
  if (made.valid()) result.after.made = {made};
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

// A row of Figure 4: the vertex of this valence before its moves upwards, and after each of them.
void add_vertex_moves(Sheet& sheet, const Region& start, int valence, AtomicKind kind, double y, double unit,
                      const char* words) {
  constexpr double kX = 168;
  constexpr double kHalfTurn = std::numbers::pi;  // the flat side is above, so a separatrix runs straight up
  const VertexId v = irregular_vertex(start.mesh, valence);
  const HalfEdgeId up = upwards(start, v, kHalfTurn);
  Panel before{start, {words}};
  before.lines = {{{up}, {ink::kRed, 1.8}, true}};
  std::vector<Panel> after;
  for (const mesh::AtomicOperation& operation : operations_at(start, v)) {
    if (operation.name.kind != kind || operation.along != up) continue;
    AtomicResult result = perform_atomic(start, operation);
    if (result.removed.valid() && operation.name.step.hand == mesh::Hand::left) before.deleted = {result.removed};
    after.push_back(std::move(result.after));
  }
  sheet.panels.push_back({before, {0, y}, unit, kHalfTurn});
  for (std::size_t i = 0; i < after.size(); ++i) {
    sheet.panels.push_back({after[i], {(static_cast<double>(i) + 1.25) * kX, y}, unit, kHalfTurn});
  }
  sheet.arrow({0.54 * kX, y}, {0.7 * kX, y});
}

// True for the operation that parts a v2 into two v3s, or a v6 into two v5s.
bool parts_evenly(const AtomicName& name, int valence) {
  return valence == 2 ? name.kind == AtomicKind::raise : name.kind == AtomicKind::lower && 2 * name.turn == valence;
}

// A half of Figure 5: a vertex before and after it parts.
void add_parting(Sheet& sheet, const Region& start, int valence, double x, double unit, const char* before_words,
                 const char* after_words) {
  const auto operations = operations_at(start, irregular_vertex(start.mesh, valence));
  const auto operation = std::find_if(operations.begin(), operations.end(), [valence](const auto& candidate) {
    return parts_evenly(candidate.name, valence);
  });
  if (operation == operations.end()) throw std::logic_error("no such change of type");
  AtomicResult result = perform_atomic(start, *operation);
  Panel before{start, {before_words}};
  result.after.words = {after_words};
  if (result.removed.valid()) before.deleted = {result.removed};
  if (!result.after.made.empty()) {
    HalfEdgeId far = operation->along;
    for (int i = 0; i < operation->name.turn; ++i) far = start.mesh.ccw(far);
    before.lines = {{{start.mesh.twin(operation->along), far}, kGreenLine}};
  }
  sheet.panels.push_back({before, {x, 0}, unit});
  sheet.panels.push_back({result.after, {x + 200, 0}, unit});
  sheet.arrow({x + 86, 0}, {x + 114, 0});
}

}  // namespace

Paint paint_adjacent_pair_moves() {
  const Region start = region_with(theory::kQuad, 1, 0, {2, 2, 2, 3});
  const VertexId three = irregular_vertex(start.mesh, 3), five = irregular_vertex(start.mesh, 5);
  // Turned so that the v3 is above the v5.
  const MeshPicture probe(start, Point::Zero(), 1);
  const Point down = probe.at(five) - probe.at(three);
  const double angle = -std::numbers::pi / 2 - std::atan2(down.y(), down.x());
  Sheet sheet;
  constexpr double kUnit = 20, kX = 190, kY = 188;
  Panel panel{start, {"an adjacent 3-5 pair"}};
  panel.grey = faces_at(start.mesh, {three, five});
  sheet.panels.push_back({panel, {0, 0}, kUnit, angle});
  for (const mesh::AtomicOperation& operation : operations_at(start, three)) {
    const mesh::TransportStep& step = operation.name.step;
    if (operation.name.kind != AtomicKind::move_35) continue;
    Panel after = perform_atomic(start, operation).after;
    const QuadMesh& m = after.region.mesh;
    after.grey = faces_at(m, {irregular_vertex(m, 3), irregular_vertex(m, 5)});
    const double column = step.hand == mesh::Hand::left ? 1 : -1;  // seen from the v3 down to the v5
    const double row = step.kind == mesh::TransportStep::Kind::collapse ? 1
                       : step.kind == mesh::TransportStep::Kind::flip   ? 0
                                                                        : -1;
    const Point centre(column * kX, row * kY);
    sheet.panels.push_back({after, centre, kUnit, angle});
    const Point halfway(0.5 * centre.x(), 0.5 * centre.y());
    const Point unit = halfway.normalized() * 12;
    sheet.arrow(halfway - unit, halfway + unit);
  }
  return paint(sheet);
}

Paint paint_vertex_moves() {
  Sheet sheet;
  add_vertex_moves(sheet, region_with({4, 3}, 0, 0, {3, 3, 3}), 3, AtomicKind::move_v3, 0, 23, "a v3, to be moved up");
  add_vertex_moves(sheet, region_with({5, 4}, 0, 0, {3, 3, 3, 3, 3}), 5, AtomicKind::move_v5, -175, 15.5,
                   "a v5, to be moved up");
  return paint(sheet);
}

Paint paint_type_changes() {
  Sheet sheet;
  add_parting(sheet, region_with(theory::kDigon, 0, 0, {2, 2}), 2, 0, 40, "a v2", "two v3s, by one collapse");
  add_parting(sheet, region_with(theory::kHexagon, 0, 0, {2, 2, 2, 2, 2, 2}), 6, 420, 19, "a v6",
              "two v5s, by one split");
  return paint(sheet);
}

}  // namespace requad::figures
