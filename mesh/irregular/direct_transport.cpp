#include "mesh/irregular/direct_transport.hpp"

#include <algorithm>

#include "mesh/irregular/edit_refusal.hpp"
#include "mesh/irregular/transport_step.hpp"
#include "mesh/topology/separatrix.hpp"

namespace requad::mesh {

DirectTransport::DirectTransport(OperationLog& log, const PairFrame& pair) : log_(log), m_(log.mesh()) {
  keep(pair.v1);
  keep(pair.v2);
}

void DirectTransport::start(HalfEdgeId h, VertexId moved) {
  pair_ = {h};
  moved_ = moved;
  for (const VertexId v : {v3(), v5()}) {
    if (m_.is_boundary(v)) refuse(EditRefusal::touches_boundary);
    if (m_.face_valence(v) != 4 && !is_kept(v)) refuse(EditRefusal::irregular_in_the_way);
  }
}

void DirectTransport::split(Hand hand, int times, int turn) { steps<TransportStep::Kind::split>(hand, times, turn); }
void DirectTransport::collapse(Hand hand, int times) { steps<TransportStep::Kind::collapse>(hand, times, 2); }
void DirectTransport::flip(Hand hand, int times) { steps<TransportStep::Kind::flip>(hand, times, 2); }

void DirectTransport::run(const BasicOperation& op) {
  if (refused()) return;
  refuse(why_not(m_, op));
  if (refused()) return;
  const auto changed = changed_vertices(m_, op);
  for (const VertexId v : changed) {
    if (!v.valid()) continue;
    if (m_.is_boundary(v)) refuse(EditRefusal::touches_boundary);
    if (m_.face_valence(v) != 4 && !is_kept(v)) refuse(EditRefusal::irregular_in_the_way);
  }
  if (!refused()) perform_first(op, changed);
}

void DirectTransport::require_regular_except(VertexId p, VertexId q) {
  keep(last_u_);
  keep(last_v_);
  if (pair_.edge.valid()) keep(v3()), keep(v5());
  for (int i = 0; i < kept_count_; ++i) {
    const VertexId v = kept_[static_cast<std::size_t>(i)];
    if (m_.is_live(v) && v != p && v != q && m_.face_valence(v) != 4) refuse(EditRefusal::irregular_in_the_way);
  }
}

void DirectTransport::keep(VertexId v) {
  if (v.valid() && !is_kept(v)) kept_[static_cast<std::size_t>(kept_count_++)] = v;
}

bool DirectTransport::is_kept(VertexId v) const {
  for (int i = 0; i < kept_count_; ++i) {
    if (kept_[static_cast<std::size_t>(i)] == v) return true;
  }
  return false;
}

// Whether the adjacent pair may land on origin(h): a regular vertex, or one that may be irregular for now.
bool DirectTransport::can_land(HalfEdgeId h) {
  if (!h.valid()) {
    refuse(EditRefusal::touches_boundary);
  } else if (!leaves_regular_vertex(m_, h)) {
    const VertexId v = m_.origin(h);
    if (m_.is_boundary(v)) {
      refuse(EditRefusal::touches_boundary);
    } else if (!is_kept(v) && v != v3() && v != v5()) {
      refuse(EditRefusal::irregular_in_the_way);
    }
  }
  return !refused();
}

// The loop is compiled for each kind and hand, so that the plan is a few loads.
template <TransportStep::Kind kind, Hand hand>
void DirectTransport::steps_on(int times, int turn) {
  constexpr bool kSplits = kind == TransportStep::Kind::split;
  for (int i = 0; i < times && !refused(); ++i) {
    const PlannedStep planned = planned_step(m_, pair_, {kind, hand}, turn);
    if ((!kSplits && !can_land(planned.at_u)) || !can_land(planned.at_v)) return;
    if (first_) {
      const auto changed = why_not(m_, planned.operation) == Refusal::none ? changed_vertices(m_, planned.operation)
                                                                           : std::array<VertexId, 4>{};
      if (!perform_first(planned.operation, changed)) return;
    } else {
      last_u_ = v3();
      last_v_ = v5();
      if (!perform(planned.operation)) return;
    }
    pair_ = planned.next;
  }
}

template <TransportStep::Kind kind>
void DirectTransport::steps(Hand hand, int times, int turn) {
  if (hand == Hand::left) {
    steps_on<kind, Hand::left>(times, turn);
  } else {
    steps_on<kind, Hand::right>(times, turn);
  }
}

// What is known by its id must not outlive it: ids are used again.
void DirectTransport::rename(VertexId removed, VertexId merged_into) {
  if (moved_ == removed) moved_ = merged_into;
  std::replace(kept_.begin(), kept_.begin() + kept_count_, removed, merged_into);
}

bool DirectTransport::perform(const BasicOperation& op) {
  const bool collapses = op.kind == BasicOperation::Kind::collapse && op.h.valid();
  const VertexId kept = collapses ? m_.origin(op.h) : VertexId();
  const VertexId removed = collapses ? m_.origin(QuadMesh::opposite(op.h)) : VertexId();
  const Applied done = log_.run(op);
  refuse(done.refusal);
  if (refused()) return false;
  if (collapses) rename(removed, kept);
  first_ = false;
  made_ = done.made;
  return true;
}

bool DirectTransport::perform_first(const BasicOperation& op, const std::array<VertexId, 4>& changed) {
  for (const VertexId v : changed) keep(v);
  if (!perform(op)) return false;
  if (op.kind == BasicOperation::Kind::split) keep(m_.origin(QuadMesh::opposite(made_)));
  return true;
}

}  // namespace requad::mesh
