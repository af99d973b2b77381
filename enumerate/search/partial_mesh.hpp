// The state of the backtracking search: a quad mesh with holes, which are filled quad by quad in place.
//
// Terms
//   hole        a disk without quads, still to be filled. Its ring is its boundary, with the hole on the left.
//   node        a vertex on a ring. A vertex that lies on several rings has a node in each.
//   need        of a node: how many quads its vertex still gets in this hole; at least 1.
//   hole corner a node with need 1.
//   placement   a quad v, w, x, y on the edge v -> w of a ring. Its other corners x and y are nodes of the ring or new
//               vertices. The quad leaves up to three holes, one beyond each of its other edges:
//
//                           middle
//                       y --------- x
//                after  |           |  before           the ring runs from v to w, then past `before`, `middle` and
//                       v --------- w                   `after` back to v
//
// Costs. A placement changes at most six nodes of one ring, so place() and undo() take constant time however large the
// holes are. Memory is allocated only when a stack grows larger than ever before. Memory, and the time of a copy, are
// in proportion to the faces and vertices.
//
// Internal: not installed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "enumerate/search/search.hpp"
#include "enumerate/search/valence_budget.hpp"

namespace requad::enumerate {

// Sums over some nodes of a ring. The pruning rules read them, and each placement carries those of its holes along.
//
// Three sums are packed into one word. The number of nodes and the number of hole corners have 21 bits each. The signed
// sum of need - 2 has the rest. The limits of problem_with() and kMostFaces keep each sum within its bits.
class RingSums {
 public:
  RingSums() = default;
  // The sums of one node.
  explicit RingSums(int need)
      : packed_(1 + (std::int64_t{need == 1} << kBits) + (std::int64_t{need - 2} << (2 * kBits))) {}

  int length() const { return static_cast<int>(packed_ & kMask); }  // the number of nodes; of a whole ring: of edges
  int corners() const { return static_cast<int>((packed_ >> kBits) & kMask); }
  int turn() const { return static_cast<int>(-(packed_ >> (2 * kBits))); }  // the sum of 2 - need, in quarter turns
  int concavity() const { return corners() - turn(); }  // the sum of need - 2 where that is positive
  bool empty() const { return packed_ == 0; }

  RingSums& operator+=(RingSums other) { return packed_ += other.packed_, *this; }
  RingSums& operator-=(RingSums other) { return packed_ -= other.packed_, *this; }
  friend RingSums operator+(RingSums a, RingSums b) { return a += b; }
  friend RingSums operator-(RingSums a, RingSums b) { return a -= b; }

 private:
  static constexpr int kBits = 21;
  static constexpr std::int64_t kMask = (std::int64_t{1} << kBits) - 1;
  std::int64_t packed_ = 0;
};

inline constexpr int kNone = -1;  // no node, no hole, no kind of valence

// Node indices and vertices are those of the partial mesh that the placement was listed for.
struct Placement {
  struct Corner {
    int node;   // kNone: a new vertex
    int kind;   // of a new vertex: its kind in the budget; kNone: valence 4
    int outer;  // its need in `before` (for x) or `after` (for y)
    int inner;  // its need in `middle`
  };
  Corner x, y;
  RingSums before, middle, after;  // empty: the quad leaves no such hole
};

class PartialMesh {
 public:
  struct Node {
    int vertex;
    int need;
    int next;  // counter-clockwise round the hole
    int previous;
  };
  struct Hole {
    RingSums sums;
    int node;  // where the choice of an edge starts
    int next;  // the hole to be filled after this one
  };

  // An empty mesh. `irregular` are the irregular valences of the vertices that placements will add.
  explicit PartialMesh(const std::vector<int>& irregular);

  // Preparation: vertices, edges and faces before the first placement. Vertices are numbered from 0.
  int add_vertex();
  void add_edge(int a, int b);
  void add_face(const std::array<int, 4>& face) { filling_.faces.push_back(face); }
  struct BoundaryVertex {
    int vertex;
    int need;
  };
  // Adds a hole with this ring, to be filled before all others. Precondition: `ring` is not empty.
  void open_hole(const std::vector<BoundaryVertex>& ring);

  // Places a quad on the edge v -> next(v) of the first hole.
  void place(int v, const Placement& placement);
  // Removes the last quad. Every array becomes what it was before place().
  void undo();

  const Filling& filling() const { return filling_; }
  ValenceBudget& budget() { return budget_; }
  const ValenceBudget& budget() const { return budget_; }
  bool has_hole() const { return first_hole_ != kNone; }
  // The hole to be filled first. Precondition: has_hole().
  const Hole& first_hole() const { return holes_[static_cast<std::size_t>(first_hole_)]; }
  const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
  // Whether an edge joins these vertices. Always false for a budget under which no edge can be doubled. O(valence).
  bool adjacent(int a, int b) const;

  // A hole of n edges takes at least max(1, n/2 - 1) quads (Euler's formula). An empty one takes none.
  static int least_faces(RingSums hole) { return hole.empty() ? 0 : hole.length() > 4 ? hole.length() / 2 - 1 : 1; }
  // A lower bound for the faces of any filling: the faces that are there and least_faces() of each hole.
  int least_faces() const { return least_faces_; }

 private:
  struct HalfEdge {
    int to;
    int earlier;  // the half-edge that was added before from the same vertex
  };
  // Data for undo(): the sizes of the stacks before a placement, and what cannot be derived from them.
  struct Record {
    int x_kind, y_kind;
    int nodes, saved, holes, edges, vertices;
    int first_hole;
    int least_faces;
  };

  Node& at(int n) { return nodes_[static_cast<std::size_t>(n)]; }
  int add_node(int vertex, int need);
  void save(int n) { saved_.emplace_back(n, at(n)); }
  void link(int a, int b) { at(a).next = b, at(b).previous = a; }
  void push_hole(RingSums sums, int start);
  int close_middle_ring(int v, int w, int x, int y, const Placement& placement);

  ValenceBudget budget_;
  bool edges_can_double_;
  Filling filling_;  // so far
  std::vector<Node> nodes_;
  std::vector<std::pair<int, Node>> saved_;  // what nodes were before they changed
  std::vector<Hole> holes_;                  // the open ones are linked from first_hole_ on
  int first_hole_ = kNone;
  int least_faces_ = 0;
  std::vector<HalfEdge> edges_;   // in pairs
  std::vector<int> latest_edge_;  // by vertex
  std::vector<Record> records_;   // by placement
};

}  // namespace requad::enumerate
