// The atomic semantic operations of section 5, by name, each with its inverse.
//
// Each of them is one basic operation with a meaning: it says what becomes of an irregular vertex or of a pair. All of
// them are steps of an adjacent pair u -> v (transport.hpp). They are told apart by the valences that the step finds.
// Let u' and v' be the pair after the step, and c the corner of the face opposite u. The step adds (+1, -1, -1, +1) to
// the valences of u, v, u', v'. A collapse merges u, a v3, into c = v'; a split makes u' as a v3 out of v.
//
//   name           u v u' v'  becomes   by                     inverse        in the paper
//   move-35        3 5 4 4    4 4 3 5   collapse flip split    move-35        Figure 3: six directions
//   move-v3        3 4 4 4    4 3 3 5   collapse flip          remove-35-v3   Figure 4a-c: the v3 at u moves to v
//   move-v5        4 5 4 4    5 4 3 5   flip split             remove-35-v5   Figure 4d-f: the v5 at v moves to u
//   remove-35-v3   3 5 4 3    4 4 3 4   flip split             move-v3        Figure 4, read in reverse
//   remove-35-v5   3 5 5 4    4 4 4 5   collapse flip          move-v5        Figure 4, read in reverse
//   generate-3355  4 4 4 4    5 3 3 5   flip                   remove-3355    3-3-5-5 generation
//   remove-3355    3 5 5 3    4 4 4 4   flip                   generate-3355  3-3-5-5 removal
//
// Two more change a vertex V of any valence and the vertices next to it ("type change", Figure 5):
//
//   raise          A collapse: V takes in the opposite corner c of a face at V, l(c) > 2. V gets l(V) + l(c) - 2, and
//                  the face's other two corners lose 1. A v2 becomes regular between two v3s (Figure 5a).
//   lower          A split along W - V - Z, where Z is the K-th edge of V from W on the hand, 2 <= K < l(V). V gets
//                  l(V) - K + 1, a new vertex gets K + 1, and W and Z gain 1. With K = 3 a v6 becomes two regular
//                  vertices between two v5s (Figure 5b).
//
// These two are inverse to each other. The first table has the operations of the paper only. The others (a v3 can also
// move by a split, four alternating v3s and v5s round a face go by a collapse) are each a raise or a lower.
//
// Position and hand. An operation lies along a half-edge, and left and right are seen along it: from the v3 to the v5
// of a pair; from V to the neighbour where a v3 or v5 moves to; from the u that becomes a v5 to the v that becomes a v3
// in generate-3355; from u to v in remove-3355; from V to W otherwise. A raise takes the face on the hand.
//
// Names are "move-35 collapse left", "lower split right 3" (the last word is K): kind, basic operation, hand. A name
// depends on the mesh only by its position, and never changes.
//
// Law irregular-21. The inverse that perform() reports, performed next, restores the mesh: same ids, same free ids
// next.
// Law irregular-22. An operation changes the valences that its table says and no other, and none on the boundary. It
//         keeps every feature edge; the valence of a feature's vertex may change.
//
// Costs: those of the basic operation, O(1) in the size of the mesh. The list of a vertex of valence l has O(l)
// entries, and l (l - 3) / 2 of `lower`.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/irregular/transport.hpp"

namespace requad::mesh {

enum class AtomicKind {
  move_35,
  move_v3,
  move_v5,
  remove_35_v3,
  remove_35_v5,
  generate_3355,
  remove_3355,
  raise,
  lower
};

// A line of the tables above.
struct AtomicRule {
  AtomicKind kind;
  AtomicKind inverse;
  std::string_view name;
  std::array<int, 4> valences;  // of u, v, u', v' before; 0: any
  bool collapses;               // by which basic operations it can be performed
  bool flips;
  bool splits;
  std::string_view source;  // the figure, or the paragraph of section 5

  bool has(TransportStep::Kind by) const;
};
// All of them, in the order of AtomicKind.
std::span<const AtomicRule> atomic_rules();
const AtomicRule& rule(AtomicKind kind);

// What an operation is, apart from its position.
struct AtomicName {
  AtomicKind kind = AtomicKind::move_35;
  TransportStep step;
  int turn = 0;  // K of lower, 0 for all others

  friend bool operator==(const AtomicName& a, const AtomicName& b) {
    return a.kind == b.kind && a.step.kind == b.step.kind && a.step.hand == b.step.hand && a.turn == b.turn;
  }
};
std::string to_string(const AtomicName& name);
// The name that a text spells, or none: to_string(*parse_atomic_name(text)) == text.
std::optional<AtomicName> parse_atomic_name(std::string_view text);

struct AtomicOperation {
  AtomicName name;
  HalfEdgeId along;
  // Of the two vertices that a collapse merges, the opposite corner c keeps its id, in a raise V; of the two that a
  // split makes, the one on the hand is new. Or, swapped, the other one. The meshes differ by names only.
  bool swapped = false;
  int corner = 0;  // a split's corner of the new face (BasicOperation), so that an inverse restores ids
};

// A vertex whose valence changes; 0 before it is made, 0 after it is removed.
struct ValenceChange {
  VertexId vertex;
  int before = 0;
  int after = 0;
};

// The basic operation that this is, or why it cannot be performed:
//   dead_element          `along` is no live half-edge
//   touches_boundary      a vertex that would change its valence lies on the boundary
//   no_such_step          the kind cannot be performed by this basic operation
//   wrong_valences        u, v are not what the kind is about; or the corner c of a raise is a v2; or K of a lower is
//                         out of range
//   irregular_in_the_way  u' or v' is not what the kind is about
//   breaks_feature        a feature edge would go
// and whatever why_not() of the basic operation says.
struct AtomicPlan {
  Refusal refusal = Refusal::none;
  BasicOperation operation;  // meaningful if refusal is none
};
AtomicPlan plan(const Editor& editor, const AtomicOperation& operation);

struct AtomicReport {
  Refusal refusal = Refusal::none;
  BasicOperation operation;
  std::vector<ValenceChange> changes;  // three or four, a split's new vertex last
  AtomicOperation inverse;
};
// Performs it as one edit of the editor, or leaves everything as it was and gives the refusal of plan().
AtomicReport perform(Editor& editor, const AtomicOperation& operation);

// An operation that the valences at a position allow. It can be performed, or is refused with the reason.
struct AtomicChoice {
  AtomicOperation operation;
  Refusal refusal = Refusal::none;
};
// The operations of vertex V, each once up to names, edge by edge counter-clockwise from out(V):
//   V is a v3   move-v3 towards each neighbour, 2 collapses and 2 flips each
//   V is a v5   move-v5 towards each neighbour, 2 flips and 2 splits each
//   V is a v4   generate-3355 by each flip that changes l(V), 16
//   V is one of an adjacent 3-5 pair: the pair's six steps, each as move-35 or as the removal that it is
//   any V       raise for each face (both faces of a v2 make the same mesh); lower for each pair of edges that have
//               others between them on both sides, where V keeps the part of lower valence
// A boundary vertex has none. If a feature keeps one of two vertices from being removed, the other one is removed.
std::vector<AtomicChoice> atomic_operations(const Editor& editor, VertexId v);
// The operations that lie along the edge V -> W. Those of pairs and generate-3355 may lie along W -> V too. Raise is by
// the faces on both hands, lower by all paths W - V - Z with edges on both sides, on the left hand. Precondition: V is
// interior.
std::vector<AtomicChoice> atomic_operations(const Editor& editor, HalfEdgeId along);

}  // namespace requad::mesh
