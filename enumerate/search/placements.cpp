#include "enumerate/search/placements.hpp"

namespace requad::enumerate {

namespace {

// The number of edges behind the last change of a hole that are searched for two adjacent hole corners. The quad that
// was placed last can have made them only there.
constexpr int kEdgesNearChange = 4;

// Discrete Gauss-Bonnet: the irregular vertices in a hole have index 4 - turn.
bool fits_budget(RingSums hole, const ValenceBudget& budget, const SearchPruning& pruning) {
  return hole.empty() || !pruning.gauss_bonnet || budget.can_sum_to(4 - hole.turn());
}

// Lists the placements v, w, x, y on one edge v -> w of a hole. Tries the fourth corners y for each third corner x, and
// for each x and y all ways to divide their needs among the holes on their sides.
class PlacementLister {
 public:
  PlacementLister(PartialMesh& mesh, SearchControl& control, std::vector<Placement>& placements)
      : mesh_(mesh),
        control_(control),
        pruning_(control.pruning),
        placements_(placements),
        hole_(mesh.first_hole()),
        v_(choose_edge()),
        w_(next(v_)),
        beyond_(hole_.sums - sums_at(v_) - sums_at(w_)),
        v_left_(need(v_) - 1),
        w_left_(need(w_) - 1),
        least_faces_elsewhere_(pruning_.face_bound ? mesh.least_faces() - PartialMesh::least_faces(hole_.sums) + 1
                                                   : static_cast<int>(mesh.filling().faces.size()) + 1) {}

  int list() {
    try_third_corners();
    return v_;
  }

 private:
  int next(int n) const { return mesh_.node(n).next; }
  int previous(int n) const { return mesh_.node(n).previous; }
  int need(int n) const { return mesh_.node(n).need; }
  int vertex(int n) const { return mesh_.node(n).vertex; }
  bool is_hole_corner(int n) const { return need(n) == 1; }
  int concavity(int n) const { return need(n) > 2 ? need(n) - 2 : 0; }
  RingSums sums_at(int n) const { return RingSums(need(n)); }
  bool fits_budget(RingSums hole) const { return enumerate::fits_budget(hole, mesh_.budget(), pruning_); }
  int least_faces(RingSums hole) const { return pruning_.face_bound ? PartialMesh::least_faces(hole) : 0; }

  int choose_edge() const;
  void try_third_corners();
  void try_fourth_corners(int x, RingSums before);
  void try_concave_fourth_corners(int x, RingSums before);
  void divide_needs(int x, int y, RingSums before, RingSums after);
  template <class Then>
  void for_each_division(int n, bool outer, bool inner, Then&& then);
  bool may_cut(int a, int b, RingSums between) const;

  PartialMesh& mesh_;
  SearchControl& control_;
  const SearchPruning& pruning_;
  std::vector<Placement>& placements_;
  const PartialMesh::Hole hole_;
  const int v_;
  const int w_;
  const RingSums beyond_;            // from next(w) to previous(v)
  const RingSums v_left_, w_left_;   // v and w, once the quad is there
  const int least_faces_elsewhere_;  // of any filling: the quad, and what is outside this hole
};

// Chooses the edge v -> w and returns v. If w is a hole corner, only y must be chosen; if v is one too, nothing. So the
// best edge joins two hole corners where the hole changed last, and the second best ends at the nearest corner. Two
// adjacent corners farther away can wait.
int PlacementLister::choose_edge() const {
  if (hole_.sums.corners() == 0) return hole_.node;
  int w = next(hole_.node);
  for (int i = 0; i < kEdgesNearChange; ++i, w = previous(w)) {
    if (is_hole_corner(w) && is_hole_corner(previous(w))) return previous(w);
  }
  int back = previous(hole_.node);
  for (w = hole_.node; !is_hole_corner(w); w = next(w), back = previous(back)) {
    if (is_hole_corner(back)) return previous(back);
  }
  return previous(w);
}

// Whether an edge from a to b may cut off the ring of these two nodes and those between them. The ring must be even,
// and there must be no such edge yet.
bool PlacementLister::may_cut(int a, int b, RingSums between) const {
  if (pruning_.parity && between.length() % 2 != 0) return false;
  return !mesh_.adjacent(vertex(a), vertex(b));
}

void PlacementLister::try_third_corners() {
  if (is_hole_corner(w_)) {
    try_fourth_corners(next(w_), {});  // the next edge of the ring is a side of the quad, too
    return;
  }
  try_fourth_corners(kNone, {});
  RingSums between = sums_at(next(w_));
  for (int x = next(next(w_)); x != v_; x = next(x)) {
    if (need(x) >= 2 && may_cut(w_, x, between)) try_fourth_corners(x, between);
    between += sums_at(x);
  }
}

// `before` sums over the nodes between w and x.
void PlacementLister::try_fourth_corners(int x, RingSums before) {
  if (previous(v_) == x) return;  // a triangle would be left
  if (is_hole_corner(v_)) {
    divide_needs(x, previous(v_), before, {});
    return;
  }
  // If w -> x is an edge of the ring and x gets no other quad, the edge after it is a side of the quad, too.
  const bool x_is_done = x == next(w_) && is_hole_corner(x);
  if (x_is_done || (x != kNone && x != next(w_))) {
    const int y = next(x);
    const RingSums between = beyond_ - before - sums_at(x) - sums_at(y);
    if (y != previous(v_) && need(y) >= 2 && may_cut(v_, y, between)) divide_needs(x, y, before, between);
    if (x_is_done) return;
  }
  divide_needs(x, kNone, before, {});
  try_concave_fourth_corners(x, before);
}

// Tries each node y of the ring that gets a hole on either side. Such a node needs at least three quads, so it is
// concave. Searches the rest of the ring from both ends until all concave nodes have been found.
void PlacementLister::try_concave_fourth_corners(int x, RingSums before) {
  const int end = x == kNone ? w_ : next(x);
  RingSums ahead = beyond_ - before;  // from the node `forth` to previous(v)
  if (x != kNone) ahead -= sums_at(x) + sums_at(end);
  int concave = ahead.concavity();
  const auto try_as_y = [&](int y, RingSums between) {
    concave -= concavity(y);
    if (y != previous(v_) && may_cut(v_, y, between)) divide_needs(x, y, before, between);
  };
  RingSums behind;
  for (int back = previous(v_), forth = next(end); concave > 0; back = previous(back), forth = next(forth)) {
    if (concavity(back) > 0) try_as_y(back, behind);
    behind += sums_at(back);
    if (concave == 0) break;
    ahead -= sums_at(forth);
    if (concavity(forth) > 0) try_as_y(forth, ahead);
  }
}

// Calls then(corner) for each way to complete the corner n of the quad. A new vertex may have any valence that is left.
// An old vertex divides its need between the hole on its outer side, if `outer` is true, and the hole beyond x and y,
// if `inner` is true. Each of these holes gets at least one quad.
template <class Then>
void PlacementLister::for_each_division(int n, bool outer, bool inner, Then&& then) {
  using Corner = Placement::Corner;
  if (n == kNone) {
    then(Corner{kNone, kNone, 0, 3});
    ValenceBudget& budget = mesh_.budget();
    for (int kind = 0; kind < budget.kind_count(); ++kind) {
      if (!budget.has(kind)) continue;
      budget.take(kind);
      then(Corner{kNone, kind, 0, budget.valence(kind) - 1});
      budget.give_back(kind);
    }
    return;
  }
  const int rest = need(n) - 1;
  for (int share = outer ? 1 : 0; share <= (outer ? rest : 0); ++share) {
    if ((rest - share > 0) == inner) then(Corner{n, kNone, share, rest - share});
  }
}

// Lists the placements with these corners. `before` sums over the nodes between w and x, `after` over those between y
// and v. They are empty where the two corners are neighbours or one is new.
void PlacementLister::divide_needs(int x, int y, RingSums before, RingSums after) {
  const bool both_old = x != kNone && y != kNone;
  const bool has_before = x != kNone && x != next(w_);
  const bool has_middle = !both_old || y != next(x);
  const bool has_after = y != kNone && y != previous(v_);
  if (both_old && has_middle && mesh_.adjacent(vertex(x), vertex(y))) return;

  RingSums middle = beyond_ - before - after;  // x and y are subtracted next
  if (x != kNone) middle -= sums_at(x);
  if (y != kNone) middle -= sums_at(y);
  if (has_middle && x == kNone) middle += w_left_;
  if (has_middle && y == kNone) middle += v_left_;
  for_each_division(x, has_before, has_middle, [&](const Placement::Corner& x_corner) {
    const RingSums before_hole = has_before ? before + w_left_ + RingSums(x_corner.outer) : RingSums();
    if (!fits_budget(before_hole)) return;
    for_each_division(y, has_after, has_middle, [&](const Placement::Corner& y_corner) {
      const RingSums after_hole = has_after ? after + v_left_ + RingSums(y_corner.outer) : RingSums();
      if (!fits_budget(after_hole)) return;
      const RingSums middle_hole =
          has_middle ? middle + RingSums(x_corner.inner) + RingSums(y_corner.inner) : RingSums();
      if (!fits_budget(middle_hole)) return;
      if (least_faces_elsewhere_ + least_faces(before_hole) + least_faces(middle_hole) + least_faces(after_hole) >
          control_.most_faces) {
        control_.face_limit_cut = true;
        return;
      }
      placements_.push_back({x_corner, y_corner, before_hole, middle_hole, after_hole});
    });
  });
}

}  // namespace

bool may_be_filled(const PartialMesh& mesh, const SearchPruning& pruning) {
  const RingSums sums = mesh.first_hole().sums;
  return sums.length() % 2 == 0 && fits_budget(sums, mesh.budget(), pruning);
}

int list_placements(PartialMesh& mesh, SearchControl& control, std::vector<Placement>& placements) {
  return PlacementLister(mesh, control, placements).list();
}

}  // namespace requad::enumerate
