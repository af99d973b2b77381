#include "mesh/pair_moves.hpp"

#include <algorithm>
#include <optional>
#include <unordered_set>
#include <utility>

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
  int a;
  int b;
};

// The extents after a step, by the table in the header.
Extents after(const QuadMesh& m, const PairMove& move) {
  const int l1 = m.valence(move.frame.v1);
  const int l2 = m.valence(move.frame.v2);
  if (move.frame.v1 != move.frame.v2 && l1 != l2) return {move.frame.a, move.frame.b};
  const int sign = l1 == 3 || l1 == 2 ? 1 : -1;
  switch (move.step) {
    case PairStep::slide_first: return {move.frame.a - sign, move.frame.b + sign};
    case PairStep::slide_second: return {move.frame.a + sign, move.frame.b - sign};
    case PairStep::open: return {move.frame.a - sign, move.frame.b - sign};
    case PairStep::close: return {move.frame.a + sign, move.frame.b + sign};
  }
  return {-1, -1};
}

// Basic operations in sequence, with the courier's place. After a refusal everything is a no-op until the roll-back.
class Passage {
 public:
  Passage(Editor& editor, const PairFrame& pair)
      : editor_(editor), m_(editor.mesh()), start_(editor.mark()), changed_{pair.v1, pair.v2} {}

  Refusal refusal() const { return refusal_; }
  bool refused() const { return refusal_ != Refusal::none; }
  void refuse(Refusal why) {
    if (!refused()) refusal_ = why;
  }

  // Places the courier: h runs from its v3 (or what plays it) to its v5.
  void start(HalfEdgeId h) { at_ = {h}; }
  VertexId v3() const { return at_.u(m_); }
  VertexId v5() const { return at_.v(m_); }

  void split(Hand hand, int times = 1, int turn = 2) { step({CourierStep::Way::split, hand}, times, turn); }
  void collapse(Hand hand, int times = 1) { step({CourierStep::Way::collapse, hand}, times); }
  void flip(Hand hand, int times = 1) { step({CourierStep::Way::flip, hand}, times); }

  // One operation, unless it is illegal, changes a valence on the boundary or that of an irregular vertex beside the pair.
  bool run(const BasicOperation& op) {
    if (refused()) return false;
    refuse(editor_.why_not(op));
    if (refused()) return false;
    const auto changed = changed_vertices(m_, op);
    for (const VertexId v : changed) {
      if (!v.valid()) continue;
      if (m_.is_boundary(v)) refuse(Refusal::touches_boundary);
      if (m_.face_valence(v) != 4 && changed_.count(v) == 0) refuse(Refusal::irregular_in_the_way);
    }
    if (refused()) return false;
    const Applied done = editor_.run(op);
    for (const VertexId v : changed) {
      if (v.valid()) changed_.insert(v);
    }
    if (op.kind == BasicOperation::Kind::split) changed_.insert(m_.origin(QuadMesh::opposite(done.made)));
    return true;
  }

  // All that changed, but for the pair itself, must be regular in the end.
  void require_regular_except(VertexId p, VertexId q) {
    for (const VertexId v : changed_) {
      if (m_.is_live(v) && v != p && v != q && m_.face_valence(v) != 4) refuse(Refusal::irregular_in_the_way);
    }
  }

  void roll_back() { editor_.roll_back(start_); }

  // What was done, in order.
  MoveReport report() const {
    MoveReport report;
    for (std::size_t i = start_; i < editor_.mark(); ++i) {
      const Edit& edit = editor_.edits()[i];
      const BasicOperation& op = edit.operation;
      report.operations.push_back(op);
      report.undo.push_back(edit.inverse);
      if (op.kind == BasicOperation::Kind::split) report.faces_made.push_back(QuadMesh::face(edit.inverse.h));
      if (op.kind == BasicOperation::Kind::collapse) report.faces_deleted.push_back(QuadMesh::face(op.h));
    }
    std::reverse(report.undo.begin(), report.undo.end());
    return report;
  }

 private:
  void step(CourierStep step, int times, int turn = 2) {
    for (int i = 0; i < times && !refused(); ++i) {
      // Both ends of the courier must be interior for a step to find its half-edges.
      if (!at_.edge.valid() || m_.is_boundary(v3()) || m_.is_boundary(v5())) {
        refuse(Refusal::touches_boundary);
        return;
      }
      const PlannedStep planned = plan(m_, at_, step, turn);
      if (run(planned.operation)) at_ = planned.next;
    }
  }

  Editor& editor_;
  const QuadMesh& m_;
  std::size_t start_;
  Refusal refusal_ = Refusal::none;
  CourierPlace at_;
  std::unordered_set<VertexId> changed_;  // what this move may find irregular: the pair, and what it changed itself
};

// The places of the pair after the move.
struct Ends {
  VertexId p;
  VertexId q;
};

// slide_first with the left hand, slide_second with the right. `forward` is p's extent along the leg of that hand.
Ends slide(const QuadMesh& m, Passage& passage, PairFrame frame, Hand hand) {
  const auto along = [hand](const PairFrame& f) { return hand == Hand::left ? f.a : f.b; };
  const auto is_v3 = [&m](VertexId v) { return m.valence(v) == 3; };
  // A v5 can not start by a collapse, which is all there is to do if the leg has no length: start at the other end.
  if (!is_v3(frame.v1) && is_v3(frame.v2) && along(frame) == 0) frame = seen_from_other_end(m, frame);
  const bool from_v3 = is_v3(frame.v1);
  const bool to_v3 = is_v3(frame.v2);
  const int forward = along(frame) - (from_v3 ? 1 : 0) + (to_v3 ? 0 : 1);
  const int sideways = hand == Hand::left ? frame.b : frame.a;

  if (from_v3) {
    passage.start(hand == Hand::left ? frame.first_leg : frame.second_leg);
  } else {
    const std::vector<HalfEdgeId> out = outward(m, frame);
    passage.start(m.twin(hand == Hand::left ? out.front() : out.back()));
  }
  const VertexId p = from_v3 ? passage.v5() : passage.v3();
  const int diagonal = std::min(forward, sideways);
  passage.split(hand, forward - diagonal);
  passage.flip(hand, diagonal);
  passage.collapse(hand, sideways - diagonal);
  return {p, to_v3 ? passage.v3() : passage.v5()};
}

// Splits only.
Ends open(const QuadMesh& m, Passage& passage, const PairFrame& frame) {
  if (m.valence(frame.v1) == 3) {
    if (frame.a == 1 && frame.b == 1) {
      // The path v1 - x - v2 turns, so the part of x on the inner side is left with valence 2: the merged vertex.
      const HalfEdgeId to_v2 = QuadMesh::next(frame.first_leg);
      passage.run({BasicOperation::Kind::split, to_v2, frame.first_leg, 0});
      const VertexId merged = m.origin(to_v2);
      return {merged, merged};
    }
    // The first split must be straight: take the longer leg first.
    const bool first = frame.a >= 2;
    passage.start(first ? frame.first_leg : frame.second_leg);
    const VertexId p = passage.v5();
    const Hand hand = first ? Hand::right : Hand::left;
    passage.split(hand, (first ? frame.a : frame.b) - 1);
    passage.split(other(hand), first ? frame.b : frame.a);
    return {p, passage.v3()};
  }
  // From a v5 the courier comes in by the middle outward separatrix; a merged pair has only that.
  const bool merged = frame.v1 == frame.v2;
  const bool to_v5 = m.valence(frame.v2) != 3;
  passage.start(m.twin(merged ? frame.first_leg : outward(m, frame)[1]));
  const VertexId p = passage.v3();
  passage.split(Hand::right, frame.a);
  passage.split(Hand::left, frame.b);
  // A v5 that the courier's v5 reached has valence 6; parted evenly it is regular, and the far end of the path is q.
  if (to_v5) passage.split(Hand::left, 1, 3);
  return {p, to_v5 ? passage.v5() : passage.v3()};
}

// Collapses only.
Ends close(const QuadMesh& m, Passage& passage, PairFrame frame) {
  if (frame.v1 == frame.v2) {
    const VertexId p = m.target(frame.first_leg);
    const VertexId q = m.origin(QuadMesh::previous(frame.first_leg));
    passage.run({BasicOperation::Kind::collapse, frame.first_leg, {}, 0});
    return {p, q};
  }
  if (m.valence(frame.v1) != 3 && m.valence(frame.v2) == 3) frame = seen_from_other_end(m, frame);
  if (m.valence(frame.v1) == 3) {
    const bool to_v3 = m.valence(frame.v2) == 3;
    passage.start(outward(m, frame).front());
    const VertexId p = passage.v5();
    // Past a v3 on its far side, onto a v5 directly.
    const bool right_first = to_v3 && frame.a >= 1;
    if (right_first) {
      passage.collapse(Hand::right, frame.b + 1);
      passage.collapse(Hand::left, frame.a);
    } else {
      passage.collapse(Hand::left, frame.a + (to_v3 ? 1 : 0));
      passage.collapse(Hand::right, frame.b);
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
  if (frame.a == 1 && frame.b == 1) return {p, p};
  passage.collapse(Hand::left, frame.a - 1);
  passage.collapse(Hand::right, frame.b - 1);
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
    const auto frame = frame_at(m, h, extents.a, extents.b);
    if (frame && frame->v2 == ends.q) found = frame;
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
      if (to.a >= 0 && to.b >= 0) moves.push_back(move);
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

MoveReport move_pair(Editor& editor, const PairMove& move) {
  const QuadMesh& m = editor.mesh();
  MoveReport refused;
  const PairFrame& frame = move.frame;
  const Extents to = after(m, move);
  const bool merged = frame.v1 == frame.v2;
  const bool parts = merged && move.step == (m.valence(frame.v1) == 2 ? PairStep::close : PairStep::open);
  if (to.a < 0 || to.b < 0 || (merged && !parts)) {
    refused.refusal = Refusal::no_such_step;
    return refused;
  }
  Passage passage(editor, frame);
  Ends ends{};
  switch (move.step) {
    case PairStep::slide_first: ends = slide(m, passage, frame, Hand::left); break;
    case PairStep::slide_second: ends = slide(m, passage, frame, Hand::right); break;
    case PairStep::open: ends = open(m, passage, frame); break;
    case PairStep::close: ends = close(m, passage, frame); break;
  }
  if (!passage.refused()) passage.require_regular_except(ends.p, ends.q);
  std::optional<PairFrame> found;
  if (!passage.refused()) {
    // Where a 3-5 move started at the v3, p is the v3; frames have the v5 first.
    if (m.valence(ends.p) < m.valence(ends.q)) std::swap(ends.p, ends.q);
    // The edge to v1 parts a v6 as it was; either face of a v2 does.
    const VertexId towards = m.valence(ends.p) == 6 ? frame.v1 : VertexId();
    found = frame_after(m, ends, to, towards);
    if (!found) passage.refuse(Refusal::irregular_in_the_way);
  }
  if (passage.refused()) {
    passage.roll_back();
    refused.refusal = passage.refusal();
    return refused;
  }
  MoveReport report = passage.report();
  report.inverse = {*found, inverse(move.step)};
  return report;
}

MoveReport move_pair(QuadMesh& mesh, const PairMove& move) {
  Editor editor(mesh);
  return move_pair(editor, move);
}

Refusal why_not_move_pair(const QuadMesh& mesh, const PairMove& move) {
  QuadMesh copy = mesh;
  return move_pair(copy, move).refusal;
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
