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

// The vertices of the pair after the move: `moved` is the end at which it started, `met` the one at which it ended.
struct Ends {
  VertexId moved;
  VertexId met;
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
    const HalfEdgeId leg = hand == Hand::left ? frame.first_leg : frame.second_leg;
    transport.start(leg, m.target(leg));
  } else {
    // Along the first or the last outward separatrix.
    const HalfEdgeId along_outward = hand == Hand::left ? m.ccw(frame.second_leg) : m.cw(frame.first_leg);
    transport.start(m.twin(along_outward), m.target(along_outward));
  }
  const int diagonal = std::min(forward, sideways);
  // Along a segment the pair of a v3 reaches the v5 head on and makes it a v6, which the last split parts evenly.
  const bool head_on = from_v3 && !to_v3 && sideways == 0;
  transport.split(hand, forward - diagonal - (head_on ? 1 : 0));
  if (head_on) transport.split(hand, 1, 3);
  transport.flip(hand, diagonal);
  transport.collapse(hand, sideways - diagonal);
  return {transport.moved(), to_v3 ? transport.v3() : transport.v5()};
}

// Splits only.
Ends open(DirectTransport& transport, PairFrame frame) {
  const QuadMesh& m = transport.mesh();
  // A mixed pair starts at its v5. Seen from the v3 it goes round the other corner of R_alpha.
  const bool other_corner = m.valence(frame.v1) == 3 && m.valence(frame.v2) == 5;
  if (other_corner) frame = seen_from_other_end(m, frame);
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
    const HalfEdgeId leg = first ? frame.first_leg : frame.second_leg;
    transport.start(leg, m.target(leg));
    const Hand hand = first ? Hand::right : Hand::left;
    transport.split(hand, (first ? frame.d2 : frame.d1) - 1);
    transport.split(other(hand), first ? frame.d1 : frame.d2);
    return {transport.moved(), transport.v3()};
  }
  // From a v5 the adjacent pair comes in by the middle outward separatrix; a merged pair has only that.
  const bool merged = frame.v1 == frame.v2;
  const bool to_v5 = m.valence(frame.v2) != 3;
  const HalfEdgeId middle = merged ? frame.first_leg : m.ccw(m.ccw(frame.second_leg));
  transport.start(m.twin(middle), m.target(middle));
  transport.split(other_corner ? Hand::left : Hand::right, other_corner ? frame.d1 : frame.d2);
  transport.split(other_corner ? Hand::right : Hand::left, other_corner ? frame.d2 : frame.d1);
  // A v5 that the adjacent pair's v5 has reached is a v6. Split evenly it becomes regular, and the far end of the path
  // is q.
  if (to_v5) transport.split(Hand::left, 1, 3);
  return {transport.moved(), to_v5 ? transport.v5() : transport.v3()};
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
  // A mixed pair starts at its v3. Seen from there it goes round the other corner of R_alpha.
  const bool other_corner = m.valence(frame.v1) == 3 && m.valence(frame.v2) == 5;
  if (m.valence(frame.v1) == 5 && m.valence(frame.v2) == 3) frame = seen_from_other_end(m, frame);
  if (m.valence(frame.v1) == 3) {
    const bool to_v3 = m.valence(frame.v2) == 3;
    const HalfEdgeId outward_edge = m.ccw(frame.second_leg);
    transport.start(outward_edge, m.target(outward_edge));
    // Past a v3 on its far side, onto a v5 directly.
    if (other_corner || (to_v3 && frame.d2 >= 1)) {
      transport.collapse(Hand::right, frame.d1 + (to_v3 ? 1 : 0));
      transport.collapse(Hand::left, frame.d2);
    } else {
      transport.collapse(Hand::left, frame.d2 + (to_v3 ? 1 : 0));
      transport.collapse(Hand::right, frame.d1);
    }
    return {transport.moved(), to_v3 ? transport.v3() : transport.v5()};
  }
  // The corner quad of R_alpha at v1 closes across: its two other neighbours of v1 become a v6, which is both where v1
  // moves to and the v5 of the adjacent pair.
  const HalfEdgeId keep = QuadMesh::next(frame.first_leg);
  const HalfEdgeId pair = m.twin(keep);
  const VertexId joined = m.origin(keep);
  transport.run({BasicOperation::Kind::collapse, keep, {}, 0});
  transport.start(pair, joined);
  if (frame.d2 == 1 && frame.d1 == 1) return {joined, joined};
  transport.collapse(Hand::left, frame.d2 - 1);
  transport.collapse(Hand::right, frame.d1 - 1);
  return {transport.moved(), transport.v5()};
}

// Where v1 came from: the edge of its new place that leads back to its old one, counted counter-clockwise from the first
// leg. A mixed pair is seen from the v5. Precondition: the pair does not merge, and was not merged.
int edge_back(int valence, const PairMove& move) {
  const bool is_v3 = valence == 3;
  const int longer_leg = move.frame.d2 > 0 ? 1 : 0;  // what a segment bends round is its first or its second leg
  switch (move.step) {
    case PairStep::slide_first: return is_v3 ? 1 : 4;
    case PairStep::slide_second: return is_v3 ? 0 : 2;
    case PairStep::open: return is_v3 ? 2 : longer_leg;
    case PairStep::close: return is_v3 ? longer_leg : 3;
  }
  return 0;
}

// The frame that h, an edge of `ends.moved`, is the first leg of, if the pair spans a rectangle of these extents there.
std::optional<PairFrame> frame_along(const QuadMesh& m, HalfEdgeId h, Ends ends, Extents extents) {
  // One way round the rectangle tells the legs from the other edges; the other way is for the one that has arrived.
  std::optional<HalfEdgeId> way = extents.d2 > 0 ? end_of_straight_path(m, h, extents.d2) : m.ccw(h);
  if (way && extents.d2 > 0 && extents.d1 > 0) {
    way = m.is_boundary(m.target(*way)) ? std::nullopt : end_of_straight_path(m, QuadMesh::next(*way), extents.d1);
  } else if (extents.d1 > 0) {
    way = end_of_straight_path(m, m.ccw(h), extents.d1);
  }
  if (!way || m.target(*way) != ends.met) return std::nullopt;
  const auto found = frame_at(m, h, extents.d1, extents.d2);
  return found && found->v2 == ends.met ? found : std::nullopt;
}

// The frame of the pair after a move, whose extents are known; its first leg is one of the edges of `moved`. On a closed
// surface the pair may span several rectangles of these extents. The one of the move has the old place of v1, `origin`,
// beyond the edge number `back` (edge_back()).
std::optional<PairFrame> frame_after(const QuadMesh& m, Ends ends, Extents extents, VertexId origin, int back) {
  std::optional<PairFrame> found;
  bool is_certain = false;
  m.for_each_out(ends.moved, [&](HalfEdgeId h) {
    if (is_certain) return;
    const auto frame = frame_along(m, h, ends, extents);
    if (!frame) return;
    HalfEdgeId to_origin = h;
    for (int i = 0; i < back; ++i) to_origin = m.ccw(to_origin);
    is_certain = m.target(to_origin) == origin;
    if (is_certain || !found) found = frame;
  });
  return found;
}

// A pair that merged, seen along the edge by which the inverse parts it: the edge to `origin` parts a v6 as it was; either
// face of a v2 does.
std::optional<PairFrame> merged_frame(const QuadMesh& m, VertexId merged, VertexId origin) {
  std::optional<PairFrame> found;
  m.for_each_out(merged, [&](HalfEdgeId h) {
    if (found || (m.valence(merged) == 6 && m.target(h) != origin)) return;
    found = PairFrame{h, m.ccw(h), merged, merged, 0, 0};
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
  // The v5 comes first; of two equal vertices the frames are found from the lesser one, so that v1, v2 and v2, v1 have
  // their moves in one order.
  const bool from_v1 = l1 != l2 ? l1 > l2 : v1 < v2;
  std::vector<PairFrame> frames = from_v1 ? find_frames(m, v1, v2) : find_frames(m, v2, v1);
  if (l1 == l2 && !from_v1) {
    for (PairFrame& frame : frames) frame = seen_from_other_end(m, frame);
  }
  std::vector<PairMove> moves;
  for (const PairFrame& frame : frames) {
    if (l1 != l2 && frame.d1 == 0) continue;  // both frames of a segment describe the same four translations
    for (const PairStep step : kPairSteps) {
      const PairMove move{frame, step};
      const Extents to = after(m, move);
      if (to.d1 >= 0 && to.d2 >= 0) moves.push_back(move);
    }
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

// Performs the operations of a move, starting at frame.v1, until one is refused.
Ends perform(DirectTransport& transport, const PairMove& move) {
  const QuadMesh& m = transport.mesh();
  const PairFrame& frame = move.frame;
  const Extents extents = after(m, move);
  const bool parts = frame.merged() && move.step == (m.valence(frame.v1) == 2 ? PairStep::close : PairStep::open);
  if (extents.d2 < 0 || extents.d1 < 0 || (frame.merged() && !parts)) {
    transport.refuse(EditRefusal::no_such_step);
    return {};
  }
  Ends ends;
  switch (move.step) {
    case PairStep::slide_first: ends = slide(transport, frame, Hand::left); break;
    case PairStep::slide_second: ends = slide(transport, frame, Hand::right); break;
    case PairStep::open: ends = open(transport, frame); break;
    case PairStep::close: ends = close(transport, frame); break;
  }
  if (!transport.refused()) transport.require_regular_except(ends.moved, ends.met);
  return ends;
}

// What became of a move that was tried.
struct Tried {
  Refusal refusal = Refusal::none;
  std::array<VertexId, 2> after;  // v1 and v2 of the move's frame; of a mixed pair the v5 first
  PairMove inverse;               // only where it was asked for
};

// Makes the move from frame.v1. Finds its inverse if that is asked for. A move that is refused is rolled back.
Tried try_from_v1(OperationLog& log, const PairMove& move, bool with_inverse) {
  const QuadMesh& m = log.mesh();
  const auto [l2, l1] = std::minmax({m.valence(move.frame.v1), m.valence(move.frame.v2)});
  const VertexId origin = m.valence(move.frame.v1) == l1 ? move.frame.v1 : move.frame.v2;
  const Extents extents = after(m, move);
  const std::size_t start = log.mark();
  DirectTransport transport(log, move.frame);
  Ends ends = perform(transport, move);
  Tried result;
  if (!transport.refused()) {
    // A mixed pair keeps its valences, and frames have the v5 first, wherever the move started.
    if (m.valence(ends.moved) < m.valence(ends.met)) std::swap(ends.moved, ends.met);
    const bool stays_two = !move.frame.merged() && ends.moved != ends.met;
    if (stays_two && (m.valence(ends.moved) != l1 || m.valence(ends.met) != l2))
      transport.refuse(EditRefusal::irregular_in_the_way);
    result.after = {ends.moved, ends.met};
  }
  if (!transport.refused() && with_inverse) {
    const bool merges = extents.d1 == 0 && extents.d2 == 0;
    std::optional<PairFrame> found;
    if (merges && ends.moved == ends.met) {
      found = merged_frame(m, ends.moved, move.frame.v1);
    } else if (!merges && ends.moved != ends.met) {
      found = frame_after(m, ends, extents, origin, edge_back(l1, move));
    }
    if (found) {
      result.inverse = {*found, inverse(move.step)};
    } else {
      transport.refuse(EditRefusal::irregular_in_the_way);
    }
  }
  if (transport.refused()) log.roll_back(start);
  result.refusal = transport.refusal();
  return result;
}

// Makes the move from the one end, or from the other if that is refused.
Tried try_move(OperationLog& log, const PairMove& move, bool with_inverse) {
  const QuadMesh& m = log.mesh();
  const PairFrame& frame = move.frame;
  const bool equal = m.valence(frame.v1) == m.valence(frame.v2);
  Tried result;
  Refusal first_refusal;
  for (const bool from_v2 : {move.from_v2, !move.from_v2}) {
    if (from_v2 && frame.merged()) continue;
    result = try_from_v1(log, {from_v2 ? seen_from_other_end(m, frame) : frame, move.step}, with_inverse);
    if (from_v2 && equal) std::swap(result.after[0], result.after[1]);
    // The way back starts where this way ended. The inverse's frame has the vertex first that moved first, or the v5.
    result.inverse.from_v2 = !result.inverse.frame.merged() && (equal || !from_v2);
    if (result.refusal == Refusal::none) return result;
    if (first_refusal == Refusal::none) first_refusal = result.refusal;
  }
  result.refusal = std::min(result.refusal, first_refusal);
  const bool may_overlap =
      result.refusal == EditRefusal::irregular_in_the_way || result.refusal == Refusal::edge_exists;
  if (may_overlap && overlaps_itself(m, frame)) result.refusal = EditRefusal::overlaps_itself;
  return result;
}

int count(std::span<const BasicOperation> operations, BasicOperation::Kind kind) {
  return static_cast<int>(std::count_if(operations.begin(), operations.end(),
                                        [kind](const BasicOperation& op) { return op.kind == kind; }));
}

}  // namespace

int MoveReport::faces_made() const { return count(operations, BasicOperation::Kind::split); }
int MoveReport::faces_deleted() const { return count(operations, BasicOperation::Kind::collapse); }

MoveReport move_pair(OperationLog& log, const PairMove& move) {
  const std::size_t start = log.operations().size();
  const Tried tried = try_move(log, move, true);
  MoveReport report;
  report.refusal = tried.refusal;
  if (report.refusal != Refusal::none) return report;
  report.inverse = tried.inverse;
  report.after = tried.after;
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
  const Refusal refusal = try_move(log, move, true).refusal;
  log.roll_back();
  return refusal;
}

PairMover::Moved PairMover::move(const PairMove& move) {
  log_.forget();
  const Tried tried = try_move(log_, move, false);
  if (tried.refusal != Refusal::none) return {tried.refusal, VertexId(), VertexId(), 0};
  return {Refusal::none, tried.after[0], tried.after[1], static_cast<int>(log_.operations().size())};
}

}  // namespace requad::mesh
