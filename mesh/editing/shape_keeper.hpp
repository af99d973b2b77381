// Keeps the shape of a mesh while it is edited: after edits, vertices round them are fitted to the mesh as it was.
#pragma once

#include <cstddef>

#include "mesh/editing/editor.hpp"
#include "mesh/geometry/correspondence.hpp"
#include "mesh/geometry/nearest_points.hpp"
#include "mesh/topology/distances.hpp"

namespace requad::mesh {

// Takes the surface that the editor's mesh is at the start, and keeps a correspondence with it (Editor::keep()).
class ShapeKeeper {
 public:
  static constexpr int kUsualRounds = 4;

  // Preconditions: the editor has positions and outlives the keeper; its mesh has a face. O(F log F).
  explicit ShapeKeeper(Editor& editor);
  ~ShapeKeeper() { editor_.keep(nullptr); }
  ShapeKeeper(const ShapeKeeper&) = delete;
  ShapeKeeper& operator=(const ShapeKeeper&) = delete;

  // The surface.
  const SurfaceIndex& surface() const { return surface_; }

  // Fits round what the edits since the mark changed, in so many rounds (fitting.hpp). If more faces are inverted then
  // than on the surface, fits more vertices, and takes that back if it does not help. O(F).
  void fit_since(std::size_t mark, int rounds = kUsualRounds);
  // The same after one of several transports: one round, and no look at faces elsewhere. O(size of the change).
  void fit_transport(std::size_t mark);

 private:
  void fit(std::size_t mark, int rings, int rounds, bool joint);

  Editor& editor_;
  SurfaceIndex surface_;
  Correspondence homes_;
  double tolerance_;
  int inverted_;  // of the surface
  BreadthFirstDistances distances_;
};

}  // namespace requad::mesh
