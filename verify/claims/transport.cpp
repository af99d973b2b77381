// Claims about the adjacent pair on its way: it goes round a sharp feature (P4), and from either end of a pair (P5).
#include "mesh/irregular/transport.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "mesh/topology/distances.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "verify/claims/judging.hpp"

namespace requad::verify {

using enumerate::FoundMove;
using enumerate::FoundNode;
using mesh::HalfEdgeId;
using mesh::QuadMesh;
using mesh::Refusal;
using mesh::Region;
using mesh::VertexId;

namespace {

// Larger regions repeat what smaller ones show.
constexpr int kLargestDetour = 30;  // perimeter
// The largest perimeter for which transports are exhausted.
constexpr int kLargestAllPaths = 12;

std::string signature_of(const Region& before, const QuadMesh& after) {
  return mesh::signature(after, after.out(before.mesh.origin(before.root)));
}

bool holds_edge(const QuadMesh& m, const std::array<VertexId, 2>& edge) {
  return m.is_live(edge[0]) && m.is_live(edge[1]) && m.adjacent(edge[0], edge[1]);
}

// Among the edges that a move removes, one farthest from the pair. Nothing if the move removes none. A feature on this
// edge obstructs the move.
std::optional<std::array<VertexId, 2>> edge_removed(const FoundNode& node, const FoundMove& move) {
  const QuadMesh& m = node.region.mesh;
  QuadMesh after = m;
  mesh::apply_all(after, move.script);
  std::optional<std::array<VertexId, 2>> best;
  int distance = 0;
  for (const HalfEdgeId h : m.half_edges()) {
    const VertexId a = m.origin(h), b = m.target(h);
    if (b < a || m.is_boundary(h)) continue;
    if (holds_edge(after, {a, b})) continue;
    int d = m.vertex_capacity();
    for (const VertexId x : {a, b}) {
      for (const VertexId v : {move.move.frame.v1, move.move.frame.v2}) d = std::min(d, mesh::graph_distance(m, x, v));
    }
    if (d > distance) distance = d, best = {a, b};
  }
  return best;
}

// A move with a feature on an edge that its direct path removes.
struct ObstructedMove {
  const FoundMove* move;
  std::array<VertexId, 2> feature;
};

struct Detour {
  std::set<std::string> made;  // signatures of what the move itself and transports made, the feature untouched
  std::string problem;         // "" if nothing is wrong
};

// Makes the move with the feature there, then transports adjacent pairs from both ends in all directions. `known` has
// the signatures that moves make.
Detour go_round(const PairStudy& s, const ObstructedMove& obstructed, const mesh::FeatureSet& features,
                const std::set<std::string>& known) {
  const FoundMove& move = *obstructed.move;
  const FoundNode& node = s.found.nodes[static_cast<std::size_t>(move.from)];
  QuadMesh m = node.region.mesh;
  mesh::Editor editor(m, &features);
  mesh::PairTransport transport(editor);
  Detour detour;
  const auto look = [&]() -> std::string {
    const std::string result = signature_of(node.region, m);
    const bool kept = holds_edge(m, obstructed.feature);
    // Untouched: the valences of its ends stayed as they are, on the way as well.
    const bool untouched = std::none_of(editor.edits().begin(), editor.edits().end(), [&](const mesh::Edit& edit) {
      return std::any_of(edit.changed.begin(), edit.changed.end(), [&](VertexId v) { return features.is_vertex(v); });
    });
    if (untouched) detour.made.insert(result);
    editor.roll_back();
    if (!kept) return "a pair transported round the feature removed it";
    if (known.count(result) == 0) return "the transport round a feature made a configuration that no move reaches";
    return "";
  };
  if (mesh::move_pair(editor, move.move).refusal == Refusal::none) detour.problem = look();
  for (const VertexId p : {move.move.frame.v1, move.move.frame.v2}) {
    const VertexId q = p == move.move.frame.v1 ? move.move.frame.v2 : move.move.frame.v1;
    for (const HalfEdgeId start : mesh::departures(m, p)) {
      if (!detour.problem.empty()) return detour;
      if (transport.carry({start}, std::array{q}).refusal == Refusal::none) detour.problem = look();
    }
  }
  if (detour.problem.empty() && !(m == node.region.mesh)) detour.problem = "what was tried was not rolled back";
  return detour;
}

}  // namespace

// Makes each move again with a feature on an edge that its direct path removes. Whatever is made keeps the feature and
// is a configuration that moves make. In a small region all transports that leave the feature untouched are exhausted.
// Each of them makes what a move makes, transports make nothing else, and they are refused only if there is none.
Judgement judge_detour(const PairStudy& s) {
  if (s.found.nodes.empty() || s.shape.perimeter() > kLargestDetour) return not_applicable();
  std::set<std::string> known;
  for (const FoundNode& node : s.found.nodes) known.insert(node.signature);
  std::vector<ObstructedMove> obstructed;
  for (const FoundMove& move : s.found.moves) {
    if (move.to < 0 || !s.found.holds_pair(move.from) || !s.found.holds_pair(move.to)) continue;
    const auto feature = edge_removed(s.found.nodes[static_cast<std::size_t>(move.from)], move);
    if (feature) obstructed.push_back({&move, *feature});
  }
  const bool exhausted = s.shape.perimeter() <= kLargestAllPaths;
  int made = 0, possible = 0;
  Judgement j = for_each_of(
      obstructed, "obstructed move",
      exhausted ? "the feature is kept, and a transport goes round it wherever there is a path"
                : "the feature is kept, and every way round it makes what a move makes",
      [&](const ObstructedMove& move) -> std::string {
        mesh::FeatureSet features;
        features.insert(move.feature[0], move.feature[1]);
        const FoundNode& from = s.found.nodes[static_cast<std::size_t>(move.move->from)];
        const std::string& wanted = s.found.nodes[static_cast<std::size_t>(move.move->to)].signature;
        const Detour detour = go_round(s, move, features, known);
        made += static_cast<int>(detour.made.count(wanted));
        if (!exhausted || !detour.problem.empty()) return detour.problem;
        const std::vector<std::string> list = enumerate::transports_round(from.region, features);
        const std::set<std::string> ends(list.begin(), list.end());
        possible += static_cast<int>(ends.count(wanted));
        if (!std::includes(known.begin(), known.end(), ends.begin(), ends.end()))
          return "some path round the feature makes a configuration that no move reaches";
        if (!std::includes(ends.begin(), ends.end(), detour.made.begin(), detour.made.end()))
          return "a transport round the feature made what no path round it makes";
        const bool there_is_a_path = ends.size() > ends.count(from.signature);
        return there_is_a_path && detour.made.empty() ? "there is a path round the feature, but no transport took one"
                                                      : "";
      },
      [&s](const ObstructedMove& move, std::string what) { return at_move(s, *move.move, std::move(what)); });
  j.found += ", " + std::to_string(made) + " made round the feature";
  if (j.checks > 0) {
    j.row = {{"sides", side_list(s.shape.sides())},
             {"pair", s.shape.type().name()},
             {"blocked", j.checks},
             {"made_round_the_feature", made},
             {"possible", nullptr}};
    if (exhausted) j.row["possible"] = possible;
  }
  return j;
}

namespace {

// The largest perimeter for which pipelines are exhausted.
constexpr int kLargestAllPipelines = 18;
// From here on the first operation can move one vertex of a pair alone, in every direction.
constexpr int kFar = 3;

// The signatures of what pipelines make of a configuration.
struct Pipelines {
  std::set<std::string> from_v5;        // only their last operation changes the v3
  std::set<std::string> from_v3;        // the adjacent pair may pass the v5
  std::set<std::string> from_v3_alone;  // only their last operation changes the v5
};

Pipelines pipelines_of(const FoundNode& node, const mesh::PairFrame& frame) {
  const auto set_of = [&](VertexId first, VertexId last, enumerate::Passing passing) {
    const std::vector<std::string> list = enumerate::pipelines(node.region, first, last, passing);
    return std::set<std::string>(list.begin(), list.end());
  };
  using enum enumerate::Passing;
  return {set_of(frame.v1, frame.v2, not_allowed), set_of(frame.v2, frame.v1, allowed),
          set_of(frame.v2, frame.v1, not_allowed)};
}

// Makes a slide from one end. Its first operation moves that end alone, and it leads where the move leads. Returns what
// is wrong, or "".
std::string check_start(const PairStudy& s, const FoundMove& move, bool from_v3) {
  const Region& region = s.found.nodes[static_cast<std::size_t>(move.from)].region;
  mesh::PairMove slide = move.move;
  slide.from_v2 = from_v3;
  QuadMesh after = region.mesh;
  const mesh::MoveReport report = mesh::move_pair(after, slide);
  const std::string from = from_v3 ? "from the v3" : "from the v5";
  if (report.refusal != Refusal::none) return "the slide is refused " + from;
  if (signature_of(region, after) != s.found.nodes[static_cast<std::size_t>(move.to)].signature)
    return "the slide makes another mesh " + from;
  const auto changed = mesh::changed_vertices(region.mesh, report.operations.front());
  const auto has = [&changed](VertexId v) { return std::find(changed.begin(), changed.end(), v) != changed.end(); };
  const mesh::PairFrame& frame = slide.frame;
  return has(from_v3 ? frame.v2 : frame.v1) && !has(from_v3 ? frame.v1 : frame.v2) ? "" : "no slide starts " + from;
}

}  // namespace

// The pipeline of section 6 and its reverse. In a small region all pipelines are exhausted. In every region slides are
// made from both ends. (A v5 on a segment does not start a slide by collapses, so that one is made from its v3.)
Judgement judge_pipeline(const PairStudy& s) {
  std::vector<const FoundMove*> moves;
  for (const FoundMove& move : s.found.moves) {
    if (move.to >= 0 && move.move.frame.distance() >= kFar) moves.push_back(&move);
  }
  const bool exhausted = s.shape.perimeter() <= kLargestAllPipelines;
  std::map<int, Pipelines> pipelines;  // by configuration
  int alone = 0;
  Judgement j = for_each_of(
      moves, "move", "made from either vertex",
      [&](const FoundMove* move) -> std::string {
        const mesh::PairFrame& frame = move->move.frame;
        const bool slides =
            move->move.step == mesh::PairStep::slide_first || move->move.step == mesh::PairStep::slide_second;
        for (const bool from_v3 : {false, true}) {
          if (!slides || (frame.degenerate() && !from_v3)) continue;
          if (std::string problem = check_start(s, *move, from_v3); !problem.empty()) return problem;
        }
        if (!exhausted) return "";
        const FoundNode& from = s.found.nodes[static_cast<std::size_t>(move->from)];
        if (pipelines.count(move->from) == 0) pipelines.emplace(move->from, pipelines_of(from, frame));
        const Pipelines& made = pipelines.at(move->from);
        const std::string& wanted = s.found.nodes[static_cast<std::size_t>(move->to)].signature;
        alone += static_cast<int>(made.from_v3_alone.count(wanted));
        if (made.from_v5.count(wanted) == 0) return "no pipeline from the v5 makes the move";
        return made.from_v3.count(wanted) == 0 ? "no pipeline from the v3 makes the move" : "";
      },
      [&s](const FoundMove* move, std::string what) { return at_move(s, *move, std::move(what)); });
  for (const auto& [node, made] : pipelines) {
    for (const auto* ends : {&made.from_v5, &made.from_v3}) {
      ++j.checks;
      const bool known = std::all_of(ends->begin(), ends->end(), [&s](const std::string& end) {
        return std::any_of(s.found.nodes.begin(), s.found.nodes.end(),
                           [&end](const FoundNode& n) { return n.signature == end; });
      });
      if (!known && !j.violation)
        j.violation = at_node(s, static_cast<std::size_t>(node), "a pipeline makes what no moves make");
    }
  }
  if (j.applies && exhausted) {
    j.row = {
        {"sides", side_list(s.shape.sides())}, {"moves", moves.size()}, {"from_the_v3_without_passing_the_v5", alone}};
  }
  return j;
}

}  // namespace requad::verify
