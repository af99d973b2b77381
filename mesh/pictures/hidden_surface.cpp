#include "mesh/pictures/hidden_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

#include "mesh/pictures/visible_parts.hpp"

namespace requad::pictures {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Corner = Piece::Corner;

constexpr double kSameDepth = 1e-4;       // points
constexpr double kNoCut = 1e-2;           // square points: a smaller part is not worth a cut
constexpr int kRounds = 6;                // of halving
constexpr std::size_t kMostParts = 5;     // parts for each triangle, after which nothing is cut any more
constexpr double kClearlyBefore = 1e-2;   // points
constexpr std::size_t kMostCells = 1024;  // of the grid, along a side

}  // namespace

// The parts that are to be painted, in a grid, and for pairs of them which one is behind the other.
struct HiddenSurface::State {
  std::vector<Part> parts;
  std::vector<std::pair<int, int>> behind;  // first is behind second
  std::vector<Piece> pieces;

  Vector2d low = Vector2d::Zero();
  double cell = 1;
  std::size_t columns = 1, rows = 1;
  std::vector<std::vector<int>> cells;
  std::vector<int> compared_with;  // by part: the last part that it was compared with
  std::size_t most_parts = 0;

  Part& part(int i) { return parts[static_cast<std::size_t>(i)]; }

  std::size_t column(double x) const {
    return std::min(columns - 1, static_cast<std::size_t>(std::max(0.0, (x - low.x()) / cell)));
  }
  std::size_t row(double y) const {
    return std::min(rows - 1, static_cast<std::size_t>(std::max(0.0, (y - low.y()) / cell)));
  }
  template <class Visit>
  void for_each_cell(const Part& p, Visit&& visit) {
    for (std::size_t j = row(p.low.y()); j <= row(p.high.y()); ++j) {
      for (std::size_t i = column(p.low.x()); i <= column(p.high.x()); ++i) visit(cells[j * columns + i]);
    }
  }

  void make_grid() {
    Vector2d high = low = parts.front().low;
    double size = 0;
    for (const Part& p : parts) {
      low = low.cwiseMin(p.low);
      high = high.cwiseMax(p.high);
      size += (p.high - p.low).maxCoeff();
    }
    cell = std::max(2 * size / static_cast<double>(parts.size()), (high - low).maxCoeff() / kMostCells);
    columns = static_cast<std::size_t>((high.x() - low.x()) / cell) + 1;
    rows = static_cast<std::size_t>((high.y() - low.y()) / cell) + 1;
    cells.assign(columns * rows, {});
  }

  void add_all(std::vector<Part> waiting);
  bool compare(int a, int b, std::vector<Part>& waiting);
  void cut(int i, const Vector2d& normal, const Vector2d& at, std::vector<Part>& waiting);
  void separate(int i);
  int unit(int i) const {
    const int sibling = parts[static_cast<std::size_t>(i)].sibling;
    return sibling < 0 ? i : std::min(i, sibling);
  }
  std::vector<std::pair<int, int>> behind_by_units() const;
  void break_circles();
  void order();
};

namespace {

// Whether a line along a side of `a` has all of `b` on its other side.
bool separates_sides(const Part& a, const Part& b) {
  for (std::size_t i = 0; i < a.outline.size(); ++i) {
    const Vector2d& p = a.outline[i].at;
    const Vector2d along = a.outline[(i + 1) % a.outline.size()].at - p;
    if (std::all_of(b.outline.begin(), b.outline.end(), [&](const Corner& c) { return cross(along, c.at - p) <= 0; }))
      return true;
  }
  return false;
}

Outline overlap_of(const Part& a, const Part& b) {
  Outline overlap = a.outline;
  for (std::size_t i = 0; i < b.outline.size() && !overlap.empty(); ++i) {
    const Vector2d& p = b.outline[i].at;
    const Vector2d along = b.outline[(i + 1) % b.outline.size()].at - p;
    overlap = clipped(overlap, [&](const Vector2d& q) { return cross(along, q - p); });
  }
  return overlap;
}

}  // namespace

// Adds parts in order, and cuts those that pass through others. What cuts make is added last.
void HiddenSurface::State::add_all(std::vector<Part> waiting) {
  for (std::size_t next = 0; next < waiting.size(); ++next) {
    const auto i = static_cast<int>(parts.size());
    parts.push_back(std::move(waiting[next]));
    compared_with.push_back(-1);
    // The other triangle may have been cut before this one came.
    if (const int sibling = part(i).sibling; sibling >= 0 && sibling < i && part(sibling).sibling != i)
      part(i).sibling = -1;
    std::vector<int> near;
    for_each_cell(part(i), [&](std::vector<int>& cell_parts) {
      std::erase_if(cell_parts, [this](int j) { return !part(j).live; });
      for (const int j : cell_parts) {
        if (std::exchange(compared_with[static_cast<std::size_t>(j)], i) != i) near.push_back(j);
      }
      cell_parts.push_back(i);
    });
    for (const int j : near) {
      if (part(j).live && !compare(i, j, waiting)) break;
    }
  }
}

// Decides which of two parts is behind the other; cuts one of them if neither is. Returns whether `a` is still there.
bool HiddenSurface::State::compare(int a, int b, std::vector<Part>& waiting) {
  const Part &p = part(a), &q = part(b);
  if ((p.low.array() >= q.high.array()).any() || (q.low.array() >= p.high.array()).any()) return true;
  if (separates_sides(p, q) || separates_sides(q, p)) return true;
  const Outline overlap = overlap_of(p, q);
  const double all = area(overlap);
  if (all < kNoOverlap) return true;
  const auto before = [&](const Vector2d& at) { return p.depth(at) - q.depth(at); };
  double most = -std::numeric_limits<double>::infinity(), least = -most;
  for (const Corner& c : overlap) {
    const double d = before(c.at);
    most = std::max(most, d);
    least = std::min(least, d);
  }
  if (most <= kSameDepth && least >= -kSameDepth) return true;
  bool a_in_front = least >= -kSameDepth;
  if (!a_in_front && most > kSameDepth) {
    const double front = area(clipped(overlap, before));
    a_in_front = front > all / 2;
    if (std::min(front, all - front) > kNoCut && parts.size() + waiting.size() < most_parts) {
      // The line where the two planes meet, by its normal and a point.
      const Vector2d normal = p.gradient - q.gradient;
      const Vector2d middle = p.outline.front().at;
      const Vector2d at = middle - before(middle) / normal.squaredNorm() * normal;
      const bool cut_a = area(p.outline) > area(q.outline);
      cut(cut_a ? a : b, normal, at, waiting);
      if (cut_a) return false;
      return true;  // the parts of b meet a when they are added
    }
  }
  behind.emplace_back(a_in_front ? b : a, a_in_front ? a : b);
  return true;
}

void HiddenSurface::State::separate(int i) {
  const int sibling = std::exchange(part(i).sibling, -1);
  if (sibling >= 0 && sibling < static_cast<int>(parts.size())) part(sibling).sibling = -1;
}

// Replaces a part by two, which wait to be added.
void HiddenSurface::State::cut(int i, const Vector2d& normal, const Vector2d& at, std::vector<Part>& waiting) {
  separate(i);
  for (const double sign : {1.0, -1.0}) {
    Outline half = clipped(part(i).outline, [&](const Vector2d& p) { return sign * normal.dot(p - at); });
    if (area(half) > 0) waiting.push_back(part(i).over(std::move(half)));
  }
  part(i).live = false;
}

std::vector<std::pair<int, int>> HiddenSurface::State::behind_by_units() const {
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [a, b] : behind) {
    if (!parts[static_cast<std::size_t>(a)].live || !parts[static_cast<std::size_t>(b)].live) continue;
    if (unit(a) != unit(b)) pairs.emplace_back(unit(a), unit(b));
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// Separates and halves parts that overlap in a circle.
void HiddenSurface::State::break_circles() {
  for (int round = 0; round <= kRounds; ++round) {
    const auto pairs = behind_by_units();
    const boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> graph(pairs.begin(), pairs.end(),
                                                                                  parts.size());
    std::vector<std::size_t> component(parts.size()), size(parts.size(), 0);
    boost::strong_components(
        graph, boost::make_iterator_property_map(component.begin(), boost::get(boost::vertex_index, graph)));
    for (const std::size_t c : component) ++size[c];
    std::vector<Part> waiting;
    bool any = false;
    for (int i = 0; i < static_cast<int>(component.size()); ++i) {
      if (size[component[static_cast<std::size_t>(i)]] < 2) continue;
      any = true;
      if (part(i).sibling >= 0) {
        separate(i);
        continue;
      }
      if (round == kRounds || parts.size() + waiting.size() >= most_parts) continue;
      const Vector2d extent = part(i).high - part(i).low;
      cut(i, extent.x() > extent.y() ? Vector2d::UnitX() : Vector2d::UnitY(), part(i).middle(), waiting);
    }
    if (!any) return;
    add_all(std::move(waiting));
  }
}

// Sorts the units, each after those that are behind it; among those that could be next, the farthest first.
void HiddenSurface::State::order() {
  const auto pairs = behind_by_units();
  std::vector<int> waits_for(parts.size(), 0);
  for (const auto& [a, b] : pairs) ++waits_for[static_cast<std::size_t>(b)];
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> ready;
  std::vector<Entry> all;
  std::vector<bool> done(parts.size(), false);
  for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
    if (!part(i).live || unit(i) != i) continue;
    all.emplace_back(part(i).depth(part(i).middle()), i);
    if (waits_for[static_cast<std::size_t>(i)] == 0) ready.push(all.back());
  }
  std::sort(all.begin(), all.end());
  const auto emit = [&](int i) {
    done[static_cast<std::size_t>(i)] = true;
    const Part& p = part(i);
    pieces.push_back({p.facet, p.front, p.outline});
    if (p.sibling >= 0) {
      // Both triangles: the corners of the other one, except the ends of the diagonal, stand beside the diagonal.
      Outline whole;
      const Part& other = part(p.sibling);
      for (const Corner& c : p.outline) {
        if (c.side >= 0) {
          whole.push_back(c);
          continue;
        }
        const auto diagonal =
            std::find_if(other.outline.begin(), other.outline.end(), [](const Corner& x) { return x.side < 0; });
        const auto k = static_cast<std::size_t>(diagonal - other.outline.begin());
        whole.push_back(other.outline[(k + 1) % 3]);
        whole.push_back(other.outline[(k + 2) % 3]);
      }
      pieces.back().outline = std::move(whole);
    }
    for (auto at = std::lower_bound(pairs.begin(), pairs.end(), std::pair(i, 0)); at != pairs.end() && at->first == i;
         ++at) {
      const int next = at->second;
      if (--waits_for[static_cast<std::size_t>(next)] == 0 && !done[static_cast<std::size_t>(next)])
        ready.emplace(part(next).depth(part(next).middle()), next);
    }
  };
  for (const Entry& farthest : all) {
    while (!ready.empty()) {
      const int i = ready.top().second;
      ready.pop();
      if (!done[static_cast<std::size_t>(i)]) emit(i);
    }
    if (!done[static_cast<std::size_t>(farthest.second)]) emit(farthest.second);  // a circle that was not broken
  }
}

HiddenSurface::HiddenSurface(const std::vector<Facet>& facets) {
  auto state = std::make_unique<State>();
  std::vector<Part> all;
  for (int f = 0; f < static_cast<int>(facets.size()); ++f) {
    for (Part& part : triangles_of(facets[static_cast<std::size_t>(f)], f)) all.push_back(std::move(part));
  }
  if (!all.empty()) {
    const DepthBuffer buffer(all);
    std::vector<bool> shows(facets.size(), false);
    for (const Part& part : all) {
      const auto f = static_cast<std::size_t>(part.facet);
      shows[f] = shows[f] || buffer.shows(part);
    }
    std::erase_if(all, [&](const Part& part) { return !shows[static_cast<std::size_t>(part.facet)]; });
    state->most_parts = kMostParts * all.size() + 1000;
    state->parts = std::move(all);
    state->make_grid();
    std::vector<Part> waiting = std::exchange(state->parts, {});
    for (std::size_t i = 0; i + 1 < waiting.size(); ++i) {
      // Two triangles of a facet that are seen from the same side do not overlap.
      Part &b = waiting[i], &c = waiting[i + 1];
      if (b.facet != c.facet || b.front != c.front) continue;
      b.sibling = static_cast<int>(i) + 1;
      c.sibling = static_cast<int>(i);
    }
    state->add_all(std::move(waiting));
    state->break_circles();
    state->order();
  }
  state_ = std::move(state);
}

HiddenSurface::~HiddenSurface() = default;
HiddenSurface::HiddenSurface(HiddenSurface&&) noexcept = default;
HiddenSurface& HiddenSurface::operator=(HiddenSurface&&) noexcept = default;

const std::vector<Piece>& HiddenSurface::pieces() const { return state_->pieces; }

bool HiddenSurface::covers(const Vector3d& point) const {
  if (state_->cells.empty()) return false;
  const Vector2d at = point.head<2>();
  // Whether a piece that lies before the point holds this place beside it.
  const auto is_covered = [&](const Vector2d& place) {
    for (const int i : state_->cells[state_->row(place.y()) * state_->columns + state_->column(place.x())]) {
      const Part& part = state_->parts[static_cast<std::size_t>(i)];
      if (!part.live || part.depth(at) < point.z() + kClearlyBefore) continue;
      bool inside = true;
      for (std::size_t k = 0; k < part.outline.size() && inside; ++k) {
        const Vector2d& p = part.outline[k].at;
        const Vector2d along = part.outline[(k + 1) % part.outline.size()].at - p;
        // A diagonal or a cut is no end of the surface.
        inside = cross(along, place - p) > (part.outline[k].side >= 0 ? kClearlyBefore * along.norm() : -1e-9);
      }
      if (inside) return true;
    }
    return false;
  };
  if (is_covered(at)) return true;
  // A point behind the edge between two pieces is behind neither, but what surrounds it is.
  constexpr double kBeside = 3 * kClearlyBefore;
  return is_covered(at + Vector2d(kBeside, kBeside / 2)) && is_covered(at + Vector2d(-kBeside / 2, kBeside)) &&
         is_covered(at + Vector2d(-kBeside, -kBeside / 2)) && is_covered(at + Vector2d(kBeside / 2, -kBeside));
}

}  // namespace requad::pictures
