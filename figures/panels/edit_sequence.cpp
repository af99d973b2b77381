#include "figures/panels/edit_sequence.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "figures/panels/sheet.hpp"
#include "mesh/files/read_polygons.hpp"
#include "mesh/irregular/atomic_operations.hpp"
#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/irregular/possible_moves.hpp"
#include "mesh/irregular/reduce.hpp"

namespace requad::figures {

using mesh::Refusal;
using mesh::VertexId;

int Stage::count(int valence) const {
  const std::vector<VertexId> all = mesh.vertices();
  return static_cast<int>(std::count_if(
      all.begin(), all.end(), [&](VertexId v) { return !mesh.is_boundary(v) && mesh.valence(v) == valence; }));
}

int Stage::irregular() const { return static_cast<int>(mesh::irregular_vertices(mesh).size()); }

EditSequence::EditSequence(mesh::Surface surface, double feature_angle)
    : mesh_(std::move(surface.mesh)),
      positions_(std::move(surface.positions)),
      editor_(mesh_, &features_, &positions_, &plan_) {
  if (feature_angle > 0) {
    for (const auto& [a, b] : mesh::sharp_edges(mesh_, positions_, feature_angle)) features_.insert(a, b);
  }
  plan_ = mesh::plan_by_angles(mesh_, features_, positions_);
}

EditSequence::EditSequence(const char* obj, double feature_angle)
    : EditSequence(mesh::to_surface(mesh::parse_obj(obj, "example"), false), feature_angle) {}

Stage EditSequence::stage() const { return {mesh_, positions_, features_.edges()}; }

VertexId EditSequence::vertex(int number) const { return mesh_.vertices().at(static_cast<std::size_t>(number) - 1); }

std::size_t EditSequence::begin() {
  if (!shape_) shape_.emplace(editor_);
  return editor_.mark();
}

void EditSequence::make(const std::string& name, VertexId from, VertexId to) {
  const std::size_t mark = begin();
  const mesh::AtomicOperation operation{mesh::parse_atomic_name(name).value(), mesh_.find_half_edge(from, to)};
  require_performed(mesh::perform(editor_, operation).refusal);
  shape_->fit_since(mark);
}

void EditSequence::move(const std::string& step, VertexId a, VertexId b) {
  const std::size_t mark = begin();
  bool made = false;
  require_performed(mesh::for_each_move(editor_, a, b, [&](const mesh::PossibleMove& move) {
    made = move.is_called(step) && move.refusal == Refusal::none;
    return made;
  }));
  if (!made) throw std::logic_error("a figure's move cannot be made: " + step);
  shape_->fit_since(mark);
}

void EditSequence::cancel(VertexId three, VertexId five, const std::vector<VertexId>& helpers) {
  const std::size_t mark = begin();
  mesh::PairTransport transport(editor_);
  require_performed(mesh::cancel_pair(editor_, transport, three, five, helpers, [this](std::size_t made) {
                      shape_->fit_transport(made);
                    }).refusal);
  shape_->fit_since(mark);
}

void EditSequence::part() {
  const std::size_t mark = begin();
  mesh::part_all(editor_);
  shape_->fit_since(mark);
}

std::array<VertexId, 2> EditSequence::align(VertexId a, VertexId b) {
  const std::size_t mark = begin();
  const mesh::PairResult result = mesh::align_pair(editor_, a, b);
  require_performed(result.refusal);
  shape_->fit_since(mark);
  return {result.frame.v1, result.frame.v2};
}

std::vector<Stage> EditSequence::reduce(const std::vector<int>& at) {
  shape_.reset();
  editor_.forget();
  std::vector<Stage> stages;
  mesh::ReduceOptions how;
  how.progress = [&](int irregular) {
    while (stages.size() < at.size() && irregular <= at[stages.size()]) stages.push_back(stage());
  };
  mesh::reduce(editor_, how);
  editor_.forget();
  return stages;
}

}  // namespace requad::figures
