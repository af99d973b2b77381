// The explored meshes and moves as JSON.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "figures/explorer/explorer.hpp"
#include "mesh/geometry/drawing.hpp"
#include "mesh/topology/separatrix.hpp"
#include "theory/counts.hpp"
#include "verify/claims/claims.hpp"

namespace requad::figures {

namespace {

using enumerate::Exploration;
using enumerate::FoundMove;
using enumerate::FoundNode;
using mesh::BasicOperation;
using mesh::FaceId;
using mesh::HalfEdgeId;
using mesh::PairFrame;
using mesh::PairStep;
using mesh::QuadMesh;
using mesh::VertexId;
using nlohmann::ordered_json;
using theory::Configuration;
using theory::Integer;
using theory::IntegerVector;
using theory::PairType;

// --- the graph -------------------------------------------------------------------------------------------------------

using Spot = std::array<Integer, 3>;

// The spot of a labelling: in the rotated grid of Figure 10, in the half cube of Figure 11, or in the grid of Figure
// 12. In the half cube, quadrant p lies between the axes p and p - 1.
Spot spot_of(PairType type, const Configuration& labelling) {
  if (!type.symmetric()) {
    const theory::GridPoint at = theory::grid_point(type, theory::canonical(type, labelling));
    return {at.m, at.n, 0};
  }
  const Integer m = labelling.d1();
  const Integer n = labelling.d2();
  if (type.rotation_count() == 1) return {m - n, m + n, 0};
  Spot at{};
  at[static_cast<std::size_t>((labelling.p - 1) % 3)] += m;
  at[static_cast<std::size_t>((labelling.p + 1) % 3)] += n;
  return at;
}

// The labellings of a configuration: two for a segment of equal valences, the canonical one first.
std::vector<Configuration> labellings(PairType type, const Configuration& c) {
  std::vector<Configuration> result{c};
  if (type.symmetric() && c.degenerate() && !c.merged()) result.push_back(theory::other_labelling(type, c));
  return result;
}

std::vector<Spot> spots_of(PairType type, const Configuration& c) {
  std::vector<Spot> spots;
  for (const Configuration& labelling : labellings(type, c)) {
    const Spot at = spot_of(type, labelling);
    if (std::find(spots.begin(), spots.end(), at) == spots.end()) spots.push_back(at);
  }
  return spots;
}

// The index of a labelling's spot among the spots of its configuration.
int spot_index(PairType type, const Configuration& c, const Configuration& labelling) {
  const std::vector<Spot> spots = spots_of(type, c);
  const auto it = c.merged() ? spots.begin() : std::find(spots.begin(), spots.end(), spot_of(type, labelling));
  if (it == spots.end()) throw std::logic_error("a move leaves the grid");
  return static_cast<int>(it - spots.begin());
}

struct GridStep {
  Integer m = 0;
  Integer n = 0;
};

std::string text(GridStep c) {
  const auto number = [](Integer x) { return (x > 0 ? "+" : "") + std::to_string(x); };
  return "(" + number(c.m) + "," + number(c.n) + ")";
}

GridStep change_of(PairType type, const FoundMove& move) {
  Configuration before = move.before.value();
  Configuration after = move.after.value();
  if (!type.symmetric()) {
    before = theory::canonical(type, before);
    after = theory::canonical(type, after);
  }
  const theory::GridPoint from = theory::grid_point(type, before);
  const theory::GridPoint to = theory::grid_point(type, after);
  return {to.m - from.m, to.n - from.n};
}

// The label of the labelling before or after a move. The grid of a 3-5 pair has one label for each configuration.
std::string name_of(PairType type, const Configuration& labelling) {
  return theory::label(type, type.symmetric() ? labelling : theory::canonical(type, labelling));
}

const char* key_of(PairType type, const Exploration& found, const FoundMove& move) {
  const GridStep change = change_of(type, move);
  if (!type.symmetric()) return change.m > 0 ? "right" : change.m < 0 ? "left" : change.n > 0 ? "up" : "down";
  const Configuration& from = found.nodes[static_cast<std::size_t>(move.from)].reading.configuration;
  if (from.merged()) {
    if (type.rotation_count() == 1) return "up";
    static constexpr std::array<const char*, 3> kQuadrants{"left", "right", "down"};
    return kQuadrants[static_cast<std::size_t>(move.after->p - 1)];
  }
  if (change.m != change.n) return change.m > 0 ? "right" : "left";
  if (change.m < 0) return "down";
  return move.before.value() == from ? "up" : "down";
}

// --- arrows ----------------------------------------------------------------------------------------------------------

// The vertex towards which a step takes v1 of a frame. It is the next one along a separatrix, or the far corner of the
// face between two separatrices. See the table of pair_moves.hpp.
VertexId heading(const QuadMesh& m, const PairFrame& f, PairStep step, bool other_is_alike) {
  const auto along = [&m](HalfEdgeId h) { return m.target(h); };
  // The far corner of the face between h and the next edge counter-clockwise.
  const auto between = [&m](HalfEdgeId h) { return m.target(QuadMesh::next(h)); };
  const std::vector<HalfEdgeId> out = mesh::outward(m, f);
  if (m.valence(f.v1) == 3) {
    switch (step) {
      // Two v3s on a segment approach each other, each on the side away from the R_alpha that opens. Beside a v5 the v3
      // moves away from its third edge.
      case PairStep::slide_first: return f.degenerate() ? between(out[0]) : along(f.first_leg);
      case PairStep::slide_second:
        return f.degenerate() && other_is_alike ? between(f.second_leg) : along(f.second_leg);
      case PairStep::open: return between(f.first_leg);
      case PairStep::close: return along(out[0]);
    }
  }
  switch (step) {
    case PairStep::slide_first: return along(out[0]);
    case PairStep::slide_second: return along(out[2]);
    case PairStep::open: return along(out[1]);
    case PairStep::close: return f.degenerate() ? along(f.second_leg) : between(f.first_leg);
  }
  return {};
}

ordered_json arrows(const QuadMesh& m, const mesh::PairMove& move) {
  const PairFrame& f = move.frame;
  const auto arrow = [](VertexId v, VertexId w) { return ordered_json{v.index(), w.index()}; };
  if (f.v1 == f.v2) {
    // A v2 parts along its two edges, a v6 along an edge and the opposite one.
    HalfEdgeId opposite = f.first_leg;
    for (int i = 0; i < m.valence(f.v1) / 2; ++i) opposite = m.ccw(opposite);
    return {arrow(f.v1, m.target(f.first_leg)), arrow(f.v1, m.target(opposite))};
  }
  const PairFrame other = mesh::seen_from_other_end(m, f);
  const bool alike = m.valence(f.v1) == m.valence(f.v2);
  return {arrow(f.v1, heading(m, f, move.step, alike)), arrow(f.v2, heading(m, other, move.step, alike))};
}

// --- meshes and operations -------------------------------------------------------------------------------------------

ordered_json corners(const QuadMesh& m, FaceId f) {
  ordered_json json = ordered_json::array();
  for (const VertexId v : m.corners(f)) json.push_back(v.index());
  return json;
}

ordered_json faces_json(const QuadMesh& m) {
  ordered_json json = ordered_json::array();
  for (int i = 0; i < m.face_capacity(); ++i)
    json.push_back(m.is_live(FaceId(i)) ? corners(m, FaceId(i)) : ordered_json());
  return json;
}

// The faces that differ between the two meshes: [id, a, b, c, d], or [id] for a deleted face.
ordered_json patch(const QuadMesh& before, const QuadMesh& after) {
  ordered_json json = ordered_json::array();
  for (int i = 0; i < after.face_capacity(); ++i) {
    const FaceId f(i);
    const bool was = i < before.face_capacity() && before.is_live(f);
    if (!after.is_live(f)) {
      if (was) json.push_back({i});
      continue;
    }
    if (was && before.corners(f) == after.corners(f)) continue;
    ordered_json entry{i};
    for (const VertexId v : after.corners(f)) entry.push_back(v.index());
    json.push_back(std::move(entry));
  }
  return json;
}

ordered_json operations_json(QuadMesh m, const std::vector<BasicOperation>& operations) {
  ordered_json json = ordered_json::array();
  for (const BasicOperation& op : operations) {
    const QuadMesh before = m;
    const mesh::Applied done = mesh::apply(m, op);
    if (done.refusal != mesh::Refusal::none) throw std::logic_error("a recorded operation is refused");
    ordered_json entry;
    switch (op.kind) {
      case BasicOperation::Kind::flip_ccw:
      case BasicOperation::Kind::flip_cw:
        entry = {{"kind", "flip"}, {"edge", {before.origin(op.h).index(), before.target(op.h).index()}}};
        break;
      case BasicOperation::Kind::collapse:
        entry = {{"kind", "collapse"},
                 {"face", QuadMesh::face(op.h).index()},
                 {"vertex", before.origin(QuadMesh::opposite(op.h)).index()},
                 {"into", before.origin(op.h).index()}};
        break;
      case BasicOperation::Kind::split:
        entry = {{"kind", "split"},
                 {"face", QuadMesh::face(done.made).index()},
                 {"vertex", m.origin(QuadMesh::opposite(done.made)).index()},
                 {"from", before.origin(op.h).index()}};
        break;
    }
    entry["patch"] = patch(before, m);
    json.push_back(std::move(entry));
  }
  return json;
}

std::vector<VertexId> path_vertices(const QuadMesh& m, const std::vector<HalfEdgeId>& path) {
  std::vector<VertexId> vertices{m.origin(path.front())};
  for (const HalfEdgeId h : path) vertices.push_back(m.target(h));
  return vertices;
}

ordered_json ids(const std::vector<VertexId>& vertices) {
  ordered_json json = ordered_json::array();
  for (const VertexId v : vertices) json.push_back(v.index());
  return json;
}

// The vertices on the rim of R_alpha, counter-clockwise from v1. For a segment, the vertices along it.
std::vector<VertexId> vertices_round(const QuadMesh& m, const PairFrame& f) {
  std::vector<VertexId> vertices{f.v1};
  for (const HalfEdgeId h : f.degenerate() ? mesh::path_between(m, f) : mesh::rim(m, f))
    vertices.push_back(m.target(h));
  if (!f.degenerate()) vertices.pop_back();  // v1 again
  return vertices;
}

// The outward separatrices, by the side of the region that they meet.
ordered_json outward_json(PairType type, const FoundNode& node) {
  const QuadMesh& m = node.region.mesh;
  const PairFrame& f = node.reading.frames.front().frame;
  const auto positions = mesh::boundary_positions(node.region);
  std::vector<ordered_json> by_side(static_cast<std::size_t>(type.side_count()));
  for (const HalfEdgeId h : mesh::outward_of_both(m, f)) {
    const mesh::Separatrix s = mesh::trace(m, h);
    const int side = positions[m.target(s.path.back()).slot()].side;
    by_side.at(static_cast<std::size_t>(side)) = ids(path_vertices(m, s.path));
  }
  return by_side;
}

ordered_json node_json(PairType type, const FoundNode& node) {
  const QuadMesh& m = node.region.mesh;
  const Configuration& c = node.reading.configuration;
  ordered_json names = ordered_json::array();
  for (const Configuration& labelling : labellings(type, c)) names.push_back(theory::label(type, labelling));
  const theory::GridPoint at = theory::grid_point(type, c);
  ordered_json json{{"label", theory::label(type, c)},
                    {"names", names},
                    {"d1", c.d1()},
                    {"d2", c.d2()},
                    {"m", at.m},
                    {"n", at.n},
                    {"quads", m.face_count()},
                    {"signature", node.signature},
                    {"spots", spots_of(type, c)}};
  // The larger side of the bounding box has length 2000. Whole numbers are then precise enough for the screen.
  const auto position = mesh::draw(node.region);
  double reach = 0;
  for (const auto& p : position) reach = std::max(reach, p.cwiseAbs().maxCoeff());
  json["vertices"] = ordered_json::array();
  for (int i = 0; i < m.vertex_capacity(); ++i) {
    const auto& p = position[static_cast<std::size_t>(i)];
    const auto rounded = [reach](double x) { return static_cast<int>(std::lround(1000 * x / reach)); };
    json["vertices"].push_back(m.is_live(VertexId(i)) ? ordered_json{rounded(p.x()), rounded(p.y())} : ordered_json());
  }
  json["faces"] = faces_json(m);
  json["root"] = {m.origin(node.region.root).index(), m.target(node.region.root).index()};
  json["irregular"] = ids(node.reading.irregular);
  const PairFrame& frame = node.reading.frames.front().frame;
  json["alpha"] = ordered_json::array();
  if (!c.merged()) {
    const auto between = mesh::grid(m, frame);
    if (!between) throw std::logic_error("R_alpha is no grid");
    for (const FaceId f : *between) json["alpha"].push_back(f.index());
  }
  json["rim"] = ids(vertices_round(m, frame));
  json["outward"] = outward_json(type, node);
  return json;
}

}  // namespace

std::string explorer_problem(const theory::RegionShape& shape) {
  const auto too_much = [](const std::string& what, Integer most) {
    return what + "; the explorer, to stay quick, takes at most " + std::to_string(most);
  };
  if (shape.longest() > kLongestSide)
    return too_much("a side of " + std::to_string(shape.longest()) + " edges", kLongestSide);
  const Integer count = theory::exact_count(shape);
  if (count == 0) return "the region has no configuration with a " + shape.type().name() + " pair";
  if (count > kMostConfigurations) return too_much(std::to_string(count) + " configurations", kMostConfigurations);
  Integer quads = 0;
  for (const Configuration& c : theory::parameter_set(shape)) quads += shape.system().face_count(c.parameters);
  if (quads > kMostQuads) {
    return too_much(std::to_string(quads) + " quads in " + std::to_string(count) + " configurations", kMostQuads);
  }
  return "";
}

ordered_json explorer_claims(const Exploration& found) {
  std::vector<std::string> ids;
  for (const verify::Claim& claim : verify::claims()) ids.push_back(claim.id);
  ordered_json json = ordered_json::array();
  for (const verify::RegionVerdict& verdict : verify::judge_region(verify::study_moves(found), ids)) {
    const auto& violation = verdict.judgement.violation;
    json.push_back({{"id", verdict.claim->id},
                    {"where", verdict.claim->where},
                    {"statement", verdict.claim->statement},
                    {"predicted", verdict.judgement.predicted},
                    {"found", verdict.judgement.found},
                    {"holds", verdict.holds()},
                    {"violation", violation ? verify::described(*violation) : ""}});
  }
  return json;
}

ordered_json explorer_data(const Exploration& found) {
  const PairType type = found.shape.type();
  const IntegerVector& sides = found.shape.sides();
  ordered_json json{{"pair", type.name()},
                    {"sides", std::vector<Integer>(sides.begin(), sides.end())},
                    {"regular", type.symmetric() && found.shape.is_regular()},
                    {"grid", type.rotation_count() == 3 ? "cube" : "flat"},
                    {"nodes", ordered_json::array()},
                    {"moves", ordered_json::array()},
                    {"claims", explorer_claims(found)}};
  for (const FoundNode& node : found.nodes) json["nodes"].push_back(node_json(type, node));
  for (const FoundMove& move : found.moves) {
    if (move.to < 0) continue;
    const FoundNode& from = found.nodes[static_cast<std::size_t>(move.from)];
    const FoundNode& to = found.nodes[static_cast<std::size_t>(move.to)];
    json["moves"].push_back({{"from", move.from},
                             {"to", move.to},
                             {"spots",
                              {spot_index(type, from.reading.configuration, *move.before),
                               spot_index(type, to.reading.configuration, *move.after)}},
                             {"names", {name_of(type, *move.before), name_of(type, *move.after)}},
                             {"key", key_of(type, found, move)},
                             {"change", text(change_of(type, move))},
                             {"step", mesh::name(move.move.step)},
                             {"made", move.faces_made},
                             {"deleted", move.faces_deleted},
                             {"arrows", arrows(from.region.mesh, move.move)},
                             {"operations", operations_json(from.region.mesh, move.script)}});
  }
  return json;
}

}  // namespace requad::figures
