// The fits of a reduction: they keep the mesh near the surface that it was at the start, and its quads good.
//
// Terms
//   surface   The mesh with its positions when the fits began.
//   region    What some edits affected (editing/affected_region.hpp). Each fit has one; affected() is that of the last.
//   bound     The largest hausdorff_distance() from the surface (ReduceOptions::max_deviation).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/editing/affected_region.hpp"
#include "mesh/editing/mirror.hpp"
#include "mesh/geometry/correspondence.hpp"
#include "mesh/geometry/fitting.hpp"
#include "mesh/irregular/reduce.hpp"

namespace requad::mesh {

class ReductionFit {
 public:
  // Editor, options and mirror (or null) must outlive it. The editor keeps a correspondence as long as it lives. With a
  // mirror, all fits but those after a transport leave a symmetric mesh. O(F log F).
  ReductionFit(Editor& editor, const ReduceOptions& options, const Mirror* mirror);
  ~ReductionFit() { editor_.keep(nullptr); }
  ReductionFit(const ReductionFit&) = delete;
  ReductionFit& operator=(const ReductionFit&) = delete;

  // The editor's mark at the start.
  std::size_t start() const { return start_; }
  const AffectedRegion& affected() const { return affected_; }
  // Finds the region of the edits since the mark, and fits nothing.
  void look_since(std::size_t mark, int rings) { affected_ = affected_region_since(editor_, around_, mark, rings); }

  // Fits round the edits since the mark: on the way, after some transports of a cancellation, so that nothing is lost; and
  // after the cancellation.
  void fit_on_the_way(std::size_t mark);
  void fit_made(std::size_t mark);
  // After a cancellation that turned out not to be acceptable, with more effort: round the inverted quads, or where there
  // are none, round all of it.
  void fit_again(std::size_t mark);
  // Fits round the inverted quads of the region, inside it, for good quads above all.
  void straighten();
  // Fits what was edited since the start, or everything if the options ask for it, as well as the bound allows. Takes
  // back what inverts more quads or lets them become worse than the options allow.
  void fit_in_the_end();

  // How many samples lose their face by the edits since the last fit. They are carried then. O(samples).
  std::size_t carry();

  // In units of length; infinite if there is none.
  double bound() const { return bound_; }
  // Of the whole mesh. O(F) queries of the nearest point.
  bool is_within_bound() const;
  // Whether something of the region uses more of the bound than a cancellation may, since later ones need some, too.
  bool is_too_far() const;
  // The largest distance in the region of samples from their homes, and of the corners and centres of faces from the
  // surface.
  double deviation() const;

  // The mean scaled Jacobian of all faces, now and at the start.
  double mean_quality() const;
  double input_quality() const { return input_quality_; }

 private:
  struct Reach {  // how far and how often a fit goes
    int rings;    // round what changed
    int rounds;
    bool joint;
  };
  static constexpr Reach kOnTheWay{4, 3, true};
  static constexpr Reach kWhenMade{4, 3, false};
  static constexpr Reach kAgain{12, 2, true};
  // In the end: good quads as far as the bound allows.
  static constexpr std::array<double, 4> kFinalQualities{kGoodQuads, 4 * kQualityWeight, kQualityWeight,
                                                         kQualityWeight / 4};

  const Positions& positions() const { return *editor_.positions(); }
  void fit_since(std::size_t mark, const Reach& reach);
  void fit_reached(std::span<const VertexId> vertices, const Reach& reach, double quality);
  std::span<const VertexId> inner() const;  // of the region
  std::vector<VertexId> near_inverted(int rings);
  void fit(std::span<const VertexId> vertices, const FitOptions& how);
  bool fit_in_the_end(double quality);
  void put_back_inverted(std::size_t mark);
  std::vector<FaceId> affected_faces() const;

  Editor& editor_;
  const QuadMesh& m_;
  const ReduceOptions& options_;
  const Mirror* mirror_;
  const QuadMesh input_;
  const Positions input_positions_;
  Correspondence homes_;
  SurfaceIndex surface_;
  FitOptions fitting_;
  double bound_ = 0;
  double input_quality_ = 0;
  std::size_t start_;
  BreadthFirstDistances around_;
  AffectedRegion affected_;
};

}  // namespace requad::mesh
