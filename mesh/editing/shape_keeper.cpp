#include "mesh/editing/shape_keeper.hpp"

#include "mesh/editing/affected_region.hpp"

namespace requad::mesh {

namespace {

constexpr int kFitRings = 2;
constexpr int kMoreRings = 8, kMoreRounds = 8;

}  // namespace

ShapeKeeper::ShapeKeeper(Editor& editor)
    : editor_(editor),
      surface_(editor.mesh(), *editor.positions()),
      homes_(editor.mesh(), *editor.positions()),
      tolerance_(kUsualTolerance * bounding_box_diagonal(editor.mesh(), *editor.positions())),
      inverted_(count_inverted(editor.mesh(), *editor.positions())) {
  editor.keep(&homes_);
}

void ShapeKeeper::fit(std::size_t mark, int rings, int rounds, bool joint) {
  FitOptions how;
  how.tolerance = tolerance_;
  how.rounds = rounds;
  how.joint = joint;
  const AffectedRegion affected = affected_region_since(editor_, distances_, mark, rings);
  editor_.fit(affected.near, surface_, how);
}

void ShapeKeeper::fit_transport(std::size_t mark) { fit(mark, kFitRings, 1, false); }

void ShapeKeeper::fit_since(std::size_t mark, int rounds) {
  fit(mark, kFitRings, rounds, false);
  const int inverted = count_inverted(editor_.mesh(), *editor_.positions());
  if (inverted <= inverted_) return;
  const std::size_t fitted = editor_.mark();
  fit(mark, kMoreRings, kMoreRounds, true);
  if (count_inverted(editor_.mesh(), *editor_.positions()) >= inverted) editor_.roll_back(fitted);
}

}  // namespace requad::mesh
