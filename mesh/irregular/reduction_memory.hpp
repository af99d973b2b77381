// What a reduction remembers of the cancellations that it tried, so that none is measured or made again in vain.
//
// Terms
//   pair      a v3 and a v5 that may cancel.
//   stage     the number of cancellations that were made.
//   where     of what was tried: the vertices that it met. It holds until a cancellation changes one of them.
//   plan      how a cancellation is made, which holds for one stage only: the ids of what it makes may be others later.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/topology/handles.hpp"

namespace requad::mesh {

class ReductionMemory {
 public:
  using Pair = std::pair<VertexId, VertexId>;  // the v3, the v5
  // Why a cancellation failed: it was refused, or it was made and was not acceptable (ReduceReport).
  enum class Reason { refused, unsymmetric, inward, folded, worn, too_far };
  struct Failure {
    int stage;
    Reason reason;
    std::vector<VertexId> where;
    Refusal refusal;  // if it was refused
  };

  int stage() const { return stage_; }
  // A cancellation was made. It changed or removed these vertices.
  void begin_stage(std::span<const std::vector<VertexId>* const> changed);

  // Whether the pair failed, and nothing where it went has changed since.
  bool would_fail(const Pair& pair) const;
  void fails(const Pair& pair, Reason reason, std::vector<VertexId> where, Refusal refusal = Refusal::none);
  const std::map<Pair, Failure>& failures() const { return failures_; }
  // Forgets the failures for this reason, or all. Returns whether there were any.
  bool forget(Reason reason);
  void forget_failures() { failures_.clear(); }

  // What the pair was found to cost, if nothing where it looked has changed since.
  std::optional<double> cost(const Pair& pair) const;
  void costs(const Pair& pair, double cost, std::vector<VertexId> where);
  void forget_costs() { estimates_.clear(); }

  // How the pair is cancelled, or null if that is not known at this stage.
  const Cancellation* plan(const Pair& pair) const;
  void plans(const Pair& pair, Cancellation plan) { plans_[pair] = std::move(plan); }
  // Something else than a cancellation has changed the mesh.
  void forget_plans() { plans_.clear(); }

 private:
  struct Estimate {
    int stage;
    double cost;
    std::vector<VertexId> where;
  };
  bool is_unchanged(const std::vector<VertexId>& where, int since) const;

  int stage_ = 0;
  std::map<Pair, Failure> failures_;
  std::map<Pair, Estimate> estimates_;
  std::map<Pair, Cancellation> plans_;
  std::vector<int> changed_at_;  // by vertex slot, the stage after the last cancellation that changed it
};

}  // namespace requad::mesh
