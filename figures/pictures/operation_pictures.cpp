#include "figures/pictures/operation_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "enumerate/exploration.hpp"
#include "figures/pictures/panel.hpp"
#include "mesh/irregular/atomic_operations.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::figures {

namespace {

using mesh::AtomicKind;
using mesh::BasicOperation;
using mesh::Editor;
using mesh::FaceId;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;

struct Placed {
  Panel panel;
  Point centre;
  double unit = 20;
  double angle = 0;
};

// A picture of panels with arrows between them.
struct Sheet {
  std::vector<Placed> panels;
  std::vector<std::array<Point, 2>> arrows;

  void arrow(Point from, Point to) { arrows.push_back({from, to}); }
};
Paint paint(const Sheet& sheet) {
  return [sheet](Canvas& canvas) {
    for (const Placed& p : sheet.panels) paint_panel(canvas, p.panel, p.centre, p.unit, p.angle);
    for (const auto& a : sheet.arrows) canvas.arrow(a[0], a[1], {ink::kBlack, 1.2}, 7);
  };
}

// A grid of regular vertices, rooted at its lower left.
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
HalfEdgeId grid_edge(const Region& g, int rows, int i, int j, int di, int dj) {
  return g.mesh.find_half_edge(VertexId(i * (rows + 1) + j), VertexId((i + di) * (rows + 1) + j + dj));
}

// The region of a configuration, with the operations made so far: the root may have been renumbered.
Region with_mesh(const Region& before, const QuadMesh& after) {
  return {after, after.out(before.mesh.origin(before.root))};
}

void require(mesh::Refusal refusal) {
  if (refusal != mesh::Refusal::none)
    throw std::logic_error("a figure's operation was refused: " + std::string(explain(refusal)));
}

// What operations do to a region.
struct Change {
  Region before;
  Region after;
  std::vector<FaceId> made;     // on `after`
  std::vector<FaceId> deleted;  // on `before`
  std::vector<VertexId> changed;
};
Change perform_all(const Region& before, const std::vector<BasicOperation>& operations) {
  QuadMesh m = before.mesh;
  Editor editor(m);
  Change change{before, {}, {}, {}, {}};
  std::vector<bool> is_new(static_cast<std::size_t>(m.face_capacity()) + operations.size(), false);
  for (const BasicOperation& operation : operations) {
    require(editor.run(operation).refusal);
    const mesh::Edit& edit = editor.edits().back();
    if (edit.made_face().valid()) is_new[edit.made_face().slot()] = true;
    if (edit.removed_face().valid()) {
      if (!is_new[edit.removed_face().slot()]) change.deleted.push_back(edit.removed_face());
      is_new[edit.removed_face().slot()] = false;
    }
    for (const VertexId v : edit.changed) {
      if (v.valid()) change.changed.push_back(v);
    }
    if (edit.removed_vertex().valid()) change.changed.push_back(edit.removed_vertex());
  }
  for (const FaceId f : m.faces()) {
    if (is_new[f.slot()]) change.made.push_back(f);
  }
  change.after = with_mesh(before, m);
  return change;
}

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

VertexId irregular_of(const QuadMesh& m, int valence) {
  for (const VertexId v : mesh::irregular_vertices(m)) {
    if (m.valence(v) == valence) return v;
  }
  throw std::logic_error("a figure lacks its irregular vertex");
}

// The ring of quads round those that have a changed vertex.
std::vector<FaceId> ring_round(const QuadMesh& m, const std::vector<VertexId>& changed) {
  std::vector<bool> inner(static_cast<std::size_t>(m.vertex_capacity()), false);
  for (const VertexId v : changed) {
    if (m.is_live(v)) inner[v.slot()] = true;
  }
  std::vector<bool> touched(static_cast<std::size_t>(m.face_capacity()), false), near(inner.size(), false);
  for (const FaceId f : m.faces()) {
    for (const VertexId v : m.corners(f)) touched[f.slot()] = touched[f.slot()] || inner[v.slot()];
    for (const VertexId v : m.corners(f)) near[v.slot()] = near[v.slot()] || touched[f.slot()];
  }
  std::vector<FaceId> ring;
  for (const FaceId f : m.faces()) {
    const auto c = m.corners(f);
    if (!touched[f.slot()] && std::any_of(c.begin(), c.end(), [&](VertexId v) { return near[v.slot()]; }))
      ring.push_back(f);
  }
  return ring;
}

std::string signed_sum(int made, int deleted) {
  const auto faces = [](int n) { return std::to_string(n) + (n == 1 ? " face" : " faces"); };
  if (made > 0 && deleted > 0) return faces(made) + " made, " + std::to_string(deleted) + " deleted";
  if (deleted > 0) return faces(deleted) + " deleted";
  return faces(made) + " made";
}

}  // namespace

Paint paint_basic_operations() {
  Sheet sheet;
  constexpr double kUnit = 20, kX = 165, kY = -150;
  const auto add = [&](Panel panel, double column, double row) {
    sheet.panels.push_back({std::move(panel), {column * kX, row * kY}, kUnit});
  };
  const auto arrow = [&](double column, double row, double direction) {
    const double x = (column + 0.5) * kX;
    sheet.arrow({x - direction * 14, row * kY}, {x + direction * 14, row * kY});
  };

  const Region five = grid(5, 5);
  const HalfEdgeId middle = grid_edge(five, 5, 2, 2, 1, 0);
  const Change collapse = perform_all(five, {{BasicOperation::Kind::collapse, middle, {}, 0}});
  Panel panel{five, {"a quad between two regular vertices"}};
  panel.deleted = collapse.deleted;
  panel.dots = {five.mesh.origin(middle), five.mesh.target(QuadMesh::next(middle))};
  add(panel, 0, 0);
  add({collapse.after, {"quad collapse"}}, 1, 0);
  arrow(0, 0, 1);

  const Region four = grid(4, 4);
  const HalfEdgeId right = grid_edge(four, 4, 2, 2, 1, 0), from_left = grid_edge(four, 4, 1, 2, 1, 0);
  const Change split = perform_all(four, {{BasicOperation::Kind::split, right, from_left, 0}});
  panel = {four, {"two edges of a path"}};
  panel.lines = {{{from_left, right}, kGreenLine}};
  add(panel, 2.2, 0);
  panel = {split.after, {"edge split"}};
  panel.made = split.made;
  add(panel, 3.2, 0);
  arrow(2.2, 0, 1);

  const Region patch = grid(4, 5);
  const HalfEdgeId edge = grid_edge(patch, 5, 2, 2, 0, 1);
  panel = {patch, {"an edge"}};
  panel.lines = {{{edge}, kGreenLine}};
  add(panel, 1.6, 1);
  for (const auto turn : {BasicOperation::Kind::flip_cw, BasicOperation::Kind::flip_ccw}) {
    const bool left = turn == BasicOperation::Kind::flip_ccw;
    const Change flip = perform_all(patch, {{turn, edge, {}, 0}});
    Panel result{flip.after, {left ? "edge flip, counter-clockwise" : "edge flip, clockwise"}};
    result.lines = {{{left ? QuadMesh::next(edge) : QuadMesh::previous(edge)}, kGreenLine}};
    add(result, left ? 0.6 : 2.6, 1);
    arrow(left ? 0.6 : 1.6, 1, left ? -1 : 1);
  }

  // The edge u -> v with p, q on its left and r, s on its right: v is split along p - v - s, then the new vertex, which
  // took the edge, and r are merged across the face on the right.
  const HalfEdgeId back = patch.mesh.twin(edge);
  const BasicOperation parting{BasicOperation::Kind::split, QuadMesh::next(edge), QuadMesh::previous(back), 0};
  const BasicOperation merging{BasicOperation::Kind::collapse, QuadMesh::opposite(back), {}, 0};
  const Change first = perform_all(patch, {parting});
  const Change both = perform_all(patch, {parting, merging});
  if (mesh::signature(both.after) !=
      mesh::signature(perform_all(patch, {{BasicOperation::Kind::flip_ccw, edge, {}, 0}}).after)) {
    throw std::logic_error("a split and a collapse do not make a flip");
  }
  panel = {patch, {"split along these two edges"}};
  panel.lines = {{{QuadMesh::previous(back), QuadMesh::next(edge)}, kGreenLine}};
  add(panel, 0.6, 2);
  panel = {first.after, {"then collapse the crossed quad"}};
  panel.made = first.made;
  panel.deleted = {QuadMesh::face(back)};
  add(panel, 1.6, 2);
  add({both.after, {"the flip, counter-clockwise"}}, 2.6, 2);
  arrow(0.6, 2, 1);
  arrow(1.6, 2, 1);
  return paint(sheet);
}

Paint paint_adjacent_pair_moves() {
  const Region start = region_with(theory::kQuad, 1, 0, {2, 2, 2, 3});
  const VertexId three = irregular_of(start.mesh, 3), five = irregular_of(start.mesh, 5);
  // Turned so that the v3 is above the v5.
  const MeshPicture probe(start, Point::Zero(), 1);
  const Point down = probe.at(five) - probe.at(three);
  const double angle = -std::numbers::pi / 2 - std::atan2(down.y(), down.x());
  Sheet sheet;
  constexpr double kUnit = 20, kX = 190, kY = 188;
  Panel panel{start, {"an adjacent 3-5 pair"}};
  panel.grey = faces_at(start.mesh, {three, five});
  sheet.panels.push_back({panel, {0, 0}, kUnit, angle});
  QuadMesh m = start.mesh;
  Editor editor(m);
  for (const mesh::AtomicChoice& choice : mesh::atomic_operations(editor, three)) {
    const mesh::AtomicName& name = choice.operation.name;
    if (name.kind != AtomicKind::move_35) continue;
    const mesh::AtomicReport report = mesh::perform(editor, choice.operation);
    require(report.refusal);
    Panel result{with_mesh(start, m),
                 {std::string(mesh::name(name.step.kind)) +
                  (name.step.hand == mesh::Hand::left ? ", left hand" : ", right hand")}};
    result.grey = faces_at(m, {irregular_of(m, 3), irregular_of(m, 5)});
    if (editor.edits().back().made_face().valid()) result.made = {editor.edits().back().made_face()};
    editor.roll_back();
    const double column = name.step.hand == mesh::Hand::left ? 1 : -1;  // seen from the v3 down to the v5
    const double row = name.step.kind == mesh::TransportStep::Kind::collapse ? 1
                       : name.step.kind == mesh::TransportStep::Kind::flip   ? 0
                                                                             : -1;
    const Point centre(column * kX, row * kY);
    sheet.panels.push_back({result, centre, kUnit, angle});
    const Point step(0.5 * centre.x(), 0.5 * centre.y());
    const Point unit = step.normalized() * 12;
    sheet.arrow(step - unit, step + unit);
  }
  return paint(sheet);
}

Paint paint_vertex_moves() {
  Sheet sheet;
  constexpr double kX = 168, kY = -175, kTurned = std::numbers::pi;  // flat side up: a separatrix runs straight up
  const auto row = [&](const Region& start, int valence, AtomicKind kind, double y, double unit, const char* what) {
    const VertexId v = irregular_of(start.mesh, valence);
    // Upwards: to the neighbour that is drawn highest.
    const MeshPicture probe(start, Point::Zero(), 1, kTurned);
    HalfEdgeId up;
    start.mesh.for_each_out(v, [&](HalfEdgeId h) {
      if (!up.valid() || probe.at(start.mesh.target(h)).y() > probe.at(start.mesh.target(up)).y() + 1e-6) up = h;
    });
    QuadMesh m = start.mesh;
    Editor editor(m);
    std::vector<Panel> after;
    FaceId removed;
    for (const mesh::AtomicChoice& choice : mesh::atomic_operations(editor, v)) {
      const mesh::AtomicName& name = choice.operation.name;
      if (name.kind != kind || choice.operation.along != up) continue;
      const mesh::AtomicReport report = mesh::perform(editor, choice.operation);
      require(report.refusal);
      Panel result{with_mesh(start, m),
                   {std::string(mesh::name(name.step.kind)) +
                    (name.step.hand == mesh::Hand::left ? ", left hand" : ", right hand")}};
      const mesh::Edit& edit = editor.edits().back();
      if (edit.made_face().valid()) result.made = {edit.made_face()};
      if (edit.removed_face().valid() && name.step.hand == mesh::Hand::left) removed = edit.removed_face();
      editor.roll_back();
      after.push_back(std::move(result));
    }
    Panel before{start, {what}};
    before.lines = {{{up}, {ink::kRed, 1.8}, true}};
    if (removed.valid()) before.deleted = {removed};
    sheet.panels.push_back({before, {0, y}, unit, kTurned});
    for (std::size_t i = 0; i < after.size(); ++i) {
      sheet.panels.push_back({after[i], {(static_cast<double>(i) + 1.25) * kX, y}, unit, kTurned});
    }
    sheet.arrow({0.54 * kX, y}, {0.7 * kX, y});
  };
  row(region_with({4, 3}, 0, 0, {3, 3, 3}), 3, AtomicKind::move_v3, 0, 23, "a v3, to be moved up");
  row(region_with({5, 4}, 0, 0, {3, 3, 3, 3, 3}), 5, AtomicKind::move_v5, kY, 15.5, "a v5, to be moved up");
  return paint(sheet);
}

Paint paint_type_changes() {
  Sheet sheet;
  const auto row = [&](const Region& start, int valence, double x, double unit, const char* before_words,
                       const char* after_words) {
    const VertexId v = irregular_of(start.mesh, valence);
    QuadMesh m = start.mesh;
    Editor editor(m);
    for (const mesh::AtomicChoice& choice : mesh::atomic_operations(editor, v)) {
      const bool evenly =
          valence == 2 ? choice.operation.name.kind == AtomicKind::raise
                       : choice.operation.name.kind == AtomicKind::lower && 2 * choice.operation.name.turn == valence;
      if (!evenly) continue;
      require(mesh::perform(editor, choice.operation).refusal);
      const mesh::Edit& edit = editor.edits().back();
      Panel before{start, {before_words}}, after{with_mesh(start, m), {after_words}};
      if (edit.removed_face().valid()) before.deleted = {edit.removed_face()};
      if (edit.made_face().valid()) {
        after.made = {edit.made_face()};
        HalfEdgeId h = choice.operation.along, far = h;
        for (int i = 0; i < choice.operation.name.turn; ++i) far = start.mesh.ccw(far);
        before.lines = {{{start.mesh.twin(h), far}, kGreenLine}};
      }
      sheet.panels.push_back({before, {x, 0}, unit});
      sheet.panels.push_back({after, {x + 200, 0}, unit});
      sheet.arrow({x + 86, 0}, {x + 114, 0});
      return;
    }
    throw std::logic_error("no such change of type");
  };
  row(region_with(theory::kDigon, 0, 0, {2, 2}), 2, 0, 40, "a v2", "two v3s, by one collapse");
  row(region_with(theory::kHexagon, 0, 0, {2, 2, 2, 2, 2, 2}), 6, 420, 19, "a v6", "two v5s, by one split");
  return paint(sheet);
}

Paint paint_pair_moves() {
  Sheet sheet;
  constexpr double kUnit = 14, kX = 172, kY = -170;
  int row = 0;
  for (const Region& start :
       {region_with(theory::kQuad, 3, 0, {3, 3, 3, 3}), region_with(theory::kQuad, 2, 1, {3, 3, 3, 3})}) {
    const VertexId three = irregular_of(start.mesh, 3), five = irregular_of(start.mesh, 5);
    int column = 0;
    for (const mesh::PairMove& move : mesh::pair_moves(start.mesh, five, three)) {
      QuadMesh m = start.mesh;
      const mesh::MoveReport report = mesh::move_pair(m, move);
      require(report.refusal);
      const Change change = perform_all(start, report.operations);
      Panel before{start, {}};
      before.stay = ring_round(start.mesh, change.changed);
      before.deleted = change.deleted;
      before.lines = {{mesh::path_between(start.mesh, move.frame), kGreenLine}};
      const auto outward = mesh::outward(start.mesh, move.frame);
      HalfEdgeId way;
      switch (move.step) {
        case mesh::PairStep::slide_first: way = outward[0]; break;
        case mesh::PairStep::open: way = outward[1]; break;
        case mesh::PairStep::slide_second: way = outward[2]; break;
        case mesh::PairStep::close:
          way = mesh::outward(start.mesh, mesh::seen_from_other_end(start.mesh, move.frame))[0];
          break;
      }
      before.lines.push_back({{way}, {ink::kRed, 2}, true});
      Panel after{change.after,
                  {signed_sum(static_cast<int>(change.made.size()), static_cast<int>(change.deleted.size()))}};
      after.stay = ring_round(change.after.mesh, change.changed);
      after.made = change.made;
      after.lines = {{mesh::path_between(m, report.inverse.frame), kGreenLine}};
      const double x = column * kX;
      sheet.panels.push_back({before, {x, (2 * row) * kY}, kUnit});
      sheet.panels.push_back({after, {x, (2 * row + 1) * kY + 12}, kUnit});
      sheet.arrow({x, (2 * row + 0.5) * kY + 12}, {x, (2 * row + 0.5) * kY - 8});
      ++column;
    }
    ++row;
  }
  return paint(sheet);
}

Paint paint_detour() {
  const Region start = region_with(theory::kQuad, 4, 0, {3, 3, 3, 3});
  const VertexId three = irregular_of(start.mesh, 3), five = irregular_of(start.mesh, 5);
  const mesh::PairFrame frame = mesh::find_frames(start.mesh, five, three).at(0);
  const std::vector<HalfEdgeId> direct = mesh::path_between(start.mesh, frame);
  // The feature crosses the path in its middle, an edge long on one side and two on the other.
  const HalfEdgeId across = QuadMesh::next(direct[1]);
  std::vector<HalfEdgeId> feature{start.mesh.straight(across), across};
  feature[0] = start.mesh.twin(feature[0]);
  feature[1] = start.mesh.twin(feature[1]);
  feature.push_back(start.mesh.straight(feature[1]));
  mesh::FeatureSet features;
  for (const HalfEdgeId h : feature) features.insert(start.mesh.origin(h), start.mesh.target(h));

  // A courier is sent from the v5 in each direction; the first that goes round is drawn.
  QuadMesh m = start.mesh;
  Editor editor(m, &features);
  std::vector<BasicOperation> operations;
  bool refused = false;
  for (const mesh::PairMove& move : mesh::pair_moves(start.mesh, five, three)) {
    if (mesh::move_pair(editor, move).refusal == mesh::Refusal::none) {
      editor.roll_back();
      continue;
    }
    refused = true;
    QuadMesh straight = start.mesh;
    const mesh::MoveReport report = mesh::move_pair(straight, move);
    if (report.refusal != mesh::Refusal::none) continue;
    const std::string wanted = mesh::signature(with_mesh(start, straight));
    mesh::PairTransport transport(editor);
    for (const VertexId from : {five, three}) {
      const VertexId to = from == five ? three : five;
      std::vector<HalfEdgeId> departures;
      m.for_each_out(from, [&](HalfEdgeId h) { departures.push_back(m.valence(from) == 3 ? h : m.twin(h)); });
      for (const HalfEdgeId h : departures) {
        if (transport.carry({h}, std::array{to}).refusal != mesh::Refusal::none) continue;
        std::vector<BasicOperation> made;
        for (const mesh::Edit& edit : editor.edits()) made.push_back(edit.operation);
        if (mesh::signature(with_mesh(start, m)) == wanted && (operations.empty() || made.size() < operations.size()))
          operations = made;
        editor.roll_back();
      }
    }
    if (!operations.empty()) break;
  }
  if (!refused || operations.empty()) throw std::logic_error("no courier goes round the figure's feature");

  Sheet sheet;
  constexpr double kUnit = 17, kX = 205;
  const std::size_t total = operations.size();
  const std::array<std::size_t, 4> stops{0, (total + 2) / 3, (2 * total + 2) / 3, total};
  const std::array<const char*, 4> words{"(a) a feature crosses the path", "(b) an adjacent 3-5 pair sets out",
                                         "(c) and goes round the feature", "(d) both have moved, the feature is kept"};
  std::vector<FaceId> all_deleted = perform_all(start, operations).deleted;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const Change change =
        perform_all(start, {operations.begin(), operations.begin() + static_cast<std::ptrdiff_t>(stops[i])});
    Panel panel{change.after, {words[i]}};
    panel.made = change.made;
    for (const FaceId f : all_deleted) {
      if (std::find(change.deleted.begin(), change.deleted.end(), f) == change.deleted.end())
        panel.deleted.push_back(f);
    }
    for (const auto& e : features.edges())
      panel.lines.push_back({{change.after.mesh.find_half_edge(e[0], e[1])}, {ink::kBlack, 3.4}});
    if (i == 0) panel.lines.insert(panel.lines.begin(), {direct, kGreenLine});
    sheet.panels.push_back({panel, {static_cast<double>(i) * kX, 0}, kUnit});
  }
  return paint(sheet);
}

Paint paint_equal_pair_moves() {
  Sheet sheet;
  constexpr double kUnit = 20, kX = 250;
  Region region = region_with(theory::kDigon, 3, 1, {2, 2});
  std::vector<FaceId> made;
  // (d1, d2) = (b, a): slide_second adds (-1,+1), close (+1,+1).
  const std::array<mesh::PairStep, 2> made_steps{mesh::PairStep::slide_second, mesh::PairStep::close};
  for (std::size_t i = 0; i <= made_steps.size(); ++i) {
    const auto irregular = mesh::irregular_vertices(region.mesh);
    const auto moves = mesh::pair_moves(region.mesh, irregular.at(0), irregular.at(1));
    const mesh::PairFrame frame = moves.at(0).frame;
    Panel panel{region,
                {std::string("(") + static_cast<char>('a' + i) + ")   d_1 = " + std::to_string(frame.d1) +
                 ", d_2 = " + std::to_string(frame.d2)}};
    const MeshPicture probe(region, Point::Zero(), 1);
    panel.blue = probe.between(frame);
    panel.made = made;
    if (i < made_steps.size()) {
      const auto move =
          std::find_if(moves.begin(), moves.end(), [&](const mesh::PairMove& x) { return x.step == made_steps[i]; });
      if (move == moves.end()) throw std::logic_error("the figure's pair has no such move");
      QuadMesh m = region.mesh;
      const mesh::MoveReport report = mesh::move_pair(m, *move);
      require(report.refusal);
      const Change change = perform_all(region, report.operations);
      panel.deleted = change.deleted;
      made = change.made;
      region = change.after;
    }
    sheet.panels.push_back({panel, {static_cast<double>(i) * kX, 0}, kUnit});
    if (i > 0)
      sheet.arrow({(static_cast<double>(i) - 0.5) * kX - 14, 0}, {(static_cast<double>(i) - 0.5) * kX + 14, 0});
  }
  return paint(sheet);
}

}  // namespace requad::figures
