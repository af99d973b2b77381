// The transport of an adjacent 3-5 pair by given steps, as pair moves need it. (The transport in transport.hpp searches
// for a path.)
//
// Internal to pair_moves.cpp: not installed.
#pragma once

#include <array>

#include "mesh/editing/operation_log.hpp"
#include "mesh/irregular/pair_frame.hpp"
#include "mesh/irregular/transport.hpp"

namespace requad::mesh {

// Performs basic operations in sequence and knows where the adjacent pair is. After a refusal nothing more is done; the
// caller rolls the log back.
//
// On the way, only the pair that moves, the vertices that the first operation changes, and the adjacent pair may be
// irregular. Any other vertex that a step changes is regular before the adjacent pair comes and after it has left (Law
// irregular-1 in transport.hpp). So these are the only vertices to remember, and to check in the end.
class DirectTransport {
 public:
  DirectTransport(OperationLog& log, const PairFrame& pair);

  const QuadMesh& mesh() const { return m_; }
  Refusal refusal() const { return refusal_; }
  bool refused() const { return refusal_ != Refusal::none; }
  // Keeps the first reason.
  void refuse(Refusal why) {
    if (!refused()) refusal_ = why;
  }

  // Begins with the adjacent pair on h, which runs from its v3 (or from the vertex in that role) to its v5. `moved` is
  // the end of the pair that the first operation moved: the v3 or the v5 that stays behind when the adjacent pair leaves.
  void start(HalfEdgeId h, VertexId moved);
  // That vertex as it is now. On a closed surface a later collapse can merge it with another one, whose id it then has.
  VertexId moved() const { return moved_; }
  VertexId v3() const { return pair_.u(m_); }
  VertexId v5() const { return pair_.v(m_); }

  // Makes this many steps of one kind on one hand. A split continues along the `turn`-th edge of the v5.
  void split(Hand hand, int times = 1, int turn = 2);
  void collapse(Hand hand, int times = 1);
  void flip(Hand hand, int times = 1);
  // Performs a first operation that is no step of an adjacent pair. Refused if it changes a valence on the boundary, or
  // that of an irregular vertex other than the pair.
  void run(const BasicOperation& op);

  // Refuses unless all that changed is regular, but for the pair itself.
  void require_regular_except(VertexId p, VertexId q);

 private:
  void keep(VertexId v);
  void rename(VertexId removed, VertexId merged_into);
  bool is_kept(VertexId v) const;
  bool can_land(HalfEdgeId h);
  template <TransportStep::Kind kind>
  void steps(Hand hand, int times, int turn);
  template <TransportStep::Kind kind, Hand hand>
  void steps_on(int times, int turn);
  bool perform(const BasicOperation& op);
  bool perform_first(const BasicOperation& op, const std::array<VertexId, 4>& changed);

  OperationLog& log_;
  const QuadMesh& m_;
  Refusal refusal_ = Refusal::none;
  AdjacentPair pair_;
  VertexId moved_;
  bool first_ = true;              // no operation was performed yet
  HalfEdgeId made_;                // by the last operation
  VertexId last_u_, last_v_;       // the adjacent pair before the last step
  std::array<VertexId, 16> kept_;  // vertices that may be irregular for now
  int kept_count_ = 0;
};

}  // namespace requad::mesh
