#include "mesh/irregular/possible_moves.hpp"

#include <array>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include "mesh/editing/element_map.hpp"

namespace requad::mesh {

namespace {

// Makes the step if the mesh allows it.
void make_step(Editor& editor, const PairMove& step, VertexId a, PossibleMove& move) {
  const MoveReport report = move_pair(editor, step);
  move.refusal = report.refusal;
  if (move.refusal != Refusal::none) return;
  move.after = report.after;
  if (step.frame.v1 != a) std::swap(move.after[0], move.after[1]);
  move.from = step.frame;
  move.to = report.inverse.frame;
  move.effect = extents_text(*move.from) + " becomes " + extents_text(*move.to);
}

// Transports the adjacent pair `start`, which leaves the first of the two vertices, to the second, unless that is
// refused.
void make_transport(Editor& editor, PairTransport& transport, std::array<VertexId, 2> ends, AdjacentPair start,
                    PossibleMove& move) {
  const QuadMesh& m = editor.mesh();
  const VertexId moved = start.u(m) == ends[0] ? start.v(m) : start.u(m);
  const TransportReport report = transport.carry(start, std::array{ends[1]});
  move.refusal = report.refusal;
  move.obstacles = report.obstacles;
  if (move.refusal != Refusal::none) return;
  const auto if_irregular = [&editor](VertexId v) {
    return editor.mesh().is_live(v) && editor.sectors().is_irregular(v) ? v : VertexId();
  };
  const VertexId u = if_irregular(report.pair.u(m)), v = if_irregular(report.pair.v(m));
  move.after = {if_irregular(moved), u.valid() && u != moved ? u : v};
  move.effect = "the other moves by an edge too";
}

std::string transport_name(const QuadMesh& m, VertexId from, AdjacentPair start) {
  const VertexId next = start.u(m) == from ? start.v(m) : start.u(m);
  return "from " + std::to_string(file_number(m, from)) + " to " + std::to_string(file_number(m, next));
}

// The adjacent pairs that can leave the vertex. The vertex is the u of such a pair where a sector lacks a quad, and the
// v where a sector has one quad too many.
std::vector<AdjacentPair> starts_at(const QuadMesh& m, const Sectors& sectors, VertexId from) {
  std::vector<AdjacentPair> starts;
  for (const int excess : {-1, 1}) {
    sectors.for_each_edge(from, excess, [&](VertexId, HalfEdgeId at) {
      const bool leaves_from = m.origin(at) == from;
      starts.push_back({at, (excess < 0) != leaves_from});
    });
  }
  return starts;
}

bool has_sector_of_excess_one(const Sectors& sectors, VertexId v) {
  bool found = false;
  sectors.for_each_sector(v, [&](HalfEdgeId h) { found = found || std::abs(sectors.excess(h)) == 1; });
  return found;
}

}  // namespace

std::string extents_text(const PairFrame& frame) {
  return "(" + std::to_string(frame.d1) + "," + std::to_string(frame.d2) + ")";
}

Refusal for_each_move(Editor& editor, VertexId a, VertexId b, const std::function<bool(const PossibleMove&)>& visit) {
  const Sectors& sectors = editor.sectors();
  if (a == b || !has_sector_of_excess_one(sectors, a) || !has_sector_of_excess_one(sectors, b))
    return EditRefusal::wrong_valences;
  const std::size_t mark = editor.mark();
  PairTransport transport(editor);
  struct Candidate {
    PossibleMove move;
    std::function<void(PossibleMove&)> make;
  };
  std::vector<Candidate> candidates;
  const auto add = [&candidates](const std::string& step, std::function<void(PossibleMove&)> make) {
    Candidate& candidate = candidates.emplace_back();
    candidate.move.step = step;
    candidate.make = std::move(make);
  };
  // Steps are of free vertices only; features and boundaries allow transports alone.
  if (!editor.is_fixed(a) && !editor.is_fixed(b)) {
    for (const PairMove& step : pair_moves(editor.mesh(), a, b))
      add(name(step.step), [&editor, step, a](PossibleMove& move) { make_step(editor, step, a, move); });
  }
  if (candidates.empty()) {
    for (const std::array<VertexId, 2> ends : {std::array{a, b}, std::array{b, a}}) {
      for (const AdjacentPair start : starts_at(editor.mesh(), sectors, ends[0])) {
        add(transport_name(editor.mesh(), ends[0], start), [&editor, &transport, ends, start, a](PossibleMove& move) {
          make_transport(editor, transport, ends, start, move);
          if (ends[0] != a) std::swap(move.after[0], move.after[1]);
        });
      }
    }
  }
  std::map<std::string, int> of_step, numbered;
  for (const Candidate& candidate : candidates) ++of_step[candidate.move.step];
  for (Candidate& candidate : candidates) {
    PossibleMove& move = candidate.move;
    move.name = move.step;
    if (of_step[move.step] > 1) move.name += "." + std::to_string(++numbered[move.step]);
    candidate.make(move);
    if (move.refusal == Refusal::none) move.counts = count(std::span(editor.edits()).subspan(mark));
    if (visit(move)) return Refusal::none;
    editor.roll_back(mark);
  }
  return Refusal::none;
}

}  // namespace requad::mesh
