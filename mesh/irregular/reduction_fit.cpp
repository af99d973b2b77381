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
  usual_bound_ = options.max_deviation >= 0 ? options.max_deviation : 4 * avoided;
  bound_ = usual_bound_;
  fitting_.tolerance = bound_ > 0 ? std::min(avoided, bound_ / 2) : avoided;
  fitting_.sweeps = std::max(options.sweeps, 1);
  input_quality_ = mean_quality();
}

// --- fits ------------------------------------------------------------------------------------------------------------

void ReductionFit::fit_transport(std::size_t mark) {
  // The other side follows when the cancellation is complete.
  const Mirror* mirror = std::exchange(mirror_, nullptr);
  const bool is_long = editor_.mark() - mark > kLongTransport;
  fit_since(mark, is_long ? kAfterLongTransport : kOnTheWay);
  mirror_ = mirror;
}

void ReductionFit::fit_made(std::size_t mark) { fit_since(mark, kWhenMade); }

void ReductionFit::fit_again(std::size_t mark) { fit_since(mark, kAgain); }

void ReductionFit::fit(std::span<const VertexId> vertices, const FitOptions& how) {
  editor_.fit(vertices, surface_, how);
  if (mirror_) mirror_->symmetrise(editor_, vertices);
}

void ReductionFit::fit_since(std::size_t mark, const Reach& reach) {
  affected_ = affected_region_since(editor_, around_, mark, reach.rings + 1);
  if (options_.sweeps > 0) fit_affected(reach, kQualityWeight);
}

void ReductionFit::fit_affected(const Reach& reach, double quality) {
  FitOptions how = fitting_;
  how.rounds = reach.rounds;
  how.joint = reach.joint;
  if (reach.joint) how.sweeps = std::min(how.sweeps, 1);  // the joint steps do the most
  how.quality = quality;
  fit(std::span(affected_.near).first(affected_.inner), how);
}

void ReductionFit::straighten() {
  constexpr int kRings = 3, kRounds = 5;
  std::vector<VertexId> inside(affected_.near.begin(),
                               affected_.near.begin() + static_cast<std::ptrdiff_t>(affected_.inner));
  std::sort(inside.begin(), inside.end());
  std::vector<VertexId> corners;
  for (const VertexId v : inside) {
    m_.for_each_out(v, [&](HalfEdgeId h) {
      if (is_inverted(m_, positions(), QuadMesh::face(h))) corners.push_back(v);
    });
  }
  if (corners.empty()) return;
  const auto is_inside = [&](VertexId v) { return std::binary_search(inside.begin(), inside.end(), v); };
  around_.measure(m_, corners, is_inside, is_inside, [](VertexId, int d) { return d > kRings; });
  const std::vector<VertexId> near = around_.met();
  FitOptions how = fitting_;
  how.rounds = kRounds;
  how.quality = kGoodQuads;
  fit(near, how);
}

void ReductionFit::fit_in_the_end() {
  const bool done = std::any_of(kFinalQualities.begin(), kFinalQualities.end(),
                                [this](double quality) { return fit_in_the_end(quality, usual_bound_); });
  // If nobody asked for the bound, the surface comes first.
  if (done || options_.max_deviation >= 0) return;
  lift_bound();
  fit_in_the_end(kQualityWeight, bound_);
}

// In some rounds at a time. What they make worse, or lead beyond the bound, is taken back, up to the last ones that did
// neither. Returns whether there are such.
bool ReductionFit::fit_in_the_end(double quality, double bound) {
  constexpr int kAtATime = 5;
  const int inverted = count_inverted(m_, positions());
  const double quality_before = mean_quality();
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
    fit_affected(reach, quality);
    if (!options_.allow_inverted && count_inverted(m_, positions()) > inverted) straighten();
    if ((!options_.allow_inverted && count_inverted(m_, positions()) > inverted) || !is_within(bound)) continue;
    const double now = mean_quality();
    if (options_.max_quality_loss >= 0 && now < input_quality_ - options_.max_quality_loss && now < quality_before)
      continue;
    good = editor_.mark();
    any = true;
  }
  editor_.roll_back(good);
  return any;
}

std::size_t ReductionFit::carry() {
  const std::size_t before = homes_.mark();
  editor_.carry();
  return homes_.mark() - before;
}

// --- what is lost ----------------------------------------------------------------------------------------------------

void ReductionFit::lift_bound() { bound_ = std::numeric_limits<double>::infinity(); }

bool ReductionFit::is_within(double bound) const {
  return !std::isfinite(bound) || hausdorff_distance({m_, positions()}, {input_, input_positions_}) <= bound;
}

bool ReductionFit::is_too_far() const {
  constexpr double kPart = 0.97;
  return std::isfinite(bound_) && (deviation() > kPart * bound_ || distance_from_surface() > kPart * bound_);
}

// The faces at the inner vertices of the affected region.
std::vector<FaceId> ReductionFit::affected_faces() const {
  return faces_round(m_, std::span(affected_.near).first(affected_.inner));
}

double ReductionFit::deviation() const {
  double largest = 0;
  const auto look = [&](const Eigen::Vector3d& p) { largest = std::max(largest, surface_.nearest(p).distance); };
  for (const FaceId f : affected_faces()) {
    homes_.for_each_sample(
        f, [&](std::size_t i) { largest = std::max(largest, homes_.residual(m_, positions(), i).norm()); });
    look(face_centre(m_, positions(), f));
    for (const VertexId v : m_.corners(f)) look(positions()[v.slot()]);
  }
  return largest;
}

// One side of the Hausdorff distance: that of the affected faces from the surface, at all samples.
double ReductionFit::distance_from_surface() const {
  double largest = 0;
  for (const FaceId f : affected_faces()) {
    for_each_sample(m_, positions(), f, kUsualDensity,
                    [&](const Eigen::Vector3d& p) { largest = std::max(largest, surface_.nearest(p).distance); });
  }
  return largest;
}

double ReductionFit::mean_quality() const {
  double sum = 0;
  for (const FaceId f : m_.faces()) sum += scaled_jacobian(m_, positions(), f);
  return sum / m_.face_count();
}

}  // namespace requad::mesh
