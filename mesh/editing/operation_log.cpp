#include "mesh/editing/operation_log.hpp"

namespace requad::mesh {

Applied OperationLog::run(const BasicOperation& operation) {
  const Applied done = apply(mesh_, operation);
  if (done.refusal == Refusal::none) operations_.push_back({operation, done.inverse});
  return done;
}

void OperationLog::roll_back_last() {
  take_back(mesh_, operations_.back().inverse);
  operations_.pop_back();
}

void OperationLog::roll_back(std::size_t mark) {
  while (operations_.size() > mark) roll_back_last();
}

}  // namespace requad::mesh
