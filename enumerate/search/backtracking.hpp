// The engine of the exhaustive search (search.hpp says what is searched, and why each filling is met once): fills holes
// quad by quad, depth first, in place.
//
// State. A hole is a ring of nodes, one for each vertex on its boundary, with the number of quads that the vertex still
// needs in this hole; a list holds the open holes. Placing a quad changes at most six nodes of one ring, and
// take_back() puts those six back, so neither costs more in a large hole. Branches wait on an explicit stack of moves:
// no recursion, and no allocation but where a stack grows beyond its record.
//
// The pruning rules read sums over a ring (length, turns, corners), which each move carries along.
//
// Costs. A quad at a corner of the hole, the usual case, is O(1) but for the walk to the next corner and the walk over
// candidates for the fourth vertex; that one ends when no concave vertex is left. A hole without corners costs a round.
//
// Where it stands is a few numbers: the moves from a partial mesh are listed in an order that the mesh alone determines,
// and tried from the last to the first. So for each level which move was made, and how many are left, tell all that is
// done and all that is to do: its trail. A filler hands over work, and is stopped and started again, by trails.
//
// Internal: not installed.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "enumerate/search/search.hpp"

namespace requad::enumerate {

// The multiset of irregular valences that is left, and which sums of indices 4 - l its parts have.
class Budget {
 public:
  // Costs O(number of multisets * range of sums) time and space.
  explicit Budget(const std::vector<int>& irregular);

  int kind_count() const { return static_cast<int>(kinds_.size()); }
  int valence(int kind) const { return at(kind).valence; }
  bool has(int kind) const { return at(kind).left > 0; }
  void take(int kind) { --at(kind).left, code_ -= at(kind).weight; }
  void give_back(int kind) { ++at(kind).left, code_ += at(kind).weight; }
  bool empty() const { return code_ == 0; }
  int most() const { return most_; }  // the largest sum that a part of the whole budget has
  // Whether some part of what is left has this sum of 4 - l.
  bool can_sum_to(int index) const { return least_ <= index && index <= most_ && sums_[place(code_, index)] != 0; }

 private:
  struct Kind {
    int valence;
    int left;
    int weight;  // in code_, the mixed-radix number of the multiset
  };
  const Kind& at(int kind) const { return kinds_[static_cast<std::size_t>(kind)]; }
  Kind& at(int kind) { return kinds_[static_cast<std::size_t>(kind)]; }
  std::size_t place(int code, int index) const {
    return static_cast<std::size_t>(code * (most_ - least_ + 1) + index - least_);
  }

  std::vector<Kind> kinds_;
  std::vector<char> sums_;  // by code, then by sum
  int least_ = 0;
  int most_ = 0;
  int code_ = 0;
};

// What the branches of one search share.
struct SharedLimits {
  using Clock = std::chrono::steady_clock;

  explicit SharedLimits(const SearchLimits& limits);

  SearchPruning pruning;
  int faces;
  std::optional<Clock::time_point> deadline;  // the end of the search
  std::optional<Clock::time_point> pause;     // when it stops to be written down
  std::function<void(std::int64_t)> progress;
  std::atomic<bool> stop{false};
  std::atomic<bool> face_limit_cut{false};

  // What a branch asks now and then: whether either time has come. It tells of its progress, too.
  bool should_stop();
};

// Copyable: a copy goes on from where the original stands.
class BacktrackingSearch {
 public:
  using Visit = std::function<void(const Filling&)>;
  // Takes work off a search that is under way, whenever it is wanted.
  struct Sharing {
    const std::atomic<bool>& wanted;
    std::function<void(const BacktrackingSearch&)> take;
  };
  // For each level but the last the number of the move that was made and how many moves below it are left; then how many
  // are left at the last.
  using Trail = std::vector<int>;

  BacktrackingSearch(const std::vector<int>& irregular, SharedLimits& shared);

  // Preparation: vertices, edges and faces that are there already, and one hole.
  int add_vertex();
  void add_edge(int a, int b);
  void add_face(const std::array<int, 4>& face) { filling_.faces.push_back(face); }
  // The hole's boundary counter-clockwise (the hole on the left): each vertex with the quads that it needs.
  struct BoundaryVertex {
    int vertex;
    int need;
  };
  // False if it can not be filled.
  bool open_hole(const std::vector<BoundaryVertex>& boundary);

  // Calls visit for each filling that is left, until all are found (true) or the search is to stop (false; run() goes on).
  // Looks now and then whether it shall stop, or work is wanted; then it hands over what is left at the level nearest to
  // the root, if there is something left at another.
  bool run(const Visit& visit, const Sharing& sharing);
  // How many quads the last run() placed.
  std::int64_t states() const { return states_; }

  Trail trail() const;
  // From wherever it stands to where a filler of the same preparation stood. O(lengths of both) moves. Throws
  // std::invalid_argument if the numbers are no trail; it stands anywhere then.
  void go_to(const Trail& trail);

 private:
  static constexpr int kNone = -1;

  // A vertex on the boundary of a hole. A vertex on several holes has a node in each.
  struct Node {
    int vertex;
    int need;
    int next;
    int previous;
  };
  // Sums over nodes, three in one word: 21 bits each for their number and for the corners, the rest for missing quads
  // beyond two, which has a sign. problem_with() and kMostFaces keep each within its bits.
  class Sums {
   public:
    Sums() = default;
    explicit Sums(int need)
        : packed_(1 + (std::int64_t{need == 1} << kBits) + (std::int64_t{need - 2} << (2 * kBits))) {}
    int length() const { return static_cast<int>(packed_ & kMask); }  // nodes; of a whole ring: edges
    int corners() const { return static_cast<int>((packed_ >> kBits) & kMask); }
    int turn() const { return static_cast<int>(-(packed_ >> (2 * kBits))); }  // of 2 - need, in quarter turns
    int concavity() const { return corners() - turn(); }                      // of need - 2 where that is positive
    bool empty() const { return packed_ == 0; }
    Sums& operator+=(Sums other) { return packed_ += other.packed_, *this; }
    Sums& operator-=(Sums other) { return packed_ -= other.packed_, *this; }
    friend Sums operator+(Sums a, Sums b) { return a += b; }
    friend Sums operator-(Sums a, Sums b) { return a -= b; }

   private:
    static constexpr int kBits = 21;
    static constexpr std::int64_t kMask = (std::int64_t{1} << kBits) - 1;
    std::int64_t packed_ = 0;
  };
  struct Hole {
    Sums sums;
    int node;  // where the choice of an edge starts
    int next;  // the hole to fill after this one
  };

  // A quad v, w, x, y on the edge v -> w of a hole leaves up to three holes: `before` between w and x, `middle` between
  // x and y, `after` between y and v. Corners x and y of it are nodes of the ring, or new.
  struct Corner {
    int node;   // kNone: a new vertex
    int kind;   // of a new vertex, in the budget; kNone: valence 4
    int outer;  // what it needs in `before` (x) or `after` (y)
    int inner;  // what it needs in `middle`
  };
  struct Move {
    Corner x, y;
    Sums before, middle, after;  // empty: there is no such hole
  };
  // A partial mesh on the current branch: how it was made, to be taken back, and what remains to be tried from it.
  struct Level {
    int x_kind, y_kind;
    int nodes, saved, holes, edges, vertices;  // how many there were before
    int hole;
    int least_faces;
    int first_move;  // its moves are those from here on
    int v;           // they are on the edge v -> w
    int made;        // the number of the move that led to the next level
  };

  const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
  Node& node(int n) { return nodes_[static_cast<std::size_t>(n)]; }
  int next(int n) const { return node(n).next; }
  int previous(int n) const { return node(n).previous; }
  Sums sums_at(int n) const { return Sums(node(n).need); }
  int concavity(int n) const { return node(n).need > 2 ? node(n).need - 2 : 0; }
  bool adjacent(int a, int b) const;
  int least_faces(Sums hole) const;
  bool fits_budget(Sums hole) const;

  int choose_edge(const Hole& hole) const;
  void list_moves();
  void list_y(const Hole& hole, int v, int x, Sums before);
  void list_shares(const Hole& hole, int v, int x, int y, Sums before, Sums after);
  bool may_cut(int a, int b, Sums between) const;
  template <class Then>
  void for_each_corner(int n, bool outer, bool inner, Then&& then);

  // The moves that are left at a level.
  int left(std::size_t level) const;
  void place(const Move& move);
  // Makes a move of the last level, leaves only the first so many of the others there, and lists the moves that follow.
  void make(int number, int left);
  void take_back();
  void hand_over(const Sharing& sharing);
  int add_node(int vertex, int need);
  void save(int n) { saved_.emplace_back(n, node(n)); }
  void link(int a, int b) { node(a).next = b, node(b).previous = a; }
  void push_hole(Sums sums, int start);

  Budget budget_;
  SharedLimits* shared_;
  SearchPruning pruning_;
  int face_limit_;
  bool edges_can_double_;
  Filling filling_;  // the partial mesh
  std::vector<Node> nodes_;
  std::vector<std::pair<int, Node>> saved_;  // what nodes were before they changed
  std::vector<Hole> holes_;                  // the open ones are linked from hole_ on
  int hole_ = kNone;
  int least_faces_ = 0;  // that every filling of this partial mesh has, as far as the lengths of its holes tell
  struct HalfEdge {
    int to;
    int earlier;  // the one added before from the same vertex
  };
  std::vector<HalfEdge> edges_;   // in pairs
  std::vector<int> latest_edge_;  // by vertex
  std::vector<Move> moves_;
  std::vector<Level> levels_;
  std::int64_t states_ = 0;
};

}  // namespace requad::enumerate
