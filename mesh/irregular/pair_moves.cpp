#include "mesh/irregular/pair_moves.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "mesh/irregular/direct_transport.hpp"
#include "mesh/irregular/edit_refusal.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::mesh {

PairStep inverse(PairStep step) {
  switch (step) {
    case PairStep::slide_first: return PairStep::slide_second;
    case PairStep::slide_second: return PairStep::slide_first;
    case PairStep::open: return PairStep::close;
    case PairStep::close: return PairStep::open;
  }
  return step;
}

const char* name(PairStep step) {
  switch (step) {
    case PairStep::slide_first: return "slide_first";
    case PairStep::slide_second: return "slide_second";
    case PairStep::open: return "open";
    case PairStep::close: return "close";
  }
  return "";
}

namespace {

struct Extents {
  int d1;
  int d2;
};

// The extents after a step, by the table in the header.
Extents after(const QuadMesh& m, const PairMove& move) {
  const int l1 = m.valence(move.frame.v1);
  const int l2 = m.valence(move.frame.v2);
  if (move.frame.v1 != move.frame.v2 && l1 != l2) return {move.frame.d1, move.frame.d2};
  const int sign = l1 == 3 || l1 == 2 ? 1 : -1;
  switch (move.step) {
    case PairStep::slide_first: return {move.frame.d1 + sign, move.frame.d2 - sign};
    case PairStep::slide_second: return {move.frame.d1 - sign, move.frame.d2 + sign};
    case PairStep::open: return {move.frame.d1 - sign, move.frame.d2 - sign};
    case PairStep::close: return {move.frame.d1 + sign, move.frame.d2 + sign};
  }
  return {-1, -1};
}

// The vertices of the pair after the move.
struct Ends {
  VertexId p;
  VertexId q;
};

// slide_first with the left hand, slide_second with the right. `forward` is p's extent along the leg of that hand.
Ends slide(DirectTransport& transport, PairFrame frame, Hand hand) {
  const QuadMesh& m = transport.mesh();
  const auto along = [hand](const PairFrame& f) { return hand == Hand::left ? f.d2 : f.d1; };
  const auto is_v3 = [&m](VertexId v) { return m.valence(v) == 3; };
  // A v5 cannot start by a collapse, which is all there is to do if the leg has no length: start at the other end.
  if (!is_v3(frame.v1) && is_v3(frame.v2) && along(frame) == 0) frame = seen_from_other_end(m, frame);
  const bool from_v3 = is_v3(frame.v1);
  const bool to_v3 = is_v3(frame.v2);
  const int forward = along(frame) - (from_v3 ? 1 : 0) + (to_v3 ? 0 : 1);
  const int sideways = hand == Hand::left ? frame.d1 : frame.d2;

  if (from_v3) {
    transport.start(hand == Hand::left ? frame.first_leg : frame.second_leg);
  } else {
    // Along the first or the last outward separatrix.
    transport.start(m.twin(hand == Hand::left ? m.ccw(frame.second_leg) : m.cw(frame.first_leg)));
  }
  const VertexId p = from_v3 ? transport.v5() : transport.v3();
  const int diagonal = std::min(forward, sideways);
  transport.split(hand, forward - diagonal);
  transport.flip(hand, diagonal);
  transport.collapse(hand, sideways - diagonal);
  return {p, to_v3 ? transport.v3() : transport.v5()};
}

// Splits only.
Ends open(DirectTransport& transport, const PairFrame& frame) {
  const QuadMesh& m = transport.mesh();
  if (m.valence(frame.v1) == 3) {
    if (frame.d2 == 1 && frame.d1 == 1) {
      // The path v1 - x - v2 turns, so the part of x on the inner side is left with valence 2: the merged vertex.
      const HalfEdgeId to_v2 = QuadMesh::next(frame.first_leg);
      transport.run({BasicOperation::Kind::split, to_v2, frame.first_leg, 0});
      const VertexId merged = m.origin(to_v2);
      return {merged, merged};
    }
    // The first split must be straight: take the longer leg first.
    const bool first = frame.d2 >= 2;
    transport.start(first ? frame.first_leg : frame.second_leg);
    const VertexId p = transport.v5();
    const Hand hand = first ? Hand::right : Hand::left;
    transport.split(hand, (first ? frame.d2 : frame.d1) - 1);
    transport.split(other(hand), first ? frame.d1 : frame.d2);
    return {p, transport.v3()};
  }
  // From a v5 the adjacent pair comes in by the middle outward separatrix; a merged pair has only that.
  const bool merged = frame.v1 == frame.v2;
  const bool to_v5 = m.valence(frame.v2) != 3;
  transport.start(m.twin(merged ? frame.first_leg : m.ccw(m.ccw(frame.second_leg))));
  const VertexId p = transport.v3();
  transport.split(Hand::right, frame.d2);
  transport.split(Hand::left, frame.d1);
  // A v5 that the adjacent pair's v5 has reached is a v6. Split evenly it becomes regular, and the far end of the path
  // is q.
  if (to_v5) transport.split(Hand::left, 1, 3);
  return {p, to_v5 ? transport.v5() : transport.v3()};
}

// Collapses only.
Ends close(DirectTransport& transport, PairFrame frame) {
  const QuadMesh& m = transport.mesh();
  if (frame.v1 == frame.v2) {
    const VertexId p = m.target(frame.first_leg);
    const VertexId q = m.origin(QuadMesh::previous(frame.first_leg));
    transport.run({BasicOperation::Kind::collapse, frame.first_leg, {}, 0});
    return {p, q};
  }
  if (m.valence(frame.v1) != 3 && m.valence(frame.v2) == 3) frame = seen_from_other_end(m, frame);
  if (m.valence(frame.v1) == 3) {
    const bool to_v3 = m.valence(frame.v2) == 3;
    transport.start(m.ccw(frame.second_leg));
    const VertexId p = transport.v5();
    // Past a v3 on its far side, onto a v5 directly.
    const bool right_first = to_v3 && frame.d2 >= 1;
    if (right_first) {
      transport.collapse(Hand::right, frame.d1 + 1);
      transport.collapse(Hand::left, frame.d2);
    } else {
      transport.collapse(Hand::left, frame.d2 + (to_v3 ? 1 : 0));
      transport.collapse(Hand::right, frame.d1);
    }
    return {p, to_v3 ? transport.v3() : transport.v5()};
  }
  // The corner quad of R_alpha at v1 closes across: its two other neighbours of v1 become a v6, which is both the new p
  // and the v5 of the adjacent pair.
  const HalfEdgeId keep = QuadMesh::next(frame.first_leg);
  const VertexId p = m.origin(keep);
  const HalfEdgeId pair = m.twin(keep);
  transport.run({BasicOperation::Kind::collapse, keep, {}, 0});
  transport.start(pair);
  if (frame.d2 == 1 && frame.d1 == 1) return {p, p};
  transport.collapse(Hand::left, frame.d2 - 1);
  transport.collapse(Hand::right, frame.d1 - 1);
  return {p, transport.v5()};
}

// The frame of the pair after a move: its extents are known, its first leg is one of the edges of v1. A merged pair is
// seen along the edge by which the inverse would part it.
std::optional<PairFrame> frame_after(const QuadMesh& m, Ends ends, Extents extents, VertexId towards) {
  std::optional<PairFrame> found;
  m.for_each_out(ends.p, [&](HalfEdgeId h) {
    if (found) return;
    if (ends.p == ends.q) {
      if (!towards.valid() || m.target(h) == towards) found = PairFrame{h, m.ccw(h), ends.p, ends.p, 0, 0};
      return;
    }
    // One way round the rectangle tells the legs from the other edges; the other way is for the one that has arrived.
    std::optional<HalfEdgeId> way = extents.d2 > 0 ? end_of_straight_path(m, h, extents.d2) : m.ccw(h);
    if (way && extents.d2 > 0 && extents.d1 > 0) {
      way = m.is_boundary(m.target(*way)) ? std::nullopt : end_of_straight_path(m, QuadMesh::next(*way), extents.d1);
    } else if (extents.d1 > 0) {
      way = end_of_straight_path(m, m.ccw(h), extents.d1);
    }
    if (!way || m.target(*way) != ends.q) return;
    found = frame_at(m, h, extents.d1, extents.d2);
    if (found && found->v2 != ends.q) found.reset();
  });
  return found;
}

bool is_pair(int l1, int l2) { return (l1 == 3 || l1 == 5) && (l2 == 3 || l2 == 5); }

}  // namespace

std::vector<PairMove> pair_moves(const QuadMesh& m, VertexId v1, VertexId v2) {
  if (m.is_boundary(v1) || m.is_boundary(v2) || v1 == v2) return {};
  const int l1 = m.valence(v1);
  const int l2 = m.valence(v2);
  if (!is_pair(l1, l2)) return {};
  const std::vector<PairFrame> frames = l1 >= l2 ? find_frames(m, v1, v2) : find_frames(m, v2, v1);
  std::vector<PairMove> moves;
  for (const PairFrame& frame : frames) {
    for (const PairStep step : kPairSteps) {
      const PairMove move{frame, step};
      const Extents to = after(m, move);
      if (to.d1 >= 0 && to.d2 >= 0) moves.push_back(move);
    }
    if (l1 != l2) break;  // both frames of a segment describe the same four translations
  }
  return moves;
}

std::vector<PairMove> parting_moves(const QuadMesh& m, VertexId merged) {
  if (m.is_boundary(merged)) return {};
  const int l = m.valence(merged);
  if (l != 2 && l != 6) return {};
  std::vector<PairMove> moves;
  HalfEdgeId h = m.out(merged);
  for (int i = 0; i < l / 2; ++i, h = m.ccw(h)) {
    moves.push_back({{h, m.ccw(h), merged, merged, 0, 0}, l == 2 ? PairStep::close : PairStep::open});
  }
  return moves;
}

namespace {

// Where the pair is after a move. The vertex p is the first one of its frame.
struct Moved {
  Ends ends;
  Extents extents;
};

// Performs the operations of a move, until one is refused.
Moved perform(DirectTransport& transport, const PairMove& move) {
  const QuadMesh& m = transport.mesh();
  const PairFrame& frame = move.frame;
  Moved result{{}, after(m, move)};
  const bool merged = frame.v1 == frame.v2;
  const bool parts = merged && move.step == (m.valence(frame.v1) == 2 ? PairStep::close : PairStep::open);
  if (result.extents.d2 < 0 || result.extents.d1 < 0 || (merged && !parts)) {
    transport.refuse(EditRefusal::no_such_step);
    return result;
  }
  Ends& ends = result.ends;
  switch (move.step) {
    case PairStep::slide_first: ends = slide(transport, frame, Hand::left); break;
    case PairStep::slide_second: ends = slide(transport, frame, Hand::right); break;
    case PairStep::open: ends = open(transport, frame); break;
    case PairStep::close: ends = close(transport, frame); break;
  }
  if (!transport.refused()) transport.require_regular_except(ends.p, ends.q);
  // Where a 3-5 move started at the v3, p is the v3; frames have the v5 first.
  if (!transport.refused() && m.valence(ends.p) < m.valence(ends.q)) std::swap(ends.p, ends.q);
  return result;
}

// Makes the move and finds its inverse. A move that is refused is rolled back.
Refusal move_and_find_inverse(OperationLog& log, const PairMove& move, PairMove& inverse_move) {
  const std::size_t start = log.mark();
  DirectTransport transport(log, move.frame);
  const Moved result = perform(transport, move);
  if (!transport.refused()) {
    const QuadMesh& m = log.mesh();
    // The edge to v1 parts a v6 as it was; either face of a v2 does.
    const VertexId towards = m.valence(result.ends.p) == 6 ? move.frame.v1 : VertexId();
    const auto found = frame_after(m, result.ends, result.extents, towards);
    if (found) {
      inverse_move = {*found, inverse(move.step)};
    } else {
      transport.refuse(EditRefusal::irregular_in_the_way);
    }
  }
  if (transport.refused()) log.roll_back(start);
  return transport.refusal();
}

int count(std::span<const BasicOperation> operations, BasicOperation::Kind kind) {
  return static_cast<int>(std::count_if(operations.begin(), operations.end(),
                                        [kind](const BasicOperation& op) { return op.kind == kind; }));
}

}  // namespace

int MoveReport::faces_made() const { return count(operations, BasicOperation::Kind::split); }
int MoveReport::faces_deleted() const { return count(operations, BasicOperation::Kind::collapse); }

MoveReport move_pair(OperationLog& log, const PairMove& move) {
  MoveReport report;
  const std::size_t start = log.operations().size();
  report.refusal = move_and_find_inverse(log, move, report.inverse);
  for (const PerformedOperation& done : std::span(log.operations()).subspan(start)) {
    report.operations.push_back(done.operation);
    report.undo.push_back(done.inverse);
  }
  std::reverse(report.undo.begin(), report.undo.end());
  return report;
}

MoveReport move_pair(QuadMesh& mesh, const PairMove& move) {
  OperationLog log(mesh);
  return move_pair(log, move);
}

Refusal why_not_move_pair(QuadMesh& mesh, const PairMove& move) {
  OperationLog log(mesh);
  PairMove back;
  const Refusal refusal = move_and_find_inverse(log, move, back);
  log.roll_back();
  return refusal;
}

PairMover::Moved PairMover::move(const PairMove& move) {
  log_.forget();
  DirectTransport transport(log_, move.frame);
  const mesh::Moved result = perform(transport, move);
  if (transport.refused()) {
    log_.roll_back();
    return {transport.refusal(), VertexId(), VertexId(), 0};
  }
  return {Refusal::none, result.ends.p, result.ends.q, static_cast<int>(log_.operations().size())};
}

}  // namespace requad::mesh
