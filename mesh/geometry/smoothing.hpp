// Laplacian smoothing of chosen vertices, which are kept near the surface that they came from (section 8, "Smoothing").
//
// An iteration visits the vertices in the given order and moves each towards the mean of its neighbours, some of which
// it has moved already (Gauss-Seidel). So the guard sees the faces as they will be.
//
// A step of vertex v at p
//   1. target       The weighted mean of the neighbours. All weights are equal, or each is 1 / length of its edge.
//   2. constraint   The new point is p + step * (target - p). If `pull_to` is given, the point is moved to within
//                   `pull_distance` of the nearest of those points. If `project_to` is given, it is then moved to the
//                   nearest point of that surface.
//   3. guard        The step is refused if it makes a face at v worse and leaves its quality, the scaled_jacobian(), at
//                   the guard or below. It is then tried again with half the length, up to three times.
//
// Laws
//   geometry-3  Boundary vertices, vertices that `fixed` names, and vertices that are not given keep their positions to
//               the last bit.
//   geometry-4  With a guard g >= 0, the quality of no face falls from above g to g or below, and no quality at g or
//               below falls at all. So no face becomes inverted.
//   geometry-5  Without `project_to` and `pull_to`, a step stays in the convex hull of v and its neighbours.
// The result depends on the order of the vertices, and on nothing else.
// Cost: O(valence) and the constraint's queries for each vertex and iteration, whatever the size of the mesh.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "mesh/geometry/measures.hpp"
#include "mesh/geometry/nearest_points.hpp"
#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

enum class SmoothingWeights { uniform, chord };

struct SmoothingOptions {
  int iterations = 10;
  SmoothingWeights weights = SmoothingWeights::uniform;
  double step = 1;                      // in (0, 1]
  std::optional<double> guard = 0.1;    // nothing: every step is made
  std::function<bool(VertexId)> fixed;  // whether an interior vertex must not move; empty: all may move
  const SurfaceIndex* project_to = nullptr;
  const PointIndex* pull_to = nullptr;  // usually the vertices of the original mesh
  double pull_distance = 0;
};

// Precondition: the vertices are live. A vertex that is given twice moves twice in each iteration.
void smooth(const QuadMesh& mesh, Positions& positions, std::span<const VertexId> vertices,
            const SmoothingOptions& options);

}  // namespace requad::mesh
