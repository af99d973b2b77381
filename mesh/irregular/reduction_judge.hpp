// Whether a cancellation of a reduction may stay.
#pragma once

#include "mesh/irregular/reduction_fit.hpp"
#include "mesh/irregular/reduction_memory.hpp"
#include "mesh/irregular/reduction_values.hpp"

namespace requad::mesh {

class ReductionJudge {
 public:
  // All must outlive it.
  ReductionJudge(ReductionFit& fit, const ReductionValues& values, const ReduceOptions& options)
      : fit_(fit), values_(values), options_(options) {}

  // Fits what was made since the mark until it is acceptable, or there seems to be no hope. Returns whether it is.
  // careful: with more effort.
  bool accepts(std::size_t mark, bool careful);
  // Whether what was made since the mark has inverted so many quads that it will not be acceptable in the end.
  bool is_lost(std::size_t mark);
  // Why the last one is not acceptable.
  ReductionMemory::Reason reason() const { return reason_; }

 private:
  bool is_acceptable();
  bool is_acceptable_straightened();
  bool is_worn(const ReductionValue& change) const;
  double how_far_from_acceptable() const;

  ReductionFit& fit_;
  const ReductionValues& values_;  // of the mesh before the cancellation
  const ReduceOptions& options_;
  ReductionMemory::Reason reason_ = ReductionMemory::Reason::refused;
  int inverted_ = 0;  // faces, in the affected region, beside those before
};

}  // namespace requad::mesh
