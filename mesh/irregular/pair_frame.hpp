// Where a pair of irregular vertices lies: the grid R_alpha between them, read off the mesh by its separatrices.
//
// Terms (section 7)
//   R_alpha    the regular grid of which v1 and v2 are opposite corners (Lemma 7.8); a segment if one extent is 0.
//   leg        a separatrix that runs along R_alpha. Each vertex has two; `first` comes before `second` counter-
//              clockwise, R_alpha lies between. The other separatrices are outward: counter-clockwise after `second`.
//   a, b       the extents of R_alpha along v1's first and second leg. By the symmetry of the rectangle, v2's first leg
//              is a long and its second b.
//
//              y ------------ v2            first leg of v1: v1 -> x, length a
//              |   R_alpha    | b           second leg of v1: v1 -> y, length b
//              v1 ----------- x             first leg of v2: v2 -> y, length a
//                     a                     second leg of v2: v2 -> x, length b
//
// The numbers d1, d2 of the paper's side-length equations are d1 = b and d2 = a, with sides and outward separatrices
// numbered counter-clockwise; theory/ has those equations and this header does not need them.
// A segment of length d has two frames: (a, b) = (d, 0), where the segment is the first leg, and (0, d), where it is the
// second. (0, 0) with one vertex is the merged pair.
#pragma once

#include <optional>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

struct PairFrame {
  HalfEdgeId first_leg;   // out of v1, in the direction of the first leg, even if a = 0
  HalfEdgeId second_leg;  // out of v1, counter-clockwise next of first_leg
  VertexId v1;
  VertexId v2;
  int a = 0;
  int b = 0;

  bool degenerate() const { return a == 0 || b == 0; }
  friend bool operator==(const PairFrame&, const PairFrame&) = default;
};

// The half-edge by which a straight walk of `steps` edges, h the first, arrives; nothing if a vertex before the end is
// irregular or on the boundary. steps >= 1. O(steps).
std::optional<HalfEdgeId> walk(const QuadMesh& mesh, HalfEdgeId h, int steps);

// The frame with these extents whose first leg starts with h, if R_alpha's two boundary paths are there. a + b >= 1.
std::optional<PairFrame> frame_at(const QuadMesh& mesh, HalfEdgeId first_leg, int a, int b);

// All frames of the pair, seen from v1: one, two for a segment, none if separatrices of the two do not span a
// rectangle. (More than one rectangle can occur only outside convex regions.) v1 and v2 are interior and of valence
// >= 3. O(length of v1's and v2's separatrices).
std::vector<PairFrame> find_frames(const QuadMesh& mesh, VertexId v1, VertexId v2);

// The same frame seen from v2. O(a + b).
PairFrame seen_from_other_end(const QuadMesh& mesh, const PairFrame& frame);

// The outward separatrices at v1, counter-clockwise: l(v1) - 2 of them.
std::vector<HalfEdgeId> outward(const QuadMesh& mesh, const PairFrame& frame);

// Lemma 7.8: every quad of R_alpha is there and every vertex of it but v1, v2 is interior and regular; the faces, row by
// row along the first leg. Nothing if not. O(a b).
std::optional<std::vector<FaceId>> region_between(const QuadMesh& mesh, const PairFrame& frame);

// The number of edges on a shortest path from one vertex to another; -1 if there is none. O(V).
int graph_distance(const QuadMesh& mesh, VertexId from, VertexId to);

}  // namespace requad::mesh
