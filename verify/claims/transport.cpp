// Claims about the transport of an adjacent 3-5 pair: round a feature (P4), and to a third irregular vertex (N3).
#include <algorithm>
#include <array>
#include <set>

#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/topology/distances.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
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

// All half-edges by which an adjacent pair can leave one vertex of the pair.
std::vector<HalfEdgeId> departures(const QuadMesh& m, VertexId v) {
  std::vector<HalfEdgeId> result;
  m.for_each_out(v, [&](HalfEdgeId h) { result.push_back(m.valence(v) == 3 ? h : m.twin(h)); });
  return result;
}

// A move with a feature on an edge that its direct path removes.
struct ObstructedMove {
  const FoundMove* move;
  std::array<VertexId, 2> feature;
};

struct Detour {
  bool arrived = false;  // a transport round the feature made what the move makes
  std::string problem;   // "" if nothing is wrong
};

// Tries the direct path, then transports adjacent pairs in all directions. `known` has the signatures that moves make.
Detour go_round(const PairStudy& s, const ObstructedMove& obstructed, const std::set<std::string>& known) {
  const FoundMove& move = *obstructed.move;
  const FoundNode& node = s.found.nodes[static_cast<std::size_t>(move.from)];
  mesh::FeatureSet features;
  features.insert(obstructed.feature[0], obstructed.feature[1]);
  QuadMesh m = node.region.mesh;
  mesh::Editor editor(m, &features);
  if (mesh::move_pair(editor, move.move).refusal == Refusal::none)
    return {false, holds_edge(m, obstructed.feature) ? "" : "the direct path removes a feature edge"};
  if (!(m == node.region.mesh)) return {false, "the direct path was refused, and changed the mesh"};
  mesh::PairTransport transport(editor);
  Detour detour;
  for (const VertexId p : {move.move.frame.v1, move.move.frame.v2}) {
    const VertexId q = p == move.move.frame.v1 ? move.move.frame.v2 : move.move.frame.v1;
    for (const HalfEdgeId start : departures(m, p)) {
      if (transport.carry({start}, std::array{q}).refusal != Refusal::none) continue;
      const std::string result = signature_of(node.region, m);
      const bool kept = holds_edge(m, obstructed.feature);
      detour.arrived = detour.arrived || result == s.found.nodes[static_cast<std::size_t>(move.to)].signature;
      editor.roll_back();
      if (!kept) return {detour.arrived, "a pair transported round the feature removed it"};
      if (known.count(result) == 0)
        return {detour.arrived, "the transport round a feature made a configuration that no move reaches"};
      if (!(m == node.region.mesh)) return {detour.arrived, "the transport was not rolled back"};
    }
  }
  return detour;
}

}  // namespace

// Makes each move again with a feature on an edge that the direct path removes. The direct path is then refused.
// Adjacent pairs are transported in all directions. They go round the feature or are refused. They keep the feature,
// and every configuration they make is one that moves make.
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
  int detours = 0;
  Judgement j = for_each_of(
      obstructed, "obstructed move", "the feature is kept, and every way round it makes what a move makes",
      [&](const ObstructedMove& move) {
        const Detour detour = go_round(s, move, known);
        detours += detour.arrived ? 1 : 0;
        return detour.problem;
      },
      [&s](const ObstructedMove& move, std::string what) { return at_move(s, *move.move, std::move(what)); });
  j.found += ", " + std::to_string(detours) + " made round the feature";
  if (j.checks > 0)
    j.row = {{"sides", side_list(s.shape.sides())},
             {"pair", s.shape.type().name()},
             {"blocked", j.checks},
             {"made_round_the_feature", detours}};
  j.applies = detours > 0 || j.violation;
  return j;
}

namespace {

// What was done on the fillings of a region with three irregular vertices.
struct Edits {
  std::int64_t pairs = 0;  // tried
  int cancelled = 0;       // fillings in which a pair was cancelled
  int merged = 0;          // fillings in which a pair was merged
  int transports = 0;
};

// Cancels or merges every two of the three vertices. Returns what is wrong, or "".
std::string edit_three(const TripleStudy& s, const Region& region, Edits& edits) {
  const auto found = [](const Signatures& list, const std::string& signature) {
    return std::binary_search(list.begin(), list.end(), signature);
  };
  const std::vector<VertexId> irregular = mesh::irregular_vertices(region.mesh);
  bool cancels = false, merges = false;
  for (const VertexId a : irregular) {
    for (const VertexId b : irregular) {
      const int la = region.mesh.valence(a), lb = region.mesh.valence(b);
      if (a == b || la > lb || (la == lb && b < a)) continue;
      ++edits.pairs;
      QuadMesh m = region.mesh;
      mesh::Editor editor(m);
      mesh::PairTransport transport(editor);
      bool done = false;
      if (la == lb) {
        done = mesh::merge_pair(editor, a, b).refusal == Refusal::none;
        merges = merges || done;
      } else {
        std::vector<VertexId> third = irregular;
        std::erase_if(third, [&](VertexId v) { return v == a || v == b; });
        const mesh::Cancellation c = mesh::cancel_pair(editor, transport, a, b, third);
        done = c.refusal == Refusal::none;
        edits.transports += c.transports;
        cancels = cancels || done;
      }
      if (done) {
        const std::string signature = signature_of(region, m);
        if (!mesh::validate(m).empty()) return "the operation leaves an invalid mesh";
        if (!found(la == lb ? s.with_two : s.with_one, signature))
          return "the operation makes a filling that the search does not know";
      }
      editor.roll_back();
      if (!(m == region.mesh)) return "the operation was not rolled back";
    }
  }
  edits.cancelled += cancels ? 1 : 0;
  edits.merged += merges ? 1 : 0;
  if (cancels == !s.with_one.empty()) return "";
  return cancels ? "a pair was cancelled, but the search finds no filling with one vertex"
                 : "the search finds a filling with one vertex, but no pair was cancelled";
}

}  // namespace

// Every filling with three irregular vertices. A v3 is cancelled with a v5 by transports that end at the third vertex;
// two equal vertices are merged by pair moves. Compares the results with what the search finds for the valences that
// are left.
Judgement judge_three_vertices(const TripleStudy& s) {
  Edits edits;
  Judgement j = for_each_of(
      s.fillings, "filling",
      s.with_one.empty() ? "no pair is cancelled, as no filling has one vertex" : "a pair is cancelled",
      [&](const Region& region) { return edit_three(s, region, edits); },
      [](const Region& region, std::string what) {
        return Violation{std::move(what), "", "", region};
      });
  if (!j.applies) return j;
  j.checks = edits.pairs;
  j.found += ": cancelled in " + std::to_string(edits.cancelled) + ", merged in " + std::to_string(edits.merged);
  j.row = {{"sides", side_list(s.region.sides)},     {"irregular", s.region.valences}, {"fillings", s.fillings.size()},
           {"with_one_vertex", s.with_one.size()},   {"cancelled", edits.cancelled},   {"couriers", edits.transports},
           {"with_two_vertices", s.with_two.size()}, {"merged", edits.merged}};
  return j;
}

}  // namespace requad::verify
