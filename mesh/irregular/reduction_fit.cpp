#include "mesh/irregular/reduction_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "mesh/geometry/hausdorff_distance.hpp"
#include "mesh/topology/id_lists.hpp"

namespace requad::mesh {

ReductionFit::ReductionFit(Editor& editor, const ReduceOptions& options, const Mirror* mirror)
    : editor_(editor),
      m_(editor.mesh()),
      options_(options),
      mirror_(mirror),
      input_(m_),
      input_positions_(*editor.positions()),
      homes_(m_, input_positions_),
      surface_(m_, input_positions_),
      start_(editor.mark()) {
  editor.keep(&homes_);
  const double avoided = kUsualTolerance * bounding_box_diagonal(m_, input_positions_);
  bound_ = options.max_deviation >= 0 ? options.max_deviation
           : options.sweeps > 0       ? 4 * avoided
                                      : std::numeric_limits<double>::infinity();
  fitting_.tolerance = bound_ > 0 ? std::min(avoided, bound_ / 2) : avoided;
  fitting_.sweeps = std::max(options.sweeps, 1);
  fitting_.run = options.run;
  input_quality_ = mean_quality();
}

// --- fits ------------------------------------------------------------------------------------------------------------

void ReductionFit::fit_on_the_way(std::size_t mark) {
  // The other side follows when the cancellation is complete.
  const Mirror* mirror = std::exchange(mirror_, nullptr);
  fit_since(mark, kOnTheWay);
  mirror_ = mirror;
}

void ReductionFit::fit_made(std::size_t mark) { fit_since(mark, kWhenMade); }

void ReductionFit::fit_again(std::size_t mark) {
  affected_ = affected_region_since(editor_, around_, mark, kAgain.rings + 1);
  const std::vector<VertexId> near = near_inverted(kAgain.rings);
  fit_reached(near.empty() ? inner() : near, kAgain, kQualityWeight);
}

void ReductionFit::fit(std::span<const VertexId> vertices, const FitOptions& how) {
  editor_.fit(vertices, surface_, how);
  if (mirror_) mirror_->symmetrise(editor_, vertices);
}

std::span<const VertexId> ReductionFit::inner() const { return std::span(affected_.near).first(affected_.inner); }

void ReductionFit::fit_since(std::size_t mark, const Reach& reach) {
  affected_ = affected_region_since(editor_, around_, mark, reach.rings + 1);
  if (options_.sweeps > 0) fit_reached(inner(), reach, kQualityWeight);
}

void ReductionFit::fit_reached(std::span<const VertexId> vertices, const Reach& reach, double quality) {
  FitOptions how = fitting_;
  how.rounds = reach.rounds;
  how.joint = reach.joint;
  if (reach.joint) how.sweeps = std::min(how.sweeps, 1);  // the joint steps do the most
  how.quality = quality;
  fit(vertices, how);
}

// The inner vertices of the region within some rings of its inverted quads.
std::vector<VertexId> ReductionFit::near_inverted(int rings) {
  std::vector<VertexId> inside(inner().begin(), inner().end());
  std::sort(inside.begin(), inside.end());
  std::vector<VertexId> corners;
  for (const VertexId v : inside) {
    m_.for_each_out(v, [&](HalfEdgeId h) {
      if (is_inverted(m_, positions(), QuadMesh::face(h))) corners.push_back(v);
    });
  }
  if (corners.empty()) return {};
  const auto is_inside = [&](VertexId v) { return std::binary_search(inside.begin(), inside.end(), v); };
  around_.measure(m_, corners, is_inside, is_inside, [rings](VertexId, int d) { return d > rings; });
  return around_.met();
}

void ReductionFit::straighten() {
  constexpr Reach kNear{3, 5, false};
  const std::vector<VertexId> near = near_inverted(kNear.rings);
  if (!near.empty()) fit_reached(near, kNear, kGoodQuads);
}

void ReductionFit::fit_in_the_end() {
  for (const double quality : kFinalQualities) {
    if (fit_in_the_end(quality)) return;
  }
}

// In some rounds at a time. Where they invert a quad, its vertices go back to where they were. What leads beyond the
// bound or is worse than the options allow is taken back, up to the last rounds that are neither. Returns whether there
// are such.
bool ReductionFit::fit_in_the_end(double quality) {
  constexpr int kAtATime = 5;
  const double quality_before = mean_quality();
  const int inverted = count_inverted(m_, positions());
  std::size_t good = editor_.mark();
  bool any = false;
  for (int rounds = options_.final_rounds; rounds > 0; rounds -= kAtATime) {
    const Reach reach{kWhenMade.rings, std::min(kAtATime, rounds), true};
    if (options_.fit_all) {
      affected_ = {};
      affected_.near = m_.vertices();
      affected_.inner = affected_.near.size();
    } else {
      affected_ = affected_region_since(editor_, around_, start_, reach.rings + 1);
    }
    const std::size_t before = editor_.mark();
    fit_reached(inner(), reach, quality);
    if (!options_.allow_inverted && count_inverted(m_, positions()) > inverted) {
      straighten();
      put_back_inverted(before);
      if (mirror_) mirror_->symmetrise(editor_, m_.vertices());
      if (count_inverted(m_, positions()) > inverted) {
        editor_.roll_back(before);
        break;  // more rounds would do the same again
      }
    }
    if (!is_within_bound()) continue;
    const double now = mean_quality();
    if (options_.max_quality_loss >= 0 && now < input_quality_ - options_.max_quality_loss && now < quality_before)
      continue;
    good = editor_.mark();
    any = true;
  }
  editor_.roll_back(good);
  return any;
}

// Puts the corners of quads that have become inverted since the mark back to where they were, and those of quads that this
// inverts, until no quad is inverted that was not before. Precondition: only positions have changed.
void ReductionFit::put_back_inverted(std::size_t mark) {
  Positions before = positions();
  for (std::size_t i = editor_.mark(); i > mark; --i) {
    for (const Placement& p : editor_.edits()[i - 1].placements) before[p.vertex.slot()] = p.from;
  }
  for (std::vector<FaceId> faces = affected_faces(); !faces.empty();) {
    std::vector<VertexId> moved;
    for (const FaceId f : faces) {
      if (!is_inverted(m_, positions(), f) || is_inverted(m_, before, f)) continue;
      for (const VertexId v : m_.corners(f)) {
        if (!same_bits(positions()[v.slot()], before[v.slot()])) moved.push_back(v);
      }
    }
    sort_once(moved);
    editor_.rearrange(moved, [&](Positions& now) {
      for (const VertexId v : moved) now[v.slot()] = before[v.slot()];
    });
    faces = faces_round(m_, moved);
  }
}

std::size_t ReductionFit::carry() {
  const std::size_t before = homes_.mark();
  editor_.carry();
  return homes_.mark() - before;
}

// --- what is lost ----------------------------------------------------------------------------------------------------

bool ReductionFit::is_within_bound() const {
  return !std::isfinite(bound_) || (is_within({m_, positions()}, surface_, bound_) &&
                                    is_within({input_, input_positions_}, SurfaceIndex(m_, positions()), bound_));
}

bool ReductionFit::is_too_far() const {
  constexpr double kPart = 0.97;
  if (!std::isfinite(bound_)) return false;
  const double most = kPart * bound_;
  NearSurface near(surface_);
  for (const FaceId f : affected_faces()) {
    bool all = near.is_within(most, face_centre(m_, positions(), f));
    homes_.for_each_sample(f, [&](std::size_t i) { all = all && homes_.residual(m_, positions(), i).norm() <= most; });
    for_each_sample(m_, positions(), f, kUsualDensity,
                    [&](const Eigen::Vector3d& p) { all = all && near.is_within(most, p); });
    if (!all) return true;
  }
  return false;
}

// The faces at the inner vertices of the affected region.
std::vector<FaceId> ReductionFit::affected_faces() const {
  return faces_round(m_, std::span(affected_.near).first(affected_.inner));
}

double ReductionFit::deviation() const {
  double largest = 0;
  NearSurface near(surface_);
  for (const FaceId f : affected_faces()) {
    homes_.for_each_sample(
        f, [&](std::size_t i) { largest = std::max(largest, homes_.residual(m_, positions(), i).norm()); });
    largest = std::max(largest, near.distance(face_centre(m_, positions(), f)));
    for (const VertexId v : m_.corners(f)) largest = std::max(largest, near.distance(positions()[v.slot()]));
  }
  return largest;
}

double ReductionFit::mean_quality() const {
  double sum = 0;
  for (const FaceId f : m_.faces()) sum += scaled_jacobian(m_, positions(), f);
  return sum / m_.face_count();
}

}  // namespace requad::mesh
