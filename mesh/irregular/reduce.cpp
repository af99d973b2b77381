#include "mesh/irregular/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <span>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "mesh/editing/affected_region.hpp"
#include "mesh/editing/untangling.hpp"

namespace requad::mesh {

namespace {

constexpr int kPartners = 3;  // candidates looked for at each vertex
constexpr int kHelpers = 8;   // third vertices offered to a cancellation
constexpr int kRings = 2;     // smoothed round what a cancellation changed; one more is measured

struct Candidate {
  double cost;
  VertexId three;
  VertexId five;
  int measured_at;                            // the number of cancellations then
  bool operator<(const Candidate& o) const {  // for a heap: the cheapest first, then by ids
    return std::tie(cost, three, five) > std::tie(o.cost, o.three, o.five);
  }
};

class Reducer {
 public:
  Reducer(Editor& editor, const ReduceOptions& options)
      : editor_(editor), m_(editor.mesh()), options_(options), transport_(editor) {
    smoothing_.iterations = options.smoothing_iterations;
    smoothing_.weights = SmoothingWeights::uniform;
    smoothing_.project_to = options.surface;
  }

  ReduceReport run() {
    if (options_.max_deviation >= 0 && options_.surface == nullptr)
      throw std::invalid_argument("reduce: max_deviation needs a surface");
    report_.before = count_irregular();
    report_.after = report_.before;
    for (bool progress = true; progress && report_.after > options_.until;) {
      // Where nothing can be cancelled, parting would only make more irregular vertices.
      if (!editor_.sectors().is_minimal()) report_.parted += part_all(editor_);
      values_.assign(static_cast<std::size_t>(m_.vertex_capacity()), 0);
      irregular_.assign(values_.size(), false);
      report_.after = 0;
      for (const VertexId v : m_.vertices()) remember(v);
      // Everything is tried again as long as something succeeds: what was refused once may have become possible.
      progress = false;
      report_.refusals.clear();
      report_.too_far = 0;
      queue_ = {};
      for (const VertexId v : m_.vertices()) add_candidates(v);
      while (!queue_.empty() && report_.after > options_.until) {
        if (!take_cheapest()) continue;
        progress = true;
        if (options_.progress) options_.progress(report_.after);
      }
    }
    smoothing_.iterations = options_.final_iterations;
    editor_.smooth(m_.vertices(), smoothing_);
    // Untangling may lead far along the surface.
    if (options_.final_iterations > 0 && options_.max_deviation < 0) untangle(editor_, smoothing_);
    report_.minimal = editor_.sectors().is_minimal();
    return report_;
  }

 private:
  bool is_three(VertexId v) const { return m_.is_live(v) && editor_.sectors().lacks(v); }
  bool is_five(VertexId v) const { return m_.is_live(v) && editor_.sectors().exceeds(v); }
  bool is_irregular(VertexId v) const { return editor_.sectors().is_irregular(v); }
  const Positions& positions() const { return *editor_.positions(); }

  int count_irregular() const {
    const std::vector<VertexId> all = m_.vertices();
    return static_cast<int>(std::count_if(all.begin(), all.end(), [this](VertexId v) { return is_irregular(v); }));
  }

  // Pairs of v with its nearest partners of opposite index.
  void add_candidates(VertexId v) {
    if (is_three(v)) {
      for (const VertexId w : nearest(editor_, around_, v, kPartners, [this](VertexId x) { return is_five(x); }))
        add(v, w);
    }
    if (is_five(v)) {
      for (const VertexId w : nearest(editor_, around_, v, kPartners, [this](VertexId x) { return is_three(x); }))
        add(w, v);
    }
  }
  void add(VertexId three, VertexId five) {
    const std::size_t mark = editor_.mark();
    double cost = 0;
    if (make(three, five, cost)) queue_.push({cost, three, five, report_.cancelled});
    editor_.roll_back(mark);
  }

  // Cancels the pair and smooths. Leaves the mesh as it was if this is refused.
  bool make(VertexId three, VertexId five, double& cost) {
    ++report_.measured;
    const std::size_t mark = editor_.mark();
    const auto helpers =
        nearest(editor_, around_, three, kHelpers, [&](VertexId v) { return v != five && is_irregular(v); });
    last_ = cancel_pair(editor_, transport_, three, five, helpers);
    if (last_.refusal != Refusal::none) {
      ++report_.refusals[last_.refusal];
      return false;
    }
    affected_ = affected_region_since(editor_, around_, mark, kRings + 1);
    editor_.smooth(std::span(affected_.near).first(affected_.inner), smoothing_);
    if (deviation() > options_.max_deviation && options_.max_deviation >= 0) {
      ++report_.too_far;
      editor_.roll_back(mark);
      return false;
    }
    cost = 0;
    for (const VertexId v : affected_.near) {
      cost += value(v);
      // A vertex that was made has no value yet. Another one that had its id counts as removed.
      if (v.slot() < values_.size()) cost -= values_[v.slot()];
    }
    for (const VertexId v : affected_.removed) cost -= v.slot() < values_.size() ? values_[v.slot()] : 0;
    return true;
  }

  // The largest distance of the centre of a changed face from the surface.
  double deviation() const {
    double largest = 0;
    if (options_.max_deviation < 0) return largest;
    for (const VertexId v : std::span(affected_.near).first(affected_.inner)) {
      m_.for_each_out(v, [&](HalfEdgeId h) {
        const Eigen::Vector3d centre = face_centre(m_, positions(), QuadMesh::face(h));
        largest = std::max(largest, options_.surface->nearest(centre).distance);
      });
    }
    return largest;
  }

  // What a vertex adds to the cost of the mesh.
  double value(VertexId v) const {
    if (options_.cost == ReduceCost::curvature) return std::abs(mean_curvature(m_, positions(), v));
    double sum = 0;
    m_.for_each_out(v, [&](HalfEdgeId h) {
      const FaceId f = QuadMesh::face(h);
      sum += (1 - scaled_jacobian(m_, positions(), f)) * area(m_, positions(), f);
    });
    return sum / 4;
  }

  // Remembers the value that a vertex has before the next cancellation.
  void remember(VertexId v) {
    if (v.slot() >= values_.size()) {
      values_.resize(v.slot() + 1, 0);
      irregular_.resize(v.slot() + 1, false);
    }
    values_[v.slot()] = m_.is_live(v) ? value(v) : 0;
    const bool irregular = m_.is_live(v) && is_irregular(v);
    report_.after += static_cast<int>(irregular) - static_cast<int>(irregular_[v.slot()]);
    irregular_[v.slot()] = irregular;
  }

  // Makes the cheapest candidate, provided that it is still the cheapest when it is measured again.
  bool take_cheapest() {
    Candidate c = queue_.top();
    queue_.pop();
    if (!is_three(c.three) || !is_five(c.five)) return false;
    const std::size_t mark = editor_.mark();
    if (!make(c.three, c.five, c.cost)) return false;
    if (c.measured_at != report_.cancelled && !queue_.empty() && c.cost > queue_.top().cost) {
      editor_.roll_back(mark);
      c.measured_at = report_.cancelled;
      queue_.push(c);
      return false;
    }
    ++report_.cancelled;
    report_.transports += last_.transports;
    report_.operations += last_.steps;
    for (const VertexId v : affected_.removed) remember(v);
    for (const VertexId v : affected_.near) remember(v);
    const std::vector<VertexId> changed = std::move(affected_.changed);
    for (const VertexId v : changed) add_candidates(v);
    return true;
  }

  Editor& editor_;
  const QuadMesh& m_;
  const ReduceOptions& options_;
  PairTransport transport_;
  BreadthFirstDistances around_;
  SmoothingOptions smoothing_;
  std::priority_queue<Candidate> queue_;
  ReduceReport report_;
  Cancellation last_;            // of make()
  AffectedRegion affected_;      // of make()
  std::vector<double> values_;   // by vertex slot, of the mesh after the last cancellation
  std::vector<bool> irregular_;  // likewise
};

}  // namespace

ReduceReport reduce(Editor& editor, const ReduceOptions& options) { return Reducer(editor, options).run(); }

}  // namespace requad::mesh
