// What the vertices of a mesh add to the sums that a reduction watches, remembered from one cancellation to the next. So
// what a cancellation changes is known from its affected region alone.
#pragma once

#include <vector>

#include "mesh/editing/affected_region.hpp"

namespace requad::mesh {

// What a vertex adds; of what its faces add, a quarter of each. Or a difference between two meshes.
struct ReductionValue {
  double curvature = 0;  // |discrete mean curvature|; 0 unless it is asked for
  double quality = 0;    // scaled Jacobians
  int inverted = 0;      // corners of inverted faces
  int irregular = 0;
  int inside = 0;  // irregular and free

  ReductionValue& operator+=(const ReductionValue& o);
  ReductionValue& operator-=(const ReductionValue& o);
};

class ReductionValues {
 public:
  // The editor must outlive it, and has positions.
  ReductionValues(const Editor& editor, bool curvature) : editor_(editor), curvature_(curvature) {}

  // Remembers the mesh as it is: all of it, or a region since it was remembered last. O(what is remembered).
  void remember_all();
  void remember(const AffectedRegion& region);

  // Of the mesh that is remembered.
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
