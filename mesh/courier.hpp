// The courier: an adjacent 3-5 pair on its way (sections 5 and 6).
//
// The smallest piece of an edit that does not stay where it is made. Moving an irregular vertex by one edge leaves an
// adjacent 3-5 pair behind; it can travel to any other irregular vertex and be absorbed there, which moves that one by
// an edge too. So every operation of the paper on two or more irregular vertices is couriers sent from one to another.
//
// A courier is written as the half-edge from its v3 to its v5. More generally the courier u -> v stands for "u has one
// edge less, v one more than without it", whatever valences they have without it. That includes both ends of a journey:
//   sent from a v3 at u      u -> v where v is regular: without the courier, the v3 would be at v
//   sent from a v5 at v      u -> v where u is regular: without the courier, the v5 would be at u
//   absorbed by a v3 at v    v becomes regular and u the v3;  a v2 becomes a v3 beside another
//   absorbed by a v5 at u    u becomes regular and v the v5;  a v6 becomes a v5 beside another, and so on
//   a v5 at v becomes a v6, which the next split parts evenly: the far end of the split's path is then the v5
//   a v3 at u becomes a v2, which the next collapse takes in: the face's last corner is then the v3
// An adjacent 3-5 pair is itself a courier: absorbed by a third vertex, it is cancelled (section 8).
//
// The six steps (Figure 3), seen from u to v: on either hand one collapse, one flip, one split.
//
//      d --- c --- y        collapse  u onto c; the courier is then d -> c
//      |  L  |     |        flip      the edge v-c to u-y; the courier is then c -> y
//      u --> v --- x        split     v along u - v - z, z the second edge from v3 on that hand; the courier is then
//                                     (the part of v on that hand) -> z
//
// Law C1. A step raises the valence of u by one and lowers that of v by one (back to what they are without the
// courier),
//         lowers that of the next u by one and raises that of the next v by one, and changes no other. A collapse needs
//         l(u) = 3 for that.
// Law C2. So a journey over regular vertices leaves nothing but regular vertices behind.
#pragma once

#include <array>
#include <cstdint>
#include <queue>
#include <span>
#include <unordered_set>
#include <vector>

#include "mesh/editor.hpp"
#include "mesh/surroundings.hpp"

namespace requad::mesh {

enum class Hand { left, right };
inline Hand other(Hand hand) { return hand == Hand::left ? Hand::right : Hand::left; }

struct CourierStep {
  enum class Way { collapse, flip, split };
  Way way = Way::collapse;
  Hand hand = Hand::left;
};
inline constexpr std::array<CourierStep, 6> kCourierSteps{{{CourierStep::Way::collapse, Hand::left},
                                                           {CourierStep::Way::collapse, Hand::right},
                                                           {CourierStep::Way::flip, Hand::left},
                                                           {CourierStep::Way::flip, Hand::right},
                                                           {CourierStep::Way::split, Hand::left},
                                                           {CourierStep::Way::split, Hand::right}}};
const char* name(CourierStep::Way way);  // "collapse", ...

// A step as the operation that makes it, on the mesh as it is before.
struct PlannedStep {
  BasicOperation operation;
  VertexId next_u;  // none for a split, which makes it
  VertexId next_v;
  HalfEdgeId edge;        // after the operation, the courier is this half-edge,
  bool reversed = false;  // or its twin

  HalfEdgeId courier(const QuadMesh& after) const { return reversed ? after.twin(edge) : edge; }
};
// Precondition: both ends of the courier are interior. `turn` counts edges of v from u on the step's hand to z (split
// only; 1 <= turn < l(v)).
PlannedStep plan(const QuadMesh& mesh, HalfEdgeId courier, CourierStep step, int turn = 2);
// The same step with the other choice of the vertex that keeps its id: in a collapse c in place of u, in a split the
// other part of v. The meshes differ by names only.
PlannedStep renamed(const QuadMesh& mesh, const PlannedStep& step);

struct Transport {
  Refusal refusal = Refusal::none;  // no_way: there is no path, or none within the limit
  HalfEdgeId courier;               // where it was absorbed; u or v of it is the vertex that moved
  VertexId absorbed_by;             // that vertex, before it moved; its id still exists
  int steps = 0;
  std::int64_t states = 0;  // places of the courier that were looked at
};

// Carries couriers by shortest paths over regular vertices, round features, boundaries and irregular vertices
// (Figure 7). It looks ahead on the mesh itself, by best-first search over sequences of steps, each of them checked;
// what it does not choose is taken back. It keeps its working memory from one journey to the next.
//
// Costs: states visited times the distance between consecutive ones; close to the length of the path where nothing is
// in the way. Nothing grows with the mesh, but the memory: two integers for each vertex.
class Courier {
 public:
  explicit Courier(Editor& editor) : editor_(editor) {}

  // Carries the courier from `start` until one of the targets absorbs it. Never changes the valence of a fixed vertex,
  // nor that of any irregular vertex but the targets, one of which it may cross. On refusal the mesh is as before.
  Transport carry(HalfEdgeId start, std::span<const VertexId> targets, bool may_cross = true,
                  std::int64_t most_states = 4000);

 private:
  struct Node {
    int parent = -1;
    int depth = 0;
    int crossings = 0;  // targets crossed on the way, at most one
    bool absorbed = false;
    VertexId absorbed_by;
    PlannedStep step;
  };
  struct Open {
    int estimate;
    int depth;
    int node;
    bool operator<(const Open& o) const {  // for a heap: the least estimate, then the deepest, then the first made
      if (estimate != o.estimate) return estimate > o.estimate;
      return depth != o.depth ? depth < o.depth : node > o.node;
    }
  };

  void measure_distances(std::span<const VertexId> targets, HalfEdgeId start);
  int distance(VertexId v) const;  // to the nearest target, at most farthest_ + 1
  void go_to(int node, std::size_t base);
  void expand(int node, HalfEdgeId courier, std::span<const VertexId> targets);

  Editor& editor_;
  std::vector<Node> nodes_;
  std::vector<int> path_;  // nodes performed on the mesh now, in order
  std::priority_queue<Open> open_;
  int most_crossings_ = 0;
  Surroundings surroundings_;  // of the targets
  int farthest_ = 0;
  std::unordered_set<std::int64_t> seen_;  // places already queued
};

}  // namespace requad::mesh
