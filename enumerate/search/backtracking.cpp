#include "enumerate/search/backtracking.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace requad::enumerate {

namespace {

// How often a branch looks at the clock and tells of its progress.
constexpr std::int64_t kStatesBetweenLooks = 1024;

// How many edges are looked at for a pair of corners: those where a quad just placed can have made one.
constexpr int kNear = 4;

}  // namespace

Budget::Budget(const std::vector<int>& irregular) {
  std::map<int, int> counts;
  for (const int l : irregular) ++counts[l], least_ += std::min(4 - l, 0), most_ += std::max(4 - l, 0);
  int codes = 1;
  for (const auto& [valence, count] : counts) {
    kinds_.push_back({valence, count, codes});
    codes *= count + 1;
  }
  // A multiset without its last kind has a smaller code, whose sums are known: this one's are those, and those + (4 -
  // l).
  sums_.assign(place(codes, least_), 0);
  sums_[place(0, 0)] = 1;
  for (int code = 1; code < codes; ++code) {
    const Kind& kind = *std::find_if(kinds_.rbegin(), kinds_.rend(), [&](const Kind& k) { return k.weight <= code; });
    const int smaller = code - kind.weight;
    for (int sum = least_; sum <= most_; ++sum) {
      if (sums_[place(smaller, sum)] == 0) continue;
      sums_[place(code, sum)] = 1;
      sums_[place(code, sum + 4 - kind.valence)] = 1;
    }
  }
  code_ = codes - 1;
}

SharedLimits::SharedLimits(const SearchLimits& limits)
    : pruning(limits.pruning),
      faces(std::min(limits.faces.value_or(kMostFaces), kMostFaces)),
      progress(limits.progress) {
  if (limits.seconds) {
    deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*limits.seconds));
  }
}

bool SharedLimits::should_stop() {
  if (progress) progress(kStatesBetweenLooks);
  const auto passed = [now = Clock::now()](const std::optional<Clock::time_point>& time) {
    return time && now > *time;
  };
  if (passed(deadline) || passed(pause)) stop = true;
  return stop;
}

// --- preparation -----------------------------------------------------------------------------------------------------

// Two edges that join the same vertices enclose a disk. If only one of its quads were at one of the two vertices, both
// edges would be sides of that quad, and it would have the other vertex twice; so at least two are at each, and by
// Gauss-Bonnet the irregular vertices inside have index 4 or more. A poorer budget needs no test for doubled edges.
BacktrackingSearch::BacktrackingSearch(const std::vector<int>& irregular, SharedLimits& shared)
    : budget_(irregular),
      shared_(&shared),
      pruning_(shared.pruning),
      face_limit_(shared.faces),
      edges_can_double_(budget_.most() >= 4) {}

int BacktrackingSearch::add_vertex() {
  if (static_cast<std::size_t>(filling_.vertices) == latest_edge_.size()) latest_edge_.push_back(kNone);
  return filling_.vertices++;
}

void BacktrackingSearch::add_edge(int a, int b) {
  if (!edges_can_double_) return;
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    int& latest = latest_edge_[static_cast<std::size_t>(from)];
    edges_.push_back({to, latest});
    latest = static_cast<int>(edges_.size()) - 1;
  }
}

// Always false if the answer does not matter.
bool BacktrackingSearch::adjacent(int a, int b) const {
  int e = latest_edge_[static_cast<std::size_t>(a)];
  while (e != kNone && edges_[static_cast<std::size_t>(e)].to != b) e = edges_[static_cast<std::size_t>(e)].earlier;
  return e != kNone;
}

int BacktrackingSearch::add_node(int vertex, int need) {
  nodes_.push_back({vertex, need, kNone, kNone});
  return static_cast<int>(nodes_.size()) - 1;
}

bool BacktrackingSearch::open_hole(const std::vector<BoundaryVertex>& boundary) {
  Sums sums;
  const int first = static_cast<int>(nodes_.size());
  for (const auto& [vertex, need] : boundary) {
    const int n = add_node(vertex, need);
    if (n > first) link(n - 1, n);
    sums += Sums(need);
  }
  link(static_cast<int>(nodes_.size()) - 1, first);
  push_hole(sums, first);
  least_faces_ = static_cast<int>(filling_.faces.size()) + least_faces(sums);
  if (sums.length() % 2 != 0 || !fits_budget(sums)) return false;
  levels_.assign(1, {});
  list_moves();
  return true;
}

void BacktrackingSearch::push_hole(Sums sums, int start) {
  if (sums.empty()) return;
  holes_.push_back({sums, start, hole_});
  hole_ = static_cast<int>(holes_.size()) - 1;
}

// --- pruning ---------------------------------------------------------------------------------------------------------

// A hole of n edges takes at least n/2 - 1 quads (Euler), and one in any case.
int BacktrackingSearch::least_faces(Sums hole) const {
  if (hole.empty() || !pruning_.face_bound) return 0;
  return std::max(hole.length() / 2 - 1, 1);
}

// Discrete Gauss-Bonnet: the irregular vertices in a hole have index 4 - turn.
bool BacktrackingSearch::fits_budget(Sums hole) const {
  return hole.empty() || !pruning_.gauss_bonnet || budget_.can_sum_to(4 - hole.turn());
}

// Whether the edge a, b may cut off the ring of these two nodes and those between: it has to be even, and the edge new.
bool BacktrackingSearch::may_cut(int a, int b, Sums between) const {
  if (pruning_.parity && between.length() % 2 != 0) return false;
  return !adjacent(node(a).vertex, node(b).vertex);
}

// --- the moves from a partial mesh -----------------------------------------------------------------------------------

// The edge v -> w, as v. A corner w (one quad missing) leaves one vertex of its quad to be chosen, two corners none. So
// two corners where the hole changed last, or the nearest corner; a pair of corners further off can wait.
int BacktrackingSearch::choose_edge(const Hole& hole) const {
  if (hole.sums.corners() == 0) return hole.node;
  int w = next(hole.node);
  for (int i = 0; i < kNear; ++i, w = previous(w)) {
    if (node(w).need == 1 && node(previous(w)).need == 1) return previous(w);
  }
  int back = previous(hole.node);
  for (w = hole.node; node(w).need != 1; w = next(w), back = previous(back)) {
    if (node(back).need == 1) return previous(back);
  }
  return previous(w);
}

void BacktrackingSearch::list_moves() {
  const Hole hole = holes_[static_cast<std::size_t>(hole_)];
  const int v = choose_edge(hole);
  const int w = next(v);
  levels_.back().v = v;
  if (node(w).need == 1) {
    list_y(hole, v, next(w), {});  // the quad takes the next edge of the ring too
    return;
  }
  list_y(hole, v, kNone, {});
  Sums between = sums_at(next(w));
  for (int x = next(next(w)); x != v; x = next(x)) {
    if (node(x).need >= 2 && may_cut(w, x, between)) list_y(hole, v, x, between);
    between += sums_at(x);
  }
}

// The corner y next to v, given the corner x next to w and the sums between w and x.
void BacktrackingSearch::list_y(const Hole& hole, int v, int x, Sums before) {
  const int w = next(v);
  if (previous(v) == x) return;  // a triangle would be left
  if (node(v).need == 1) {
    list_shares(hole, v, x, previous(v), before, {});
    return;
  }
  // If the quad takes the next edge too and x has no other quad, then it takes the edge after that as well.
  const bool x_is_done = x == next(w) && node(x).need == 1;
  if (x_is_done || (x != kNone && x != next(w))) {
    const int y = next(x);
    const Sums between = hole.sums - sums_at(v) - sums_at(w) - before - sums_at(x) - sums_at(y);
    if (y != previous(v) && node(y).need >= 2 && may_cut(v, y, between)) list_shares(hole, v, x, y, before, between);
    if (x_is_done) return;
  }
  list_shares(hole, v, x, kNone, before, {});
  // Any other y has a hole on each side, so it is concave: three quads missing or more. Look for such y from both ends of
  // what is left, until all have been seen.
  const int end = x == kNone ? w : next(x);
  Sums ahead = hole.sums - sums_at(v) - sums_at(w) - before;  // from the last node looked at there to previous(v)
  if (x != kNone) ahead -= sums_at(x) + sums_at(end);
  int concave = ahead.concavity();
  const auto try_as_y = [&](int y, Sums between) {
    concave -= concavity(y);
    if (y != previous(v) && may_cut(v, y, between)) list_shares(hole, v, x, y, before, between);
  };
  Sums behind;
  for (int back = previous(v), forth = next(end); concave > 0; back = previous(back), forth = next(forth)) {
    if (concavity(back) > 0) try_as_y(back, behind);
    behind += sums_at(back);
    if (concave == 0) break;
    ahead -= sums_at(forth);
    if (concavity(forth) > 0) try_as_y(forth, ahead);
  }
}

// Every way to be for a corner: the valences of a new one; for an old one the ways to share what it needs between the
// holes on its two sides, at least one for each that there is.
template <class Then>
void BacktrackingSearch::for_each_corner(int n, bool outer, bool inner, Then&& then) {
  if (n == kNone) {
    then(Corner{kNone, kNone, 0, 3});
    for (int kind = 0; kind < budget_.kind_count(); ++kind) {
      if (!budget_.has(kind)) continue;
      budget_.take(kind);
      then(Corner{kNone, kind, 0, budget_.valence(kind) - 1});
      budget_.give_back(kind);
    }
    return;
  }
  const int rest = node(n).need - 1;
  for (int share = outer ? 1 : 0; share <= (outer ? rest : 0); ++share) {
    if ((rest - share > 0) == inner) then(Corner{n, kNone, share, rest - share});
  }
}

void BacktrackingSearch::list_shares(const Hole& hole, int v, int x, int y, Sums before, Sums after) {
  const int w = next(v);
  const bool old = x != kNone && y != kNone;
  const bool has_before = x != kNone && x != next(w);
  const bool has_middle = !old || y != next(x);
  const bool has_after = y != kNone && y != previous(v);
  if (old && has_middle && adjacent(node(x).vertex, node(y).vertex)) return;

  const Sums w_left = Sums(node(w).need - 1);
  const Sums v_left = Sums(node(v).need - 1);
  Sums between = hole.sums - sums_at(v) - sums_at(w) - before - after;
  if (x != kNone) between -= sums_at(x);
  if (y != kNone) between -= sums_at(y);
  if (has_middle && x == kNone) between += w_left;
  if (has_middle && y == kNone) between += v_left;
  const int other_faces = least_faces_ - least_faces(hole.sums) + 1;
  for_each_corner(x, has_before, has_middle, [&](const Corner& x_corner) {
    const Sums before_hole = has_before ? before + w_left + Sums(x_corner.outer) : Sums();
    if (!fits_budget(before_hole)) return;
    for_each_corner(y, has_after, has_middle, [&](const Corner& y_corner) {
      const Sums after_hole = has_after ? after + v_left + Sums(y_corner.outer) : Sums();
      if (!fits_budget(after_hole)) return;
      const Sums middle_hole = has_middle ? between + Sums(x_corner.inner) + Sums(y_corner.inner) : Sums();
      if (!fits_budget(middle_hole)) return;
      if (other_faces + least_faces(before_hole) + least_faces(middle_hole) + least_faces(after_hole) > face_limit_) {
        shared_->face_limit_cut = true;
        return;
      }
      moves_.push_back({x_corner, y_corner, before_hole, middle_hole, after_hole});
    });
  });
}

// --- placing quads and taking them back ------------------------------------------------------------------------------

void BacktrackingSearch::place(const Move& move) {
  const int v = levels_.back().v;
  const int w = next(v);
  const auto size = [](const auto& stack) { return static_cast<int>(stack.size()); };
  levels_.push_back({move.x.kind, move.y.kind, size(nodes_), size(saved_), size(holes_), size(edges_),
                     filling_.vertices, hole_, least_faces_, 0, kNone, kNone});
  const Hole hole = holes_[static_cast<std::size_t>(hole_)];
  const bool x_is_new = move.x.node == kNone;
  const bool y_is_new = move.y.node == kNone;
  const bool has_before = !move.before.empty();
  const bool has_middle = !move.middle.empty();
  const bool has_after = !move.after.empty();
  const int x = x_is_new ? add_node(add_vertex(), move.x.inner) : move.x.node;
  const int y = y_is_new ? add_node(add_vertex(), move.y.inner) : move.y.node;
  const int after_x = next(x);
  const int before_y = previous(y);
  save(v), save(w);
  if (!x_is_new) save(x), save(after_x);
  if (!y_is_new) save(before_y), save(y);

  if (move.x.kind != kNone) budget_.take(move.x.kind);
  if (move.y.kind != kNone) budget_.take(move.y.kind);
  filling_.faces.push_back({node(v).vertex, node(w).vertex, node(x).vertex, node(y).vertex});
  if (x_is_new || has_before) add_edge(node(w).vertex, node(x).vertex);
  if (has_middle) add_edge(node(x).vertex, node(y).vertex);
  if (y_is_new || has_after) add_edge(node(y).vertex, node(v).vertex);

  --node(v).need, --node(w).need;
  int middle = kNone;
  if (has_middle) {
    // An old corner with a hole on its other side too has a second node here.
    int from = x_is_new ? w : x;
    int to = y_is_new ? v : y;
    if (has_before) from = add_node(node(x).vertex, 0), link(from, after_x);
    if (has_after) to = add_node(node(y).vertex, 0), link(before_y, to);
    if (!x_is_new) node(from).need = move.x.inner;
    if (!y_is_new) node(to).need = move.y.inner;
    middle = from;
    if (y_is_new) link(to, y), to = y;
    if (x_is_new) link(x, from), from = x;
    link(to, from);
  }
  if (has_before) node(x).need = move.x.outer, link(x, w);
  if (has_after) node(y).need = move.y.outer, link(v, y);

  hole_ = hole.next;
  push_hole(move.after, y);
  push_hole(move.middle, middle);
  push_hole(move.before, w);
  least_faces_ +=
      1 - least_faces(hole.sums) + least_faces(move.before) + least_faces(move.middle) + least_faces(move.after);
}

void BacktrackingSearch::take_back() {
  const Level& level = levels_.back();
  least_faces_ = level.least_faces;
  hole_ = level.hole;
  holes_.erase(holes_.begin() + level.holes, holes_.end());
  while (static_cast<int>(edges_.size()) > level.edges) {
    // The two half-edges of an edge lie side by side, so each starts where the other leads.
    const HalfEdge back = edges_.back();
    edges_.pop_back();
    const HalfEdge forth = edges_.back();
    edges_.pop_back();
    latest_edge_[static_cast<std::size_t>(forth.to)] = back.earlier;
    latest_edge_[static_cast<std::size_t>(back.to)] = forth.earlier;
  }
  filling_.faces.pop_back();
  if (level.x_kind != kNone) budget_.give_back(level.x_kind);
  if (level.y_kind != kNone) budget_.give_back(level.y_kind);
  for (; static_cast<int>(saved_.size()) > level.saved; saved_.pop_back()) {
    node(saved_.back().first) = saved_.back().second;
  }
  nodes_.erase(nodes_.begin() + level.nodes, nodes_.end());
  filling_.vertices = level.vertices;
  levels_.pop_back();
}

// --- the search ------------------------------------------------------------------------------------------------------

int BacktrackingSearch::left(std::size_t level) const {
  const auto end = level + 1 < levels_.size() ? levels_[level + 1].first_move : static_cast<int>(moves_.size());
  return end - levels_[level].first_move;
}

void BacktrackingSearch::make(int number, int left) {
  const int first = levels_.back().first_move;
  levels_.back().made = number;
  place(moves_[static_cast<std::size_t>(first + number)]);
  moves_.erase(moves_.begin() + first + left, moves_.end());
  levels_.back().first_move = first + left;
  if (hole_ != kNone) list_moves();
}

bool BacktrackingSearch::run(const Visit& visit, const Sharing& sharing) {
  states_ = 0;
  for (;;) {
    if (const int count = left(levels_.size() - 1); count > 0) {
      make(count - 1, count - 1);
      if (hole_ == kNone && budget_.empty() && visit) visit(filling_);
      if (++states_ % kStatesBetweenLooks == 0) {
        if (shared_->should_stop()) return false;
        if (sharing.wanted.load(std::memory_order_relaxed)) hand_over(sharing);
      }
    } else if (levels_.size() > 1) {
      take_back();
    } else {
      return true;
    }
  }
}

void BacktrackingSearch::hand_over(const Sharing& sharing) {
  std::size_t i = 0;
  while (i + 1 < levels_.size() && left(i) == 0) ++i;
  const int given = left(i);
  if (given == static_cast<int>(moves_.size())) return;  // then the two would only change places
  BacktrackingSearch other = *this;
  while (other.levels_.size() > i + 1) other.take_back();
  other.moves_.resize(static_cast<std::size_t>(given));
  moves_.erase(moves_.begin(), moves_.begin() + given);
  for (++i; i < levels_.size(); ++i) levels_[i].first_move -= given;
  sharing.take(other);
}

BacktrackingSearch::Trail BacktrackingSearch::trail() const {
  Trail trail;
  for (std::size_t i = 0; i + 1 < levels_.size(); ++i) trail.insert(trail.end(), {levels_[i].made, left(i)});
  trail.push_back(left(levels_.size() - 1));
  return trail;
}

void BacktrackingSearch::go_to(const Trail& trail) {
  if (trail.size() % 2 == 0) throw std::invalid_argument("a trail has an odd number of numbers");
  const auto check = [](int number, int low, int high) {
    if (number < low || number > high) throw std::invalid_argument("no such move: " + std::to_string(number));
    return number;
  };
  while (levels_.size() > 1) take_back();
  moves_.clear();
  list_moves();
  for (std::size_t i = 0; i + 1 < trail.size(); i += 2) {
    const int made = check(trail[i], 0, left(levels_.size() - 1) - 1);
    make(made, check(trail[i + 1], 0, made));
  }
  const int rest = check(trail.back(), 0, left(levels_.size() - 1));
  moves_.erase(moves_.begin() + levels_.back().first_move + rest, moves_.end());
}

}  // namespace requad::enumerate
