#include "enumerate/search.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "mesh/signature.hpp"

namespace requad::enumerate {

namespace {

using Clock = std::chrono::steady_clock;

// The multiset of valences that is left, and which index sums its parts have.
class Budget {
 public:
  explicit Budget(const std::vector<int>& irregular) {
    std::map<int, int> counts;
    for (const int l : irregular) ++counts[l], least_ += std::min(4 - l, 0), most_ += std::max(4 - l, 0);
    int size = 1;
    for (const auto& [valence, count] : counts) {
      kinds_.push_back({valence, count, size});
      size *= count + 1;
    }
    // Every remaining multiset has a mixed-radix number; for each, the sums of its parts.
    for (code_ = 0; code_ < size; ++code_) {
      std::vector<char> sums(static_cast<std::size_t>(most_ - least_ + 1), 0);
      sums[static_cast<std::size_t>(-least_)] = 1;
      for (const Kind& kind : kinds_) {
        for (int have = code_ / kind.weight % (kind.left + 1); have > 0; --have) {
          std::vector<char> more = sums;
          for (int i = least_; i <= most_; ++i) {
            const int to = i + 4 - kind.valence;
            if (sums[static_cast<std::size_t>(i - least_)] != 0 && least_ <= to && to <= most_) more[static_cast<std::size_t>(to - least_)] = 1;
          }
          sums = std::move(more);
        }
      }
      sums_.push_back(std::move(sums));
    }
    code_ = size - 1;
  }

  std::size_t kind_count() const { return kinds_.size(); }
  int valence(std::size_t kind) const { return kinds_[kind].valence; }
  bool has(std::size_t kind) const { return kinds_[kind].left > 0; }
  void take(std::size_t kind) { --kinds_[kind].left, code_ -= kinds_[kind].weight; }
  void give_back(std::size_t kind) { ++kinds_[kind].left, code_ += kinds_[kind].weight; }
  bool empty() const { return code_ == 0; }
  // Whether some part of what is left has this sum of 4 - l.
  bool can_sum_to(int index) const {
    return least_ <= index && index <= most_ && sums_[static_cast<std::size_t>(code_)][static_cast<std::size_t>(index - least_)] != 0;
  }

 private:
  struct Kind {
    int valence;
    int left;
    int weight;
  };
  std::vector<Kind> kinds_;
  std::vector<std::vector<char>> sums_;
  int least_ = 0;
  int most_ = 0;
  int code_ = 0;
};

// How often a branch looks at the clock and tells of its progress.
constexpr std::int64_t kStatesBetweenLooks = 1024;

// What the branches of one search share.
struct Shared {
  int face_limit = kMostFaces;
  std::optional<Clock::time_point> deadline;
  std::function<void(std::int64_t)> progress;
  std::atomic<bool> stop{false};
  std::atomic<bool> face_limit_cut{false};
};

// The depth-first search. Copyable: a copy goes on from where the original stands, which is how branches are shared out.
class Filler {
 public:
  using Visit = std::function<void(const Filling&)>;
  using Fork = std::function<void(const Filler&, int)>;

  Filler(const std::vector<int>& irregular, Shared& shared) : budget_(irregular), shared_(&shared) {}

  // Preparation: vertices, the hole, faces that are there already.
  int add_vertex() {
    if (static_cast<std::size_t>(vertices_) == neighbours_.size()) neighbours_.emplace_back();
    neighbours_[static_cast<std::size_t>(vertices_)].clear();
    return vertices_++;
  }
  void add_edge(int a, int b) {
    neighbours_[static_cast<std::size_t>(a)].push_back(b);
    neighbours_[static_cast<std::size_t>(b)].push_back(a);
  }
  void add_face(const std::array<int, 4>& face) { faces_.push_back(face); }

  // The boundary of a hole, counter-clockwise (the hole on the left), with the number of quads each vertex still needs.
  struct Cell {
    int vertex;
    int need;
  };
  // Adds the first hole; returns its index, or nothing if it can not be filled.
  std::optional<int> open_hole(const std::vector<Cell>& cells) {
    const int start = static_cast<int>(cells_.size());
    cells_.insert(cells_.end(), cells.begin(), cells.end());
    const int hole = close_list(start, -1);
    return hole == kImpossible ? std::nullopt : std::optional(hole);
  }

  // Fills the holes of the list that starts at `hole` and calls visit for each filling. With a fork, branches that have
  // placed `fork_at` faces are handed to it instead of being followed.
  void run(int hole, const Visit& visit, int fork_at = 0, const Fork* fork = nullptr) {
    visit_ = &visit, fork_at_ = fork_at, fork_ = fork;
    states_ = 0;
    fill(hole);
  }

  std::int64_t states() const { return states_; }

 private:
  static constexpr int kNew = -1;
  static constexpr int kImpossible = -2;

  struct Hole {
    int start;
    int length;
    int next;  // the hole to fill after this one, -1 if none
  };
  // A hole's boundary from w round to v, where v -> w is the edge that the next quad takes: c(0) = w, ..., c(last) = v.
  // Corners x and y of the quad are given as places in it, or kNew.
  struct Chain {
    Hole hole;
    int first;
    int last;
  };

  Cell cell(const Hole& h, int i) const { return cells_[static_cast<std::size_t>(h.start) + static_cast<std::size_t>(i % h.length)]; }
  Cell at(const Chain& c, int i) const { return cell(c.hole, c.first + i); }
  bool adjacent(int a, int b) const {
    const auto& around = neighbours_[static_cast<std::size_t>(a)];
    return std::find(around.begin(), around.end(), b) != around.end();
  }

  void fill(int hole) {
    if (hole < 0) {
      if (budget_.empty() && *visit_) (*visit_)({vertices_, faces_});
      return;
    }
    if (fork_ != nullptr && static_cast<int>(faces_.size()) >= fork_at_) {
      (*fork_)(*this, hole);
      return;
    }
    if (++states_ % kStatesBetweenLooks == 0) {
      if (shared_->deadline && Clock::now() > *shared_->deadline) shared_->stop = true;
      if (shared_->progress) shared_->progress(kStatesBetweenLooks);
    }
    if (shared_->stop) return;

    const Hole h = holes_[static_cast<std::size_t>(hole)];
    // Of the hole's edges v -> w take the first with most ends that need one quad only: fewest choices.
    int best = 0;
    for (int i = 0, best_score = -1; i < h.length && best_score < 2; ++i) {
      const int score = (cell(h, i).need == 1 ? 1 : 0) + (cell(h, i + 1).need == 1 ? 1 : 0);
      if (score > best_score) best_score = score, best = i;
    }
    const Chain c{h, best + 1, h.length - 1};
    const Cell w = at(c, 0);
    if (w.need == 1) {
      choose_y(c, 1);  // the quad takes the next edge of the hole too
      return;
    }
    choose_y(c, kNew);
    // The sub-hole c(0) ... c(x) must be even, and c(1) would double the edge.
    for (int x = 3; x <= c.last - 2; x += 2) {
      if (!adjacent(w.vertex, at(c, x).vertex)) choose_y(c, x);
    }
  }

  // The corner y next to v, given the corner x next to w.
  void choose_y(const Chain& c, int x) {
    const Cell v = at(c, c.last);
    if (v.need == 1) {
      choose_valences(c, x, c.last - 1);
      return;
    }
    choose_valences(c, x, kNew);
    // The sub-hole c(y) ... c(last) must be even; last is odd.
    for (int y = x == kNew ? 2 : x + 1; y <= c.last - 3; y += 2) {
      if (!adjacent(v.vertex, at(c, y).vertex)) choose_valences(c, x, y);
    }
  }

  // Valences for the new ones of x and y: 4, or one of the budget.
  void choose_valences(const Chain& c, int x, int y) {
    if (x != kNew && y != kNew && y != x + 1 && adjacent(at(c, x).vertex, at(c, y).vertex)) return;
    if (static_cast<int>(faces_.size()) >= shared_->face_limit) {
      shared_->face_limit_cut = true;
      return;
    }
    if (x == kNew) {
      with_new_vertex([&](Cell new_x) {
        if (y == kNew) {
          with_new_vertex([&](Cell new_y) { choose_shares(c, x, y, new_x, new_y); });
        } else {
          choose_shares(c, x, y, new_x, {});
        }
      });
    } else if (y == kNew) {
      with_new_vertex([&](Cell new_y) { choose_shares(c, x, y, {}, new_y); });
    } else {
      choose_shares(c, x, y, {}, {});
    }
  }

  template <class Then>
  void with_new_vertex(Then&& then) {
    const int vertex = add_vertex();
    then(Cell{vertex, 3});
    for (std::size_t kind = 0; kind < budget_.kind_count(); ++kind) {
      if (!budget_.has(kind)) continue;
      budget_.take(kind);
      then(Cell{vertex, budget_.valence(kind) - 1});
      budget_.give_back(kind);
    }
    --vertices_;
  }

  // How the remaining quads of an old corner are shared between the sub-holes on its two sides. A side without a
  // sub-hole takes none, one with a sub-hole at least one.
  template <class Then>
  static void share(int rest, bool before, bool after, Then&& then) {
    if (!before && !after) {
      if (rest == 0) then(0, 0);
    } else if (!before) {
      if (rest >= 1) then(0, rest);
    } else if (!after) {
      if (rest >= 1) then(rest, 0);
    } else {
      for (int first = 1; first < rest; ++first) then(first, rest - first);
    }
  }

  void choose_shares(const Chain& c, int x, int y, Cell new_x, Cell new_y) {
    const bool a = x != kNew && x != 1;                   // sub-hole w ... x
    const bool z = y != kNew && y != c.last - 1;          // sub-hole y ... v
    const bool b = x == kNew || y == kNew || y != x + 1;  // what lies between, with the new corners
    const auto with_y = [&](int x_before, int x_after) {
      if (y == kNew) {
        place(c, x, y, new_x, new_y, {x_before, x_after, 0, 0}, a, b, z);
      } else {
        share(at(c, y).need - 1, b, z, [&](int y_before, int y_after) {
          place(c, x, y, new_x, new_y, {x_before, x_after, y_before, y_after}, a, b, z);
        });
      }
    };
    if (x == kNew) {
      with_y(0, 0);
    } else {
      share(at(c, x).need - 1, a, b, with_y);
    }
  }

  struct Shares {
    int x_before, x_after, y_before, y_after;
  };

  // Puts the quad v, w, x, y, replaces the hole by what is left of it, goes on, and takes everything back.
  void place(const Chain& c, int x, int y, Cell new_x, Cell new_y, Shares s, bool a, bool b, bool z) {
    const Cell w = at(c, 0);
    const Cell v = at(c, c.last);
    const int x_vertex = x == kNew ? new_x.vertex : at(c, x).vertex;
    const int y_vertex = y == kNew ? new_y.vertex : at(c, y).vertex;
    const std::size_t cells_before = cells_.size();
    const std::size_t holes_before = holes_.size();
    int list = c.hole.next;
    bool possible = true;

    const auto finish = [&](std::size_t start) {
      list = close_list(static_cast<int>(start), list);
      possible = list != kImpossible;
    };
    // Copies c(from..to) with the needs of its ends replaced.
    const auto copy = [&](int from, int from_need, int to, int to_need) {
      for (int i = from; i <= to; ++i) {
        Cell next = at(c, i);
        if (i == from) next.need = from_need;
        if (i == to) next.need = to_need;
        cells_.push_back(next);
      }
    };
    if (z) {
      const std::size_t start = cells_.size();
      copy(y, s.y_after, c.last, v.need - 1);
      finish(start);
    }
    if (possible && b) {
      const std::size_t start = cells_.size();
      const int from = x == kNew ? 0 : x;
      const int to = y == kNew ? c.last : y;
      copy(from, x == kNew ? w.need - 1 : s.x_after, to, y == kNew ? v.need - 1 : s.y_before);
      if (y == kNew) cells_.push_back({new_y.vertex, new_y.need});
      if (x == kNew) cells_.push_back({new_x.vertex, new_x.need});
      finish(start);
    }
    if (possible && a) {
      const std::size_t start = cells_.size();
      copy(0, w.need - 1, x, s.x_before);
      finish(start);
    }
    if (possible) {
      const bool edge_wx = x != 1;
      const bool edge_yv = y != c.last - 1;
      faces_.push_back({v.vertex, w.vertex, x_vertex, y_vertex});
      if (edge_wx) add_edge(w.vertex, x_vertex);
      if (b) add_edge(x_vertex, y_vertex);
      if (edge_yv) add_edge(y_vertex, v.vertex);
      if (face_limit_allows(list)) fill(list);
      if (edge_yv) remove_edge(y_vertex, v.vertex);
      if (b) remove_edge(x_vertex, y_vertex);
      if (edge_wx) remove_edge(w.vertex, x_vertex);
      faces_.pop_back();
    }
    cells_.resize(cells_before);
    holes_.resize(holes_before);
  }

  void remove_edge(int a, int b) {
    neighbours_[static_cast<std::size_t>(a)].pop_back();
    neighbours_[static_cast<std::size_t>(b)].pop_back();
  }

  // Makes the cells from `start` on a hole in front of the list `next`. kImpossible if parity or Gauss-Bonnet forbid it.
  int close_list(int start, int next) {
    const int length = static_cast<int>(cells_.size()) - start;
    if (length % 2 != 0) return kImpossible;
    int index = 4;
    for (int i = start; i < start + length; ++i) index -= 2 - cells_[static_cast<std::size_t>(i)].need;
    if (!budget_.can_sum_to(index)) return kImpossible;
    holes_.push_back({start, length, next});
    return static_cast<int>(holes_.size()) - 1;
  }

  bool face_limit_allows(int list) {
    int least = static_cast<int>(faces_.size());
    for (int hole = list; hole >= 0; hole = holes_[static_cast<std::size_t>(hole)].next) {
      least += std::max(holes_[static_cast<std::size_t>(hole)].length / 2 - 1, 1);
    }
    if (least <= shared_->face_limit) return true;
    shared_->face_limit_cut = true;
    return false;
  }

  Budget budget_;
  Shared* shared_;
  int vertices_ = 0;
  std::vector<std::vector<int>> neighbours_;
  std::vector<std::array<int, 4>> faces_;
  std::vector<Cell> cells_;   // of all holes, a stack
  std::vector<Hole> holes_;   // a stack; open ones are linked
  std::int64_t states_ = 0;
  const Visit* visit_ = nullptr;
  int fork_at_ = 0;
  const Fork* fork_ = nullptr;
};

// Runs a prepared filler on several threads: branches are shared out where they have placed a few faces.
std::int64_t run_parallel(const Filler& start, int hole, int faces_before, int threads, const Filler::Visit& visit) {
  Filler first = start;
  if (threads == 1) {
    first.run(hole, visit);
    return first.states();
  }
  constexpr int kFacesBeforeForking = 7;
  std::vector<std::pair<Filler, int>> branches;
  const Filler::Fork fork = [&branches](const Filler& filler, int at) { branches.emplace_back(filler, at); };
  first.run(hole, visit, faces_before + kFacesBeforeForking, &fork);
  std::atomic<std::int64_t> states{first.states()};
  std::optional<tbb::global_control> limit;
  if (threads > 0) limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::parallel_for(std::size_t{0}, branches.size(), [&](std::size_t i) {
    branches[i].first.run(branches[i].second, visit);
    states += branches[i].first.states();
  });
  return states;
}

void set_limits(Shared& shared, const SearchLimits& limits) {
  shared.face_limit = std::min(limits.faces.value_or(kMostFaces), kMostFaces);
  shared.progress = limits.progress;
  if (limits.seconds) shared.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*limits.seconds));
}

int positive_index(const std::vector<int>& irregular) {
  int sum = 0;
  for (const int l : irregular) sum += std::max(4 - l, 0);
  return sum;
}

}  // namespace

SearchProblem search_problem(const std::vector<int>& sides, std::vector<int> irregular) {
  SearchProblem problem{{}, std::move(irregular)};
  for (const int side : sides) {
    problem.interior_quads.push_back(1);
    problem.interior_quads.insert(problem.interior_quads.end(), static_cast<std::size_t>(std::max(side - 1, 0)), 2);
  }
  return problem;
}

std::string problem_with(const SearchProblem& problem) {
  if (problem.interior_quads.size() < 3) return "a boundary of " + std::to_string(problem.interior_quads.size()) + " edges encloses no simple mesh";
  for (const int quads : problem.interior_quads) {
    if (quads < 1) return "a boundary vertex with " + std::to_string(quads) + " interior quads; expected at least 1";
  }
  for (const int l : problem.irregular) {
    if (l < 2 || l == 4 || l > 100) return "irregular valence " + std::to_string(l) + " is not in 2, 3, 5..100";
  }
  return "";
}

bool may_be_infinite(const SearchProblem& problem) { return positive_index(problem.irregular) >= 4; }

mesh::Region region_of(const Filling& filling) {
  mesh::Region region{mesh::QuadMesh::from_faces(filling.vertices, filling.faces), {}};
  region.root = region.mesh.find_half_edge(mesh::VertexId(0), mesh::VertexId(1));
  return region;
}

SearchOutcome search(const SearchProblem& problem, const SearchLimits& limits, const std::function<void(const Filling&)>& visit) {
  if (const std::string what = problem_with(problem); !what.empty()) throw std::invalid_argument(what);
  Shared shared;
  set_limits(shared, limits);
  Filler filler(problem.irregular, shared);
  std::vector<Filler::Cell> cells;
  for (const int quads : problem.interior_quads) cells.push_back({filler.add_vertex(), quads});
  for (std::size_t i = 0; i < cells.size(); ++i) filler.add_edge(cells[i].vertex, cells[(i + 1) % cells.size()].vertex);

  SearchOutcome outcome;
  std::mutex mutex;
  const Filler::Visit record = [&](const Filling& filling) {
    {
      const std::scoped_lock lock(mutex);
      ++outcome.count;
      ++outcome.by_faces[static_cast<int>(filling.faces.size())];
    }
    if (visit) visit(filling);
  };
  // The whole budget has to fit, not only a part of it.
  int index = 4;
  for (const int quads : problem.interior_quads) index -= 2 - quads;
  for (const int l : problem.irregular) index -= 4 - l;
  if (index == 0) {
    if (const auto hole = filler.open_hole(cells)) outcome.states = run_parallel(filler, *hole, 0, limits.threads, record);
  }
  outcome.face_limit_cut = shared.face_limit_cut;
  outcome.out_of_time = shared.stop;
  return outcome;
}

CountedSearch count_fillings(const SearchProblem& problem, const SearchLimits& limits, bool keep_signatures) {
  CountedSearch counted;
  std::mutex mutex;
  // Sums of 1 / (orbit length) = (symmetries that fix the filling) / (symmetries of the boundary).
  std::int64_t fixed_by_rotations = 0, rotations = 1, fixed_by_all = 0, all = 1;
  counted.outcome = search(problem, limits, [&](const Filling& filling) {
    const mesh::Region region = region_of(filling);
    std::string own = mesh::signature(region);
    const auto rotated = mesh::rotated_signatures(region);
    const auto reflected = mesh::reflected_signatures(region);
    const auto fixing = std::count(rotated.begin(), rotated.end(), own);
    const auto fixing_reflections = std::count(reflected.begin(), reflected.end(), own);
    const std::scoped_lock lock(mutex);
    rotations = static_cast<std::int64_t>(rotated.size());
    all = static_cast<std::int64_t>(rotated.size() + reflected.size());
    fixed_by_rotations += fixing;
    fixed_by_all += fixing + fixing_reflections;
    if (keep_signatures) counted.signatures.push_back(std::move(own));
  });
  counted.orbits = {fixed_by_rotations / rotations, fixed_by_all / all};
  std::sort(counted.signatures.begin(), counted.signatures.end());
  return counted;
}

SphereOutcome search_spheres(std::vector<int> irregular, int vertices, const SearchLimits& limits) {
  std::sort(irregular.begin(), irregular.end());
  int index = 0;
  for (const int l : irregular) {
    if (l < 2 || l == 4 || l > 100) throw std::invalid_argument("irregular valence " + std::to_string(l) + " is not in 2, 3, 5..100");
    index += 4 - l;
  }
  if (index != 8) {
    throw std::invalid_argument("the indices 4 - l of the irregular valences sum to " + std::to_string(index) + ", but a sphere needs 8");
  }
  std::map<int, int> count;
  for (const int l : irregular) ++count[l];
  const int rarest = std::min_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first;

  SphereOutcome outcome;
  std::mutex mutex;
  std::set<std::string> oriented, unoriented;
  std::map<int, std::int64_t> oriented_counts, counts;
  const Filler::Visit record = [&](const Filling& filling) {
    const mesh::QuadMesh m = mesh::QuadMesh::from_faces(filling.vertices, filling.faces);
    std::string own = mesh::canonical_signature(m, mesh::Orientation::kept);
    std::string either = std::min(own, mesh::canonical_signature(m, mesh::Orientation::mirrored));
    const std::scoped_lock lock(mutex);
    if (oriented.insert(std::move(own)).second) ++oriented_counts[filling.vertices];
    if (unoriented.insert(std::move(either)).second) ++counts[filling.vertices];
  };

  Shared shared;
  set_limits(shared, limits);
  shared.face_limit = std::min(vertices - 2, kMostFaces);
  // One quad 0 1 2 3 with the rarest valence at 0; the hole is the outside, so its boundary runs 0 3 2 1. All valences
  // of the other corners are tried.
  std::vector<int> choices{4};
  for (const auto& [valence, number] : count) choices.push_back(valence);
  for (const int l1 : choices) {
    for (const int l2 : choices) {
      for (const int l3 : choices) {
        std::vector<int> rest = irregular;
        bool affordable = true;
        for (const int l : {rarest, l1, l2, l3}) {
          if (l == 4) continue;
          const auto it = std::find(rest.begin(), rest.end(), l);
          affordable = affordable && it != rest.end();
          if (it != rest.end()) rest.erase(it);
        }
        if (!affordable) continue;
        Filler filler(rest, shared);
        std::array<int, 4> corner{};
        for (int& v : corner) v = filler.add_vertex();
        for (std::size_t i = 0; i < 4; ++i) filler.add_edge(corner[i], corner[(i + 1) % 4]);
        filler.add_face(corner);
        const auto hole = filler.open_hole({{corner[0], rarest - 1}, {corner[3], l3 - 1}, {corner[2], l2 - 1}, {corner[1], l1 - 1}});
        if (hole) outcome.states += run_parallel(filler, *hole, 1, limits.threads, record);
      }
    }
  }
  outcome.counts = std::move(counts);
  outcome.oriented_counts = std::move(oriented_counts);
  outcome.signatures.assign(unoriented.begin(), unoriented.end());
  outcome.complete = !shared.stop;
  return outcome;
}

}  // namespace requad::enumerate
