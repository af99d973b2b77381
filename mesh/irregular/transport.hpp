// The transport of an adjacent 3-5 pair (sections 5 and 6).
//
// An irregular vertex that moves by one edge leaves an adjacent 3-5 pair behind. This pair can be transported to any
// other irregular vertex. There it is absorbed, and that vertex moves by an edge too. So every operation of the paper
// on two or more irregular vertices is a sequence of such transports.
//
// An adjacent pair is written u -> v, from its v3 to its v5. More generally, u and v may have any valences: u has one
// edge fewer than without the pair, and v has one edge more. This also covers the two ends of a transport:
//   sent from a v3 at u      u -> v, where v is regular. Without the pair, the v3 would be at v.
//   sent from a v5 at v      u -> v, where u is regular. Without the pair, the v5 would be at u.
//   absorbed by a v3 at v    v becomes regular, and u is the v3. (A v2 becomes a v3 beside another.)
//   absorbed by a v5 at u    u becomes regular, and v is the v5. (A v6 becomes a v5 beside another, and so on.)
//   absorbed by a v5 at v    v becomes a v6, which the next split parts evenly. The far end of its path is the v5.
//   absorbed by a v3 at u    u becomes a v2, which the next collapse takes in. The face's last corner is the v3.
// An adjacent 3-5 pair that the mesh has from the start is such a pair, too. A third vertex that absorbs it cancels it
// (section 8).
//
// The six steps (Figure 3), seen from u to v. There are a collapse, a flip and a split on the left hand, and the same
// on the right hand.
//
//      d --- c --- y        collapse  u onto c; the pair is then d -> c
//      |  L  |     |        flip      the edge v-c to u-y; the pair is then c -> y
//      u --> v --- x        split     v along u - v - z, where v-z is the second edge of v from v-u on that hand; the
//                                     pair is then (the part of v on that hand) -> z
//
// Law irregular-1. A step raises the valence of u by one and lowers that of v by one: both then have the valences that
//         they would have without the pair. It lowers the valence of the next u by one and raises that of the next v by
//         one. It changes no other valence. For a collapse this law requires l(u) = 3.
// Law irregular-2. It follows that a transport over regular vertices leaves only regular vertices behind.
//
// On features and boundaries, a sector takes the place of a vertex (sectors.hpp). A sector is regular if it has as many
// quads as it should. A sector with one quad less is a v3, and one with one quad more is a v5. So a vertex on a feature
// can send and absorb pairs, too, and it keeps its position and its id. An adjacent pair on a cut edge lies on one side
// of that edge.
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

// An adjacent pair: it lies on an edge, in the patch of one of the edge's faces, and runs along `edge` or against it.
struct AdjacentPair {
  HalfEdgeId edge;
  bool against = false;

  // Half-edges out of u and v in the pair's patch.
  HalfEdgeId at_u() const { return against ? QuadMesh::next(edge) : edge; }
  HalfEdgeId at_v() const { return against ? edge : QuadMesh::next(edge); }
  VertexId u(const QuadMesh& mesh) const { return mesh.origin(at_u()); }
  VertexId v(const QuadMesh& mesh) const { return mesh.origin(at_v()); }
  // The half-edges u -> v, with the face on the left hand, and v -> u; none beyond the boundary.
  HalfEdgeId forth(const QuadMesh& mesh) const { return against ? mesh.twin(edge) : edge; }
  HalfEdgeId back(const QuadMesh& mesh) const { return against ? edge : mesh.twin(edge); }
};

// A step, and the basic operation that makes it on the present mesh.
struct PlannedStep {
  BasicOperation operation;
  VertexId next_u;  // none for a split, which makes it
  VertexId next_v;
  // Half-edges out of next_u and next_v before the operation, in the sectors that it changes. None if the vertex does
  // not exist yet.
  HalfEdgeId at_u;
  HalfEdgeId at_v;
  AdjacentPair next;  // after the operation
  // A collapse joins two edges to one: `first` and a second one. If `first` is a cut edge, the pair is not at `next`
  // afterwards but at `beside`, in the patch beyond the second edge.
  HalfEdgeId first;
  AdjacentPair beside;
};
// Plans a step. `turn` is for a split only: it counts the edges of v from u to z on that hand (1 <= turn < l(v)). If
// the boundary leaves no room for the step, its operation has no half-edge and is illegal. Precondition: the pair has a
// face on the step's hand.
PlannedStep plan(const QuadMesh& mesh, AdjacentPair pair, TransportStep step, int turn = 2);
// The same step, but another vertex keeps its id. In a collapse this is c in place of u; in a split it is the other
// part of v. The two resulting meshes differ only in the ids.
PlannedStep renamed(const QuadMesh& mesh, const PlannedStep& step);

// The edges along which an adjacent pair can leave v, each as the half-edge from the pair's v3 to its v5. Precondition:
// v is interior and irregular.
std::vector<HalfEdgeId> departures(const QuadMesh& mesh, VertexId v);

// What stood in the way of a pair.
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
  Refusal refusal = Refusal::none;  // no_path: there is no path, or none within the limit
  Obstacles obstacles;              // those that the search met, even if the transport was not refused
  AdjacentPair pair;                // the pair where it was absorbed; its u or v is the vertex that moved
  VertexId absorbed_by;             // that vertex before it moved; its id still exists
  int steps = 0;
  std::int64_t states = 0;  // the number of positions of the pair that the search visited
};

// Transports adjacent pairs by shortest paths over regular vertices, round features, boundaries and irregular vertices
// (Figure 7). Among paths of one length it prefers one that ends in a 3-3-5-5 removal. It makes a best-first search
// over sequences of checked steps, performs them on the mesh itself, and rolls back those that it does not choose. It
// keeps its working memory from one transport to the next.
//
// Costs: the number of states visited times the distance between consecutive ones. If nothing is in the way, this is
// about the length of the path. Only the memory grows with the mesh: it has two integers for each vertex.
class PairTransport {
 public:
  // A transport that has visited most_states positions ends without a path.
  explicit PairTransport(Editor& editor, std::int64_t most_states = 4000)
      : editor_(editor), most_states_(most_states) {}

  // Transports the pair from `start` until one of the targets absorbs it. The transport changes a fixed vertex only if
  // the editor's sector plan allows this, and an irregular vertex only if it is a target. If `may_cross` is true, the
  // pair may cross one target on its way. After a refusal the mesh is as before.
  TransportReport carry(AdjacentPair start, std::span<const VertexId> targets, bool may_cross = true);

 private:
  struct Node {
    int parent = -1;
    int depth = 0;
    int crossings = 0;  // targets crossed on the way, at most one
    int absorbed = 0;   // the number of targets that absorb the pair: two at a 3-3-5-5 removal
    VertexId absorbed_by;
    PlannedStep step;
  };
  struct Open {
    int estimate;
    int absorbed;
    int depth;
    int node;
    // The top of the heap has the least estimate. Of equal ones it has the most targets, then the greatest depth, then
    // the lowest number.
    bool operator<(const Open& o) const {
      return std::tuple(-estimate, absorbed, depth, -node) < std::tuple(-o.estimate, o.absorbed, o.depth, -o.node);
    }
  };

  void measure_distances(std::span<const VertexId> targets, AdjacentPair start);
  int distance(VertexId v) const;  // to the nearest target, at most farthest_ + 1
  void go_to(int node, std::size_t base);
  void expand(int node, AdjacentPair pair, std::span<const VertexId> targets, Obstacles& obstacles);

  Editor& editor_;
  std::int64_t most_states_;
  std::vector<Node> nodes_;
  std::vector<int> path_;  // nodes performed on the mesh now, in order
  std::priority_queue<Open> open_;
  int most_crossings_ = 0;
  BreadthFirstDistances distances_;  // of the targets
  std::vector<VertexId> sources_;    // of the distances
  int farthest_ = 0;
  std::unordered_set<std::int64_t> seen_;  // positions already queued
};

}  // namespace requad::mesh
