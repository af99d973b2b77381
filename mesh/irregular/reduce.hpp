// Progressive cancellation: a mesh with fewer irregular vertices (section 10, Figure 19).
//
// Again and again the cheapest cancellation of a v3 and a v5 (complementary_operations.hpp) is made, and its
// neighbourhood is smoothed. A candidate is a pair of near vertices of opposite index, with the nearest irregular
// vertices as helpers. The cost of a candidate is measured by making it, smoothing included, and rolling it back. Costs
// are kept in a priority queue. After each cancellation, only the candidates round the vertices that moved are made
// anew. A candidate whose neighbourhood may have changed is measured again when its turn comes.
//
// Law irregular-31. After every cancellation the mesh is valid, and every cut edge (sectors.hpp) is in its place.
// Law irregular-32. Each cancellation lowers the sum of |excess| over all sectors by two or more. So the reduction
//         ends, at the latest when the excesses of each patch have one sign. Discrete Gauss-Bonnet leaves nothing to
//         cancel there: without features eight v3s on a sphere, 8 (g - 1) v5s at genus g > 1.
// Law irregular-33. The result depends on nothing but the mesh and the options.
//
// Costs: for each candidate, the length of its transports and the area that is smoothed. Only the start depends on the
// size of the mesh.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "mesh/geometry/nearest_points.hpp"
#include "mesh/geometry/smoothing.hpp"
#include "mesh/irregular/complementary_operations.hpp"

namespace requad::mesh {

// What a candidate costs: a sum over what the cancellation changed, after minus before.
enum class ReduceCost {
  curvature,  // |discrete mean curvature| of the vertices: the paper's
  shape       // (1 - scaled Jacobian) * area of the faces
};

struct ReduceOptions {
  int until = 0;  // stop at so many irregular vertices
  ReduceCost cost = ReduceCost::shape;
  // The largest distance allowed of a changed face's centre from the surface, in units of length. Negative: no bound.
  // Needs a surface.
  double max_deviation = -1;
  const SurfaceIndex* surface =
      nullptr;                   // the input: positions are projected onto it, and deviation is measured from it
  int smoothing_iterations = 4;  // after each cancellation, over what changed and two rings more
  // Over the whole mesh, in the end. Untangling follows, unless this is 0 or max_deviation is given.
  int final_iterations = 30;
  std::function<void(int irregular)> progress;  // told after each cancellation
};

struct ReduceReport {
  int before = 0;  // irregular vertices (Sectors::is_irregular)
  int after = 0;
  int parted = 0;     // operations that parted vertices of valence 2 or more than 5
  int cancelled = 0;  // cancellations
  int transports = 0;
  int operations = 0;
  int measured = 0;                 // cancellations made to measure their cost
  bool minimal = false;             // no patch has vertices of opposite index (Sectors::is_minimal)
  std::map<Refusal, int> refusals;  // of the last attempt on each pair that is left
  int too_far = 0;                  // of these, cancellations that max_deviation refused
};

// Precondition: the editor has positions. Throws std::invalid_argument for a max_deviation without a surface.
ReduceReport reduce(Editor& editor, const ReduceOptions& options);

}  // namespace requad::mesh
