// Laplacian smoothing of chosen vertices, held to the surface they came from (the paper's section 8, "Smoothing").
//
// One iteration visits the vertices in the order given and moves each towards the mean of its neighbours, from where
// the vertices before it have come to (Gauss-Seidel). So a step sees the faces as they will be, which the guard needs;
// and the result depends on the order and on nothing else.
//
// A step of v, from p
//   1. target   the weighted mean of the neighbours: all weights alike, or 1 / length of the edge (chord-length).
//   2. held     the point p + step * (target - p), pulled to within `pull_distance` of the nearest point of `pull_to`,
//               then moved to the nearest point of `project_to`, if these are given.
//   3. guard    refused if a face at v would become worse and be at the guard's quality or below (scaled_jacobian);
//               then tried again with half the step, three times at most.
//
// Laws
//   S1  Vertices of the boundary, those that `fixed` names and those not given keep their positions to the last bit.
//   S2  With a guard g >= 0, no face above g comes to g or below, and none at g or below gets worse. So none becomes
//       inverted.
//   S3  Without a surface to project on and points to pull to, a step stays in the convex hull of v and its neighbours.
// Cost: O(valence) for each vertex and iteration, and a query for what it is held to; the mesh's size does not matter.
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
  std::optional<double> guard = 0.1;    // none: every step is taken
  std::function<bool(VertexId)> fixed;  // of interior vertices: those on features; none if empty
  const SurfaceIndex* project_to = nullptr;
  const PointIndex* pull_to = nullptr;  // the original mesh's vertices
  double pull_distance = 0;
};

// Precondition: the vertices are live. A vertex given twice moves twice.
void smooth(const QuadMesh& mesh, Positions& positions, std::span<const VertexId> vertices,
            const SmoothingOptions& options);

}  // namespace requad::mesh
