// Fitting: moves vertices of an edited mesh so that it covers the surface that it came from, with quads of good shape.
//
// The energy of a face f is a number without unit:
//   E(f) = sum of distance(s) over the samples s at home on f (correspondence.hpp)
//          + quality / 4 * sum of shape(c) over the corners c of f (quad_shape.hpp),
//             with the mean normal and the mean area of those samples
//   distance(s) = weight * (along * |r|^2 + (1 - along) * (n . r)^2) * (1 + |r|^2 / (2 tolerance^2))
//             for the residual r of a sample with normal n
// A vertex adds the same for its nearest point on the surface, with small constants for weight and along. So both sides
// of the distance count: the samples of the surface pull the mesh over whatever sticks out of it, and where a vertex has
// few samples near it, the surface pulls that vertex.
//
// A sweep visits each vertex once. The vertex makes a step of Newton's method on the energy of its faces. Vertices that
// have no face together are visited at the same time, if there are threads. A joint step is one step of Newton's method
// for all vertices at once, whose linear equations are solved roughly. Steps are halved until the energy falls.
//
// Laws
//   geometry-9   Boundary vertices, vertices that `fixed` names, and vertices that are not given keep their positions
//                to the last bit.
//   geometry-10  No sweep and no joint step raises the sum of the energies, with the homes, the nearest points and the
//                ideals of faces as they are.
//   geometry-11  The result is the same, to the last bit, whatever the threads.
// Costs: about 5 microseconds for each vertex and sweep, O(valence) in memory; for a joint step some tens of products of a
// vector with a sparse matrix of three rows for each vertex.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "mesh/geometry/correspondence.hpp"
#include "mesh/geometry/in_chunks.hpp"
#include "mesh/geometry/nearest_points.hpp"

namespace requad::mesh {

// What the shape of one quad counts for, beside one quad's distance of its own size from the surface, which counts 1.
inline constexpr double kQualityWeight = 0.05;
// The same where good quads matter more than the last bit of distance.
inline constexpr double kGoodQuads = 10 * kQualityWeight;
// FitOptions::tolerance, over the diagonal, where nobody asks for another one.
inline constexpr double kUsualTolerance = 0.005;

struct FitOptions {
  // In each round, the samples settle (Correspondence::settle), then come a joint step, if asked for, and the sweeps.
  int rounds = 3;
  bool joint = false;  // what is lost far away is found again in few rounds then
  int sweeps = 3;
  double quality = kQualityWeight;
  double tolerance = std::numeric_limits<double>::infinity();  // a length: larger residuals count for more
  std::function<bool(VertexId)> fixed;  // whether an interior vertex must not move; empty: all may move
  RunTasks run;                         // empty: one thread
};

// The samples of all faces at the given vertices settle, in the end too. `surface` is the correspondence's surface.
// Precondition: the vertices are live, and each is given once.
void fit(const QuadMesh& mesh, Positions& positions, std::span<const VertexId> vertices, Correspondence& homes,
         const SurfaceIndex& surface, const FitOptions& options);

}  // namespace requad::mesh
