#include <algorithm>
#include <stdexcept>
#include <string>

#include "figures/panels/sheet.hpp"
#include "figures/pictures/paper_pictures.hpp"
#include "mesh/editing/editor.hpp"
#include "mesh/irregular/pair_moves.hpp"
#include "mesh/irregular/transport.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::figures {

namespace {

using mesh::BasicOperation;
using mesh::Editor;
using mesh::FaceId;
using mesh::HalfEdgeId;
using mesh::PairMove;
using mesh::PairStep;
using mesh::QuadMesh;
using mesh::Region;
using mesh::VertexId;

// --- Figure 6 --------------------------------------------------------------------------------------------------------

// The quads next to those that have one of these vertices.
std::vector<FaceId> ring_round(const QuadMesh& m, const std::vector<VertexId>& vertices) {
  std::vector<bool> inner(static_cast<std::size_t>(m.vertex_capacity()), false);
  for (const VertexId v : vertices) {
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
    if (!touched[f.slot()] && std::any_of(c.begin(), c.end(), [&](VertexId v) { return near[v.slot()]; })) {
      ring.push_back(f);
    }
  }
  return ring;
}

// "2 faces made, 1 deleted".
std::string faces_text(std::size_t made, std::size_t deleted) {
  const auto faces = [](std::size_t n) { return std::to_string(n) + (n == 1 ? " face" : " faces"); };
  if (made > 0 && deleted > 0) return faces(made) + " made, " + std::to_string(deleted) + " deleted";
  return deleted > 0 ? faces(deleted) + " deleted" : faces(made) + " made";
}

// The first edge of the outward separatrix towards whose side a move carries a 3-5 pair.
HalfEdgeId direction(const QuadMesh& m, const PairMove& move) {
  const std::vector<HalfEdgeId> outward = mesh::outward_of_both(m, move.frame);
  switch (move.step) {
    case PairStep::slide_first: return outward[0];
    case PairStep::open: return outward[1];
    case PairStep::slide_second: return outward[2];
    case PairStep::close: return outward[3];
  }
  return {};
}

// A column of Figure 6: the region before and after a move, in this row and the next one.
void add_pair_move(Sheet& sheet, const Region& start, const PairMove& move, int row, int column) {
  constexpr double kUnit = 17;
  QuadMesh m = start.mesh;
  const mesh::MoveReport report = mesh::move_pair(m, move);
  require_performed(report.refusal);
  const RegionChange change = perform_all(start, report.operations);
  Panel before{start};
  before.stay = ring_round(start.mesh, change.reshaped);
  before.deleted = change.deleted;
  before.lines = {{mesh::path_between(start.mesh, move.frame)}};
  before.direction = direction(start.mesh, move);
  Panel after{change.after, {faces_text(change.made.size(), change.deleted.size())}};
  after.stay = ring_round(change.after.mesh, change.reshaped);
  after.made = change.made;
  after.lines = {{mesh::path_between(m, report.inverse.frame)}};
  before.unit = after.unit = kUnit;
  const auto first = sheet.add(before, row, column);
  sheet.arrow(first, sheet.add(after, row + 1, column));
}

// --- Figure 7 --------------------------------------------------------------------------------------------------------

// Three edges across the path between the pair. Two of them lie on the left of the path and one on the right.
mesh::FeatureSet feature_across(const QuadMesh& m, const std::vector<HalfEdgeId>& path) {
  const HalfEdgeId across = QuadMesh::next(path[1]);
  const HalfEdgeId back = m.twin(across);
  mesh::FeatureSet features;
  for (const HalfEdgeId h : {m.twin(m.straight(across)), back, m.straight(back)}) {
    features.insert(m.origin(h), m.target(h));
  }
  return features;
}

// The signature of the region after a move on a mesh without features; "" if the move is refused.
std::string signature_after(const Region& start, const PairMove& move) {
  QuadMesh m = start.mesh;
  return mesh::move_pair(m, move).refusal == mesh::Refusal::none ? mesh::signature(with_mesh(start, m)) : "";
}

// The shortest transport of an adjacent 3-5 pair, from one vertex of the pair to the other, that makes the region with
// this signature. Empty if there is none. `m` is the region's mesh, which the editor edits; it is the same afterwards.
std::vector<BasicOperation> transport_to(Editor& editor, const QuadMesh& m, const Region& start,
                                         std::array<VertexId, 2> pair, const std::string& wanted) {
  std::vector<BasicOperation> best;
  mesh::PairTransport transport(editor);
  for (const auto& [from, to] : {pair, std::array{pair[1], pair[0]}}) {
    for (const HalfEdgeId h : mesh::departures(m, from)) {
      if (transport.carry({h}, std::array{to}).refusal != mesh::Refusal::none) continue;
      std::vector<BasicOperation> made;
      for (const mesh::Edit& edit : editor.edits()) made.push_back(edit.operation);
      if (mesh::signature(with_mesh(start, m)) == wanted && (best.empty() || made.size() < best.size())) best = made;
      editor.roll_back();
    }
  }
  return best;
}

// The operations of a transport round the features. Its result is that of a move which the features do not allow.
// Throws std::logic_error if there is no such transport.
std::vector<BasicOperation> detour(const Region& start, const mesh::FeatureSet& features,
                                   std::array<VertexId, 2> pair) {
  QuadMesh m = start.mesh;
  Editor editor(m, &features);
  for (const PairMove& move : mesh::pair_moves(start.mesh, pair[0], pair[1])) {
    if (mesh::move_pair(editor, move).refusal == mesh::Refusal::none) {
      editor.roll_back();
      continue;
    }
    const std::string wanted = signature_after(start, move);
    if (wanted.empty()) continue;
    std::vector<BasicOperation> operations = transport_to(editor, m, start, pair, wanted);
    if (!operations.empty()) return operations;
  }
  throw std::logic_error("no adjacent 3-5 pair goes round the figure's feature");
}

}  // namespace

Paint paint_pair_moves() {
  Sheet sheet(30, 38);
  int row = 0;
  for (const Region& start :
       {region_with(theory::kQuad, 3, 0, {3, 3, 3, 3}), region_with(theory::kQuad, 2, 1, {3, 3, 3, 3})}) {
    int column = 0;
    const VertexId five = irregular_vertex(start.mesh, 5), three = irregular_vertex(start.mesh, 3);
    for (const PairMove& move : mesh::pair_moves(start.mesh, five, three))
      add_pair_move(sheet, start, move, row, column++);
    row += 2;
  }
  return sheet.paint();
}

Paint paint_detour() {
  const Region start = region_with(theory::kQuad, 4, 0, {3, 3, 3, 3});
  const VertexId five = irregular_vertex(start.mesh, 5), three = irregular_vertex(start.mesh, 3);
  const mesh::PairFrame frame = mesh::find_frames(start.mesh, five, three).at(0);
  const std::vector<HalfEdgeId> direct = mesh::path_between(start.mesh, frame);
  const mesh::FeatureSet features = feature_across(start.mesh, direct);
  const std::vector<BasicOperation> operations = detour(start, features, {five, three});

  Sheet sheet(30);
  const std::size_t total = operations.size();
  const std::array<std::size_t, 4> stops{0, (total + 2) / 3, (2 * total + 2) / 3, total};
  const std::array<const char*, 4> words{"(a) a feature crosses the path", "(b) an adjacent 3-5 pair sets out",
                                         "(c) and goes round the feature", "(d) both moved, the feature is kept"};
  const std::vector<FaceId> all_deleted = perform_all(start, operations).deleted;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const RegionChange change =
        perform_all(start, {operations.begin(), operations.begin() + static_cast<std::ptrdiff_t>(stops[i])});
    Panel panel{change.after, {words[i]}};
    panel.made = change.made;
    std::copy_if(all_deleted.begin(), all_deleted.end(), std::back_inserter(panel.deleted), [&](FaceId f) {
      return std::find(change.deleted.begin(), change.deleted.end(), f) == change.deleted.end();
    });
    if (i == 0) panel.lines.push_back({direct});
    for (const auto& e : features.edges()) {
      panel.lines.push_back({{change.after.mesh.find_half_edge(e[0], e[1])}, Panel::Line::Kind::feature});
    }
    panel.unit = 17;
    sheet.add(panel, 0, static_cast<double>(i));
  }
  return sheet.paint();
}

Paint paint_equal_pair_moves() {
  Sheet sheet;
  const std::array<PairStep, 2> steps{PairStep::slide_second, PairStep::close};  // (-1,+1) and (+1,+1)
  Region region = region_with(theory::kDigon, 3, 1, {2, 2});
  std::vector<FaceId> made;
  for (std::size_t i = 0; i <= steps.size(); ++i) {
    const auto irregular = mesh::irregular_vertices(region.mesh);
    const auto moves = mesh::pair_moves(region.mesh, irregular.at(0), irregular.at(1));
    const mesh::PairFrame frame = moves.at(0).frame;
    Panel panel{region,
                {std::string("(") + static_cast<char>('a' + i) + ")   d_1 = " + std::to_string(frame.d1) +
                 ", d_2 = " + std::to_string(frame.d2)}};
    panel.blue = mesh::grid(region.mesh, frame).value();
    panel.made = made;
    if (i < steps.size()) {
      const auto move = std::find_if(moves.begin(), moves.end(), [&](const PairMove& x) { return x.step == steps[i]; });
      if (move == moves.end()) throw std::logic_error("the figure's pair has no such move");
      QuadMesh m = region.mesh;
      const mesh::MoveReport report = mesh::move_pair(m, *move);
      require_performed(report.refusal);
      const RegionChange change = perform_all(region, report.operations);
      panel.deleted = change.deleted;
      made = change.made;
      region = change.after;
    }
    const auto added = sheet.add(panel, 0, static_cast<double>(i));
    if (i > 0) sheet.arrow(added - 1, added);
  }
  return sheet.paint();
}

}  // namespace requad::figures
