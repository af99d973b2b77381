#include "mesh/commands/possible_moves.hpp"

#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

#include "mesh/commands/pair_edit.hpp"

namespace requad::edit {

using mesh::AdjacentPair;
using mesh::EditRefusal;
using mesh::HalfEdgeId;
using mesh::PairMove;
using mesh::PairTransport;
using mesh::QuadMesh;
using mesh::Refusal;
using mesh::VertexId;

namespace {

// Makes the step if the mesh allows it.
PossibleMove make_step(Session& session, const PairMove& step) {
  PossibleMove move{name(step.step), "", Refusal::none, 0, 0};
  const mesh::MoveReport report = mesh::move_pair(session.editor(), step);
  move.refusal = report.refusal;
  if (move.refusal != Refusal::none) return move;
  move.operations = static_cast<int>(report.operations.size());
  move.faces_gained = report.faces_made() - report.faces_deleted();
  move.effect = extents_text(step.frame) + " becomes " + extents_text(report.inverse.frame);
  return move;
}

// Transports the adjacent pair `start` from the vertex `from` to the vertex `to`, unless that is refused.
PossibleMove make_transport(Session& session, PairTransport& transport, VertexId from, VertexId to,
                            AdjacentPair start) {
  const QuadMesh& m = session.mesh();
  const int faces = m.face_count();
  const VertexId next = start.u(m) == from ? start.v(m) : start.u(m);
  PossibleMove move{"from " + std::to_string(session.number(from)) + " to " + std::to_string(session.number(next)), "",
                    Refusal::none, 0, 0};
  const mesh::TransportReport report = transport.carry(start, std::array{to});
  move.refusal = report.refusal;
  if (move.refusal != Refusal::none) return move;
  move.operations = report.steps;
  move.faces_gained = m.face_count() - faces;
  move.effect = "the other moves by an edge too";
  return move;
}

// The adjacent pairs that can leave the vertex. The vertex is the u of such a pair where a sector lacks a quad, and the
// v where a sector has one quad too many.
std::vector<AdjacentPair> starts_at(const Session& session, const mesh::Sectors& sectors, VertexId from) {
  std::vector<AdjacentPair> starts;
  for (const int excess : {-1, 1}) {
    sectors.for_each_edge(from, excess, [&](VertexId, HalfEdgeId at) {
      const bool leaves_from = session.mesh().origin(at) == from;
      starts.push_back({at, (excess < 0) != leaves_from});
    });
  }
  return starts;
}

bool has_sector_of_excess_one(const mesh::Sectors& sectors, VertexId v) {
  bool found = false;
  sectors.for_each_sector(v, [&](HalfEdgeId h) { found = found || std::abs(sectors.excess(h)) == 1; });
  return found;
}

}  // namespace

Refusal for_each_move(Session& session, VertexId a, VertexId b, const std::function<bool(const PossibleMove&)>& visit) {
  mesh::Editor& editor = session.editor();
  const mesh::Sectors& sectors = editor.sectors();
  if (a == b || !has_sector_of_excess_one(sectors, a) || !has_sector_of_excess_one(sectors, b))
    return EditRefusal::wrong_valences;
  const std::size_t mark = editor.mark();
  std::vector<PairMove> steps;  // of free vertices only; features and boundaries allow transports alone
  if (!editor.is_fixed(a) && !editor.is_fixed(b)) steps = mesh::pair_moves(session.mesh(), a, b);
  for (const PairMove& step : steps) {
    if (visit(make_step(session, step))) return Refusal::none;
    editor.roll_back(mark);
  }
  if (!steps.empty()) return Refusal::none;
  PairTransport transport(editor);
  for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
    for (const AdjacentPair start : starts_at(session, sectors, from)) {
      if (visit(make_transport(session, transport, from, to, start))) return Refusal::none;
      editor.roll_back(mark);
    }
  }
  return Refusal::none;
}

bool names_one_vertex(const Session& session) { return session.options().words().size() == 2; }

int refuse_one_vertex(Session& session) {
  const VertexId v = session.vertex(session.options().words()[1]);
  const bool irregular = session.editor().sectors().is_irregular(v);
  return session.refused(session.describe(v), irregular ? EditRefusal::lone_vertex : EditRefusal::wrong_valences);
}

}  // namespace requad::edit
