// The courier: an adjacent 3-5 pair on its way (sections 5 and 6).
//
// The smallest piece of an edit that does not stay where it is made. Moving an irregular vertex by one edge leaves an
// adjacent 3-5 pair behind; it can travel to any other irregular vertex and be absorbed there, which moves that one by
// an edge too. So every operation of the paper on two or more irregular vertices is couriers sent from one to another.
//
// A courier is written as the half-edge from its v3 to its v5. More generally the courier u -> v stands for "u has one
// edge less, v one more than without it", whatever valences they have without it. That includes both ends of a report:
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
// Law C2. So a report over regular vertices leaves nothing but regular vertices behind.
//
// On features and boundaries "regular" means as many quads as the sector should have, and a v3 or v5 is a sector with
// one less or one more (sectors.hpp): so a vertex that a feature holds can send and take couriers too, and keeps its
// place and its id. A courier on a cut edge is on one side of it.
#pragma once

#include <array>
#include <cstdint>
#include <queue>
#include <span>
#include <string>
#include <tuple>
#include <unordered_set>
#include <vector>

#include "mesh/editing/editor.hpp"
#include "mesh/irregular/edit_refusal.hpp"
#include "mesh/topology/distances.hpp"

namespace requad::mesh {

enum class Hand { left, right };
inline Hand other(Hand hand) { return hand == Hand::left ? Hand::right : Hand::left; }

struct TransportStep {
  enum class Kind { collapse, flip, split };
  Kind kind = Kind::collapse;
  Hand hand = Hand::left;
};
inline constexpr std::array<TransportStep, 6> kTransportSteps{{{TransportStep::Kind::collapse, Hand::left},
                                                               {TransportStep::Kind::collapse, Hand::right},
                                                               {TransportStep::Kind::flip, Hand::left},
                                                               {TransportStep::Kind::flip, Hand::right},
                                                               {TransportStep::Kind::split, Hand::left},
                                                               {TransportStep::Kind::split, Hand::right}}};
const char* name(TransportStep::Kind kind);  // "collapse", ...

// Where a courier is: on an edge, and in the patch of one of the edge's faces. It runs along `edge` or against it.
struct AdjacentPair {
  HalfEdgeId edge;
  bool against = false;

  // Half-edges out of u and v in the courier's patch.
  HalfEdgeId at_u() const { return against ? QuadMesh::next(edge) : edge; }
  HalfEdgeId at_v() const { return against ? edge : QuadMesh::next(edge); }
  VertexId u(const QuadMesh& mesh) const { return mesh.origin(at_u()); }
  VertexId v(const QuadMesh& mesh) const { return mesh.origin(at_v()); }
  // The half-edges u -> v, with the face on the left hand, and v -> u; none beyond the boundary.
  HalfEdgeId forth(const QuadMesh& mesh) const { return against ? mesh.twin(edge) : edge; }
  HalfEdgeId back(const QuadMesh& mesh) const { return against ? edge : mesh.twin(edge); }
};

// A step as the operation that makes it, on the mesh as it is before.
struct PlannedStep {
  BasicOperation operation;
  VertexId next_u;  // none for a split, which makes it
  VertexId next_v;
  // Half-edges out of them before the operation, in the sectors that it changes; none where there is no such vertex.
  HalfEdgeId at_u;
  HalfEdgeId at_v;
  AdjacentPair next;  // after the operation
  // Of a collapse, which lays two edges on one: whether `next` is in the patch beyond the first depends on whether that
  // is a cut edge. If it is, the courier's place is `beside`, in the patch beyond the second edge.
  HalfEdgeId first;
  AdjacentPair beside;
};
// Precondition: the courier's face on the step's hand exists. `turn` counts edges of v from u on that hand to z (split
// only; 1 <= turn < l(v)). Where the boundary cuts off what the step needs, its operation has no half-edge and is
// illegal.
PlannedStep plan(const QuadMesh& mesh, AdjacentPair pair, TransportStep step, int turn = 2);
// The same step with the other choice of the vertex that keeps its id: in a collapse c in place of u, in a split the
// other part of v. The meshes differ by names only.
PlannedStep renamed(const QuadMesh& mesh, const PlannedStep& step);

// What kept couriers from places where they might have gone on.
struct Obstacles {
  bool features = false;
  bool boundary = false;
  bool irregular = false;  // irregular vertices that are no targets
  bool limit = false;      // the search was cut off

  Obstacles& operator|=(const Obstacles& o);
};
// "features, the boundary"; "" if there are none.
std::string to_string(const Obstacles& obstacles);

struct TransportReport {
  Refusal refusal = Refusal::none;  // no_way: there is no path, or none within the limit
  Obstacles obstacles;              // met on the search, whether it was refused or not
  AdjacentPair pair;                // where it was absorbed; u or v of it is the vertex that moved
  VertexId absorbed_by;             // that vertex, before it moved; its id still exists
  int steps = 0;
  std::int64_t states = 0;  // places of the courier that were looked at
};

// Carries couriers by shortest paths over regular vertices, round features, boundaries and irregular vertices
// (Figure 7); of paths of one length it takes one that ends in a 3-3-5-5 removal. It looks ahead on the mesh itself, by
// best-first search over sequences of steps, each of them checked; what it does not choose is taken back. It keeps its
// working memory from one report to the next.
//
// Costs: states visited times the distance between consecutive ones; close to the length of the path where nothing is
// in the way. Nothing grows with the mesh, but the memory: two integers for each vertex.
class PairTransport {
 public:
  explicit PairTransport(Editor& editor) : editor_(editor) {}

  // Carries the courier from `start` until one of the targets absorbs it. Changes no fixed vertex but as the editor's
  // sector plan allows, nor any irregular vertex but the targets, one of which it may cross. On refusal the mesh is as
  // before.
  TransportReport carry(AdjacentPair start, std::span<const VertexId> targets, bool may_cross = true,
                        std::int64_t most_states = 4000);

 private:
  struct Node {
    int parent = -1;
    int depth = 0;
    int crossings = 0;  // targets crossed on the way, at most one
    int absorbed = 0;   // by how many targets: two at a 3-3-5-5 removal
    VertexId absorbed_by;
    PlannedStep step;
  };
  struct Open {
    int estimate;
    int absorbed;
    int depth;
    int node;
    // For a heap: the least estimate; then what most targets absorb, the deepest, the first made.
    bool operator<(const Open& o) const {
      return std::tuple(-estimate, absorbed, depth, -node) < std::tuple(-o.estimate, o.absorbed, o.depth, -o.node);
    }
  };

  void measure_distances(std::span<const VertexId> targets, AdjacentPair start);
  int distance(VertexId v) const;  // to the nearest target, at most farthest_ + 1
  void go_to(int node, std::size_t base);
  void expand(int node, AdjacentPair pair, std::span<const VertexId> targets, Obstacles& obstacles);

  Editor& editor_;
  std::vector<Node> nodes_;
  std::vector<int> path_;  // nodes performed on the mesh now, in order
  std::priority_queue<Open> open_;
  int most_crossings_ = 0;
  BreadthFirstDistances distances_;  // of the targets
  std::vector<VertexId> sources_;    // of the distances
  int farthest_ = 0;
  std::unordered_set<std::int64_t> seen_;  // places already queued
};

}  // namespace requad::mesh
