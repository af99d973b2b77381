// The transport of an adjacent 3-5 pair (sections 5 and 6).
//
// An irregular vertex that moves by one edge leaves an adjacent 3-5 pair behind. This pair can be transported to any
// other irregular vertex. There it is absorbed, and that vertex moves by an edge too. So every operation of the paper
// on two or more irregular vertices is a sequence of such transports.
//
// An adjacent pair is written u -> v, from its v3 to its v5. More generally, u -> v means that u has one edge fewer,
// and v one edge more, than it would have without the pair, whatever that valence is. This covers both ends of a transport:
//   sent from a v3 at u      u -> v, where v is regular. Without the pair, the v3 would be at v.
//   sent from a v5 at v      u -> v, where u is regular. Without the pair, the v5 would be at u.
//   absorbed by a v3 at v    v becomes regular, and u is the v3. (A v2 becomes a v3 beside another.)
//   absorbed by a v5 at u    u becomes regular, and v is the v5. (A v6 becomes a v5 beside another, and so on.)
//   absorbed by a v5 at v    v becomes a v6, which the next split parts evenly. The far end of its path is the v5.
//   absorbed by a v3 at u    u becomes a v2, which the next collapse takes in. The face's last corner is the v3.
// An adjacent 3-5 pair of the mesh is such a pair itself: absorbed by a third vertex, it is cancelled (section 8).
//
// The six steps (Figure 3), seen from u to v: on either hand one collapse, one flip and one split.
//
//      d --- c --- y        collapse  u onto c; the pair is then d -> c
//      |  L  |     |        flip      the edge v-c to u-y; the pair is then c -> y
//      u --> v --- x        split     v along u - v - z, where v-z is the second edge of v from v-u on that hand; the
//                                     pair is then (the part of v on that hand) -> z
//
// Law irregular-1. A step raises the valence of u by one and lowers that of v by one, back to what they are without the
//         pair. It lowers the valence of the next u by one and raises that of the next v by one. It changes no other
//         valence. For a collapse this needs l(u) = 3.
// Law irregular-2. So a transport over regular vertices leaves nothing but regular vertices behind.
//
// On features and boundaries, "regular" means that a sector has as many quads as it should, and a v3 or v5 is a sector
// with one quad less or more (sectors.hpp). So a vertex that a feature holds can send and absorb pairs too, and keeps
// its place and its id. An adjacent pair on a cut edge lies on one side of it.
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

// A step, as the operation that makes it on the mesh as it is before.
struct PlannedStep {
  BasicOperation operation;
  VertexId next_u;  // none for a split, which makes it
  VertexId next_v;
  // Half-edges out of next_u and next_v before the operation, in the sectors that it changes; none where there is no
  // such vertex.
  HalfEdgeId at_u;
  HalfEdgeId at_v;
  AdjacentPair next;  // after the operation
  // A collapse lays two edges on one, `first` and another. If the first one is a cut edge, the pair is then not at
  // `next` but at `beside`, in the patch beyond the second one.
  HalfEdgeId first;
  AdjacentPair beside;
};
// Plans a step. `turn` counts the edges of v from u on that hand to z (split only; 1 <= turn < l(v)). Where the
// boundary cuts off what the step needs, its operation has no half-edge and is illegal. Precondition: the pair has a
// face on the step's hand.
PlannedStep plan(const QuadMesh& mesh, AdjacentPair pair, TransportStep step, int turn = 2);
// The same step with the other choice of the vertex that keeps its id: in a collapse c in place of u, in a split the
// other part of v. The two meshes differ by names only.
PlannedStep renamed(const QuadMesh& mesh, const PlannedStep& step);

// What kept a pair from going on where it might have gone on.
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
  Obstacles obstacles;              // that the search met, whether the transport was refused or not
  AdjacentPair pair;                // where it was absorbed; its u or v is the vertex that moved
  VertexId absorbed_by;             // that vertex before it moved; its id still exists
  int steps = 0;
  std::int64_t states = 0;  // how many positions of the pair were looked at
};

// Transports adjacent pairs by shortest paths over regular vertices, round features, boundaries and irregular vertices
// (Figure 7). Among paths of one length it prefers one that ends in a 3-3-5-5 removal. It looks ahead on the mesh
// itself, by best-first search over sequences of checked steps, and takes back what it does not choose. It keeps its
// working memory from one transport to the next.
//
// Costs: the number of states visited times the distance between consecutive ones. This is close to the length of the
// path where nothing is in the way. Only the memory grows with the mesh: two integers for each vertex.
class PairTransport {
 public:
  explicit PairTransport(Editor& editor) : editor_(editor) {}

  // Transports the pair from `start` until one of the targets absorbs it. Of the fixed vertices it changes those that
  // the editor's sector plan allows, of the irregular ones only the targets; it may cross one of these. On refusal the
  // mesh is as before.
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
  std::unordered_set<std::int64_t> seen_;  // positions already queued
};

}  // namespace requad::mesh
