#include "mesh/irregular/pair_moves.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "mesh/irregular/transport_step.hpp"
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

// Performs on a mesh alone and remembers nothing but what was done.
class OnMesh {
 public:
  OnMesh(QuadMesh& mesh, std::vector<Applied>& log) : mesh_(mesh), log_(log) { log_.clear(); }

  const QuadMesh& mesh() const { return mesh_; }
  Applied run(const BasicOperation& op) {
    const Applied done = apply(mesh_, op);
    if (done.refusal == Refusal::none) log_.push_back(done);
    return done;
  }
  void roll_back() {
    for (; !log_.empty(); log_.pop_back()) take_back(mesh_, log_.back().inverse);
  }

 private:
  QuadMesh& mesh_;
  std::vector<Applied>& log_;
};

// Performs by an editor, which keeps features and positions.
class OnEditor {
 public:
  explicit OnEditor(Editor& editor) : editor_(editor), start_(editor.mark()) {}

  const QuadMesh& mesh() const { return editor_.mesh(); }
  Applied run(const BasicOperation& op) { return editor_.run(op); }
  void roll_back() { editor_.roll_back(start_); }

 private:
  Editor& editor_;
  std::size_t start_;
};

// Basic operations in sequence, with the courier's place. After a refusal everything is a no-op until the roll-back.
//
// What may be irregular on the way: the pair, what the first operation changed, and the courier. Everything else that a
// step changes is regular before the courier comes and when it has left (Law C1 of transport.hpp), so that is all there is
// to keep in mind, and to look at in the end.
template <class Performer>
class Passage {
 public:
  Passage(Performer performer, const PairFrame& pair) : performer_(performer), m_(performer_.mesh()) {
    keep(pair.v1);
    keep(pair.v2);
  }

  const QuadMesh& mesh() const { return m_; }
  Refusal refusal() const { return refusal_; }
  bool refused() const { return refusal_ != Refusal::none; }
  void refuse(Refusal why) {
    if (!refused()) refusal_ = why;
  }
  int operations() const { return operations_; }

  // Places the courier: h runs from its v3 (or what plays it) to its v5.
  void start(HalfEdgeId h) {
    at_ = {h};
    for (const VertexId v : {v3(), v5()}) {
      if (m_.is_boundary(v)) refuse(Refusal::touches_boundary);
      if (m_.face_valence(v) != 4 && !is_kept(v)) refuse(Refusal::irregular_in_the_way);
    }
  }
  VertexId v3() const { return at_.u(m_); }
  VertexId v5() const { return at_.v(m_); }

  void split(Hand hand, int times = 1, int turn = 2) { step<TransportStep::Kind::split>(hand, times, turn); }
  void collapse(Hand hand, int times = 1) { step<TransportStep::Kind::collapse>(hand, times); }
  void flip(Hand hand, int times = 1) { step<TransportStep::Kind::flip>(hand, times); }

  // A first operation, unless it is illegal, changes a valence on the boundary or that of an irregular vertex beside the
  // pair.
  void run(const BasicOperation& op) {
    if (refused()) return;
    refuse(why_not(m_, op));
    if (refused()) return;
    const auto changed = changed_vertices(m_, op);
    for (const VertexId v : changed) {
      if (!v.valid()) continue;
      if (m_.is_boundary(v)) refuse(Refusal::touches_boundary);
      if (m_.face_valence(v) != 4 && !is_kept(v)) refuse(Refusal::irregular_in_the_way);
    }
    if (!refused()) perform(op, changed);
  }

  // All that changed, but for the pair itself, must be regular in the end.
  void require_regular_except(VertexId p, VertexId q) {
    keep(last_u_);
    keep(last_v_);
    if (at_.edge.valid()) keep(v3()), keep(v5());
    for (int i = 0; i < kept_count_; ++i) {
      const VertexId v = kept_[static_cast<std::size_t>(i)];
      if (m_.is_live(v) && v != p && v != q && m_.face_valence(v) != 4) refuse(Refusal::irregular_in_the_way);
    }
  }

  void roll_back() { performer_.roll_back(); }

 private:
  // A vertex that may be irregular for now.
  void keep(VertexId v) {
    if (v.valid() && !is_kept(v)) kept_[static_cast<std::size_t>(kept_count_++)] = v;
  }
  bool is_kept(VertexId v) const {
    for (int i = 0; i < kept_count_; ++i) {
      if (kept_[static_cast<std::size_t>(i)] == v) return true;
    }
    return false;
  }

  // Whether the courier may land there: at a regular vertex, or at one that may be irregular for now.
  bool can_land(HalfEdgeId h) {
    if (!h.valid()) {
      refuse(Refusal::touches_boundary);
    } else if (!is_regular_at(m_, h)) {
      const VertexId v = m_.origin(h);
      if (m_.is_boundary(v)) {
        refuse(Refusal::touches_boundary);
      } else if (!is_kept(v) && v != v3() && v != v5()) {
        refuse(Refusal::irregular_in_the_way);
      }
    }
    return !refused();
  }

  // The loop is made for each way and hand, so that the plan is but a few loads.
  template <TransportStep::Kind kind, Hand hand>
  void steps(int times, int turn) {
    constexpr bool kSplits = kind == TransportStep::Kind::split;
    for (int i = 0; i < times && !refused(); ++i) {
      const PlannedStep planned = planned_step(m_, at_, {kind, hand}, turn);
      if ((!kSplits && !can_land(planned.at_u)) || !can_land(planned.at_v)) return;
      if (operations_ == 0) {
        const auto changed = why_not(m_, planned.operation) == Refusal::none ? changed_vertices(m_, planned.operation)
                                                                             : std::array<VertexId, 4>{};
        if (!perform(planned.operation, changed)) return;
      } else {
        last_u_ = v3();
        last_v_ = v5();
        if (!note(performer_.run(planned.operation))) return;
      }
      at_ = planned.next;
    }
  }
  template <TransportStep::Kind kind>
  void step(Hand hand, int times, int turn = 2) {
    if (hand == Hand::left) {
      steps<kind, Hand::left>(times, turn);
    } else {
      steps<kind, Hand::right>(times, turn);
    }
  }

  bool note(const Applied& done) {
    refuse(done.refusal);
    ++operations_;
    made_ = done.made;
    return !refused();
  }
  // The first operation.
  bool perform(const BasicOperation& op, const std::array<VertexId, 4>& changed) {
    for (const VertexId v : changed) keep(v);
    if (!note(performer_.run(op))) return false;
    if (op.kind == BasicOperation::Kind::split) keep(m_.origin(QuadMesh::opposite(made_)));
    return true;
  }

  Performer performer_;
  const QuadMesh& m_;
  Refusal refusal_ = Refusal::none;
  AdjacentPair at_;
  int operations_ = 0;
  HalfEdgeId made_;           // by the last operation
  VertexId last_u_, last_v_;  // the courier before the last step
  std::array<VertexId, 16> kept_;
  int kept_count_ = 0;
};

// The places of the pair after the move.
struct Ends {
  VertexId p;
  VertexId q;
};

// slide_first with the left hand, slide_second with the right. `forward` is p's extent along the leg of that hand.
template <class Performer>
Ends slide(Passage<Performer>& passage, PairFrame frame, Hand hand) {
  const QuadMesh& m = passage.mesh();
  const auto along = [hand](const PairFrame& f) { return hand == Hand::left ? f.d2 : f.d1; };
  const auto is_v3 = [&m](VertexId v) { return m.valence(v) == 3; };
  // A v5 can not start by a collapse, which is all there is to do if the leg has no length: start at the other end.
  if (!is_v3(frame.v1) && is_v3(frame.v2) && along(frame) == 0) frame = seen_from_other_end(m, frame);
  const bool from_v3 = is_v3(frame.v1);
  const bool to_v3 = is_v3(frame.v2);
  const int forward = along(frame) - (from_v3 ? 1 : 0) + (to_v3 ? 0 : 1);
  const int sideways = hand == Hand::left ? frame.d1 : frame.d2;

  if (from_v3) {
    passage.start(hand == Hand::left ? frame.first_leg : frame.second_leg);
  } else {
    // Along the first or the last outward separatrix.
    passage.start(m.twin(hand == Hand::left ? m.ccw(frame.second_leg) : m.cw(frame.first_leg)));
  }
  const VertexId p = from_v3 ? passage.v5() : passage.v3();
  const int diagonal = std::min(forward, sideways);
  passage.split(hand, forward - diagonal);
  passage.flip(hand, diagonal);
  passage.collapse(hand, sideways - diagonal);
  return {p, to_v3 ? passage.v3() : passage.v5()};
}

// Splits only.
template <class Performer>
Ends open(Passage<Performer>& passage, const PairFrame& frame) {
  const QuadMesh& m = passage.mesh();
  if (m.valence(frame.v1) == 3) {
    if (frame.d2 == 1 && frame.d1 == 1) {
      // The path v1 - x - v2 turns, so the part of x on the inner side is left with valence 2: the merged vertex.
      const HalfEdgeId to_v2 = QuadMesh::next(frame.first_leg);
      passage.run({BasicOperation::Kind::split, to_v2, frame.first_leg, 0});
      const VertexId merged = m.origin(to_v2);
      return {merged, merged};
    }
    // The first split must be straight: take the longer leg first.
    const bool first = frame.d2 >= 2;
    passage.start(first ? frame.first_leg : frame.second_leg);
    const VertexId p = passage.v5();
    const Hand hand = first ? Hand::right : Hand::left;
    passage.split(hand, (first ? frame.d2 : frame.d1) - 1);
    passage.split(other(hand), first ? frame.d1 : frame.d2);
    return {p, passage.v3()};
  }
  // From a v5 the courier comes in by the middle outward separatrix; a merged pair has only that.
  const bool merged = frame.v1 == frame.v2;
  const bool to_v5 = m.valence(frame.v2) != 3;
  passage.start(m.twin(merged ? frame.first_leg : m.ccw(m.ccw(frame.second_leg))));
  const VertexId p = passage.v3();
  passage.split(Hand::right, frame.d2);
  passage.split(Hand::left, frame.d1);
  // A v5 that the courier's v5 reached has valence 6; parted evenly it is regular, and the far end of the path is q.
  if (to_v5) passage.split(Hand::left, 1, 3);
  return {p, to_v5 ? passage.v5() : passage.v3()};
}

// Collapses only.
template <class Performer>
Ends close(Passage<Performer>& passage, PairFrame frame) {
  const QuadMesh& m = passage.mesh();
  if (frame.v1 == frame.v2) {
    const VertexId p = m.target(frame.first_leg);
    const VertexId q = m.origin(QuadMesh::previous(frame.first_leg));
    passage.run({BasicOperation::Kind::collapse, frame.first_leg, {}, 0});
    return {p, q};
  }
  if (m.valence(frame.v1) != 3 && m.valence(frame.v2) == 3) frame = seen_from_other_end(m, frame);
  if (m.valence(frame.v1) == 3) {
    const bool to_v3 = m.valence(frame.v2) == 3;
    passage.start(m.ccw(frame.second_leg));
    const VertexId p = passage.v5();
    // Past a v3 on its far side, onto a v5 directly.
    const bool right_first = to_v3 && frame.d2 >= 1;
    if (right_first) {
      passage.collapse(Hand::right, frame.d1 + 1);
      passage.collapse(Hand::left, frame.d2);
    } else {
      passage.collapse(Hand::left, frame.d2 + (to_v3 ? 1 : 0));
      passage.collapse(Hand::right, frame.d1);
    }
    return {p, to_v3 ? passage.v3() : passage.v5()};
  }
  // The corner quad of R_alpha at v1 closes across: its two other neighbours of v1 become a v6, which is the new p and
  // the courier's v5 in one.
  const HalfEdgeId keep = QuadMesh::next(frame.first_leg);
  const VertexId p = m.origin(keep);
  const HalfEdgeId courier = m.twin(keep);
  passage.run({BasicOperation::Kind::collapse, keep, {}, 0});
  passage.start(courier);
  if (frame.d2 == 1 && frame.d1 == 1) return {p, p};
  passage.collapse(Hand::left, frame.d2 - 1);
  passage.collapse(Hand::right, frame.d1 - 1);
  return {p, passage.v5()};
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
    std::optional<HalfEdgeId> way = extents.d2 > 0 ? walk(m, h, extents.d2) : m.ccw(h);
    if (way && extents.d2 > 0 && extents.d1 > 0) {
      way = m.is_boundary(m.target(*way)) ? std::nullopt : walk(m, QuadMesh::next(*way), extents.d1);
    } else if (extents.d1 > 0) {
      way = walk(m, m.ccw(h), extents.d1);
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
      if (to.d2 >= 0 && to.d1 >= 0) moves.push_back(move);
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

// The operations of a move, and where the pair is then, extents included; p is the first vertex of its frame.
struct Carried {
  Ends ends;
  Extents extents;
};

template <class Performer>
Carried carry(Passage<Performer>& passage, const PairMove& move) {
  const QuadMesh& m = passage.mesh();
  const PairFrame& frame = move.frame;
  Carried result{{}, after(m, move)};
  const bool merged = frame.v1 == frame.v2;
  const bool parts = merged && move.step == (m.valence(frame.v1) == 2 ? PairStep::close : PairStep::open);
  if (result.extents.d2 < 0 || result.extents.d1 < 0 || (merged && !parts)) {
    passage.refuse(Refusal::no_such_step);
    return result;
  }
  Ends& ends = result.ends;
  switch (move.step) {
    case PairStep::slide_first: ends = slide(passage, frame, Hand::left); break;
    case PairStep::slide_second: ends = slide(passage, frame, Hand::right); break;
    case PairStep::open: ends = open(passage, frame); break;
    case PairStep::close: ends = close(passage, frame); break;
  }
  if (!passage.refused()) passage.require_regular_except(ends.p, ends.q);
  // Where a 3-5 move started at the v3, p is the v3; frames have the v5 first.
  if (!passage.refused() && m.valence(ends.p) < m.valence(ends.q)) std::swap(ends.p, ends.q);
  return result;
}

// The reason to refuse the move, or its inverse in `inverse`. A refusal is rolled back.
template <class Performer>
Refusal carry_and_frame(Performer performer, const PairMove& move, PairMove& inverse_move) {
  Passage<Performer> passage(performer, move.frame);
  const Carried result = carry(passage, move);
  if (!passage.refused()) {
    const QuadMesh& m = passage.mesh();
    // The edge to v1 parts a v6 as it was; either face of a v2 does.
    const VertexId towards = m.valence(result.ends.p) == 6 ? move.frame.v1 : VertexId();
    const auto found = frame_after(m, result.ends, result.extents, towards);
    if (found) {
      inverse_move = {*found, inverse(move.step)};
    } else {
      passage.refuse(Refusal::irregular_in_the_way);
    }
  }
  if (passage.refused()) passage.roll_back();
  return passage.refusal();
}

void report_operation(MoveReport& report, const BasicOperation& op, const BasicOperation& undo) {
  report.operations.push_back(op);
  report.undo.push_back(undo);
  if (op.kind == BasicOperation::Kind::split) report.faces_made.push_back(QuadMesh::face(undo.h));
  if (op.kind == BasicOperation::Kind::collapse) report.faces_deleted.push_back(QuadMesh::face(op.h));
}

}  // namespace

MoveReport move_pair(Editor& editor, const PairMove& move) {
  MoveReport report;
  const std::size_t start = editor.mark();
  report.refusal = carry_and_frame(OnEditor(editor), move, report.inverse);
  if (report.refusal != Refusal::none) return report;
  for (std::size_t i = start; i < editor.mark(); ++i) {
    report_operation(report, editor.edits()[i].operation, editor.edits()[i].inverse);
  }
  std::reverse(report.undo.begin(), report.undo.end());
  return report;
}

MoveReport move_pair(QuadMesh& mesh, const PairMove& move) {
  Editor editor(mesh);
  return move_pair(editor, move);
}

Refusal why_not_move_pair(QuadMesh& mesh, const PairMove& move) {
  std::vector<Applied> log;
  OnMesh performer(mesh, log);
  PairMove back;
  const Refusal refusal = carry_and_frame(performer, move, back);
  performer.roll_back();
  return refusal;
}

PairMover::Moved PairMover::move(const PairMove& move) {
  Passage<OnMesh> passage(OnMesh(mesh_, log_), move.frame);
  const Carried result = carry(passage, move);
  if (passage.refused()) {
    passage.roll_back();
    return {passage.refusal(), VertexId(), VertexId(), 0};
  }
  return {Refusal::none, result.ends.p, result.ends.q, passage.operations()};
}

Refusal apply_all(QuadMesh& mesh, const std::vector<BasicOperation>& operations) {
  std::vector<BasicOperation> undo;
  for (const BasicOperation& op : operations) {
    const Applied done = apply(mesh, op);
    if (done.refusal != Refusal::none) {
      std::reverse(undo.begin(), undo.end());
      for (const BasicOperation& back : undo) apply(mesh, back);
      return done.refusal;
    }
    undo.push_back(done.inverse);
  }
  return Refusal::none;
}

}  // namespace requad::mesh
