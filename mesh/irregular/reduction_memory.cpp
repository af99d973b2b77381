#include "mesh/irregular/reduction_memory.hpp"

#include <algorithm>

namespace requad::mesh {

void ReductionMemory::begin_stage(std::span<const std::vector<VertexId>* const> changed) {
  ++stage_;
  plans_.clear();
  for (const std::vector<VertexId>* some : changed) {
    for (const VertexId v : *some) {
      if (v.slot() >= changed_at_.size()) changed_at_.resize(v.slot() + 1);
      changed_at_[v.slot()] = stage_;
    }
  }
}

bool ReductionMemory::is_unchanged(const std::vector<VertexId>& where, int since) const {
  return std::all_of(where.begin(), where.end(),
                     [&](VertexId v) { return v.slot() >= changed_at_.size() || changed_at_[v.slot()] <= since; });
}

bool ReductionMemory::would_fail(const Pair& pair) const {
  const auto known = failures_.find(pair);
  return known != failures_.end() && is_unchanged(known->second.where, known->second.stage);
}

void ReductionMemory::fails(const Pair& pair, Reason reason, std::vector<VertexId> where, Refusal refusal) {
  failures_[pair] = {stage_, reason, std::move(where), refusal};
}

bool ReductionMemory::forget(Reason reason) {
  return std::erase_if(failures_, [reason](const auto& known) { return known.second.reason == reason; }) > 0;
}

std::optional<double> ReductionMemory::cost(const Pair& pair) const {
  const auto known = estimates_.find(pair);
  if (known == estimates_.end() || !is_unchanged(known->second.where, known->second.stage)) return std::nullopt;
  return known->second.cost;
}

void ReductionMemory::costs(const Pair& pair, double cost, std::vector<VertexId> where) {
  estimates_[pair] = {stage_, cost, std::move(where)};
}

const Cancellation* ReductionMemory::plan(const Pair& pair) const {
  const auto known = plans_.find(pair);
  return known == plans_.end() ? nullptr : &known->second;
}

}  // namespace requad::mesh
