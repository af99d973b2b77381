// What each vertex of a mesh adds to the sums that a reduction watches. It is remembered from one cancellation to the
// next, so that the effect of a cancellation is computed from its affected region alone.
#pragma once

#include <vector>

#include "mesh/editing/affected_region.hpp"

namespace requad::mesh {

// What one vertex adds, or a sum or difference of such values.
struct ReductionValue {
  double curvature = 0;  // |integrated mean curvature|; 0 unless it is asked for
  double quality = 0;    // a quarter of the scaled Jacobian of each of its faces
  int inverted = 0;      // inverted faces at it
  int irregular = 0;
  int inside = 0;  // irregular, and not fixed (Editor::is_fixed)

  ReductionValue& operator+=(const ReductionValue& o);
  ReductionValue& operator-=(const ReductionValue& o);
};

class ReductionValues {
 public:
  // The editor must outlive this object and have positions.
  ReductionValues(const Editor& editor, bool curvature) : editor_(editor), curvature_(curvature) {}

  // Remembers the mesh as it is: all of it, or the region outside which nothing has changed since. O(what is
  // remembered).
  void remember_all();
  void remember(const AffectedRegion& region);

  // Of the mesh that is remembered. Precondition: there is one.
  int irregular() const { return sum_.irregular; }
  double mean_quality() const { return sum_.quality / faces_; }
  // The mean quality of the present mesh, which differs from the remembered one by this change.
  double mean_quality_after(const ReductionValue& change) const;
  // What the region adds now, less what it added to the mesh that is remembered. O(region).
  ReductionValue change(const AffectedRegion& region) const;

 private:
  ReductionValue value(VertexId v) const;
  void remember(VertexId v);

  const Editor& editor_;
  bool curvature_;
  ReductionValue sum_;
  int faces_ = 0;
  std::vector<ReductionValue> values_;  // by vertex slot
};

}  // namespace requad::mesh
