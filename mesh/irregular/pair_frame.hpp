// Where a pair of irregular vertices lies: the rectangle R_alpha between them, read off the mesh by its separatrices.
//
// Terms (section 7)
//   R_alpha    the regular grid of which v1 and v2 are opposite corners (Lemma 7.8). It is a segment if d1 or d2 is 0.
//   leg        a separatrix that runs along R_alpha. Each of the two vertices has two legs. The first leg comes before
//              the second one counter-clockwise, and R_alpha lies between them.
//   outward    every other separatrix. Those of v1 follow its second leg counter-clockwise.
//   d1, d2     the extents of R_alpha: d1 along the second leg of v1, d2 along its first leg. They are the d1 and d2 of
//              the paper's side-length equations, with sides and outward separatrices numbered counter-clockwise. They
//              lie crosswise because an extent counts for the outward separatrix next to the leg: the first outward one
//              follows the second leg, so d1 is added to its side (theory-1).
//
//              y ------------ v2            first leg of v1: v1 -> x, length d2
//              |   R_alpha    | d1          second leg of v1: v1 -> y, length d1
//              v1 ----------- x             first leg of v2: v2 -> y, length d2
//                     d2                    second leg of v2: v2 -> x, length d1
//
// A rectangle looks the same from v2: its first leg is d2 long, its second leg d1.
// A segment of length d has two frames: (d1, d2) = (0, d), where it is the first leg, and (d, 0), where it is the
// second. (0, 0) with v1 = v2 is the merged pair.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/topology/quad_mesh.hpp"

namespace requad::mesh {

struct PairFrame {
  HalfEdgeId first_leg;   // out of v1, in the direction of the first leg, even if d2 = 0
  HalfEdgeId second_leg;  // out of v1, counter-clockwise next of first_leg
  VertexId v1;
  VertexId v2;
  int d1 = 0;
  int d2 = 0;

  bool merged() const { return v1 == v2; }
  bool degenerate() const { return d1 == 0 || d2 == 0; }
  int distance() const { return d1 + d2; }  // in edges, from v1 to v2
  friend bool operator==(const PairFrame&, const PairFrame&) = default;
};

// The frame with these extents and this first leg, or nothing if R_alpha's two boundary paths do not lead to one vertex
// over regular vertices. Precondition: d1 + d2 >= 1. O(d1 + d2).
std::optional<PairFrame> frame_at(const QuadMesh& mesh, HalfEdgeId first_leg, int d1, int d2);

// All frames of the pair, seen from v1: one for a rectangle, two for a segment, none if the separatrices of v1 and v2
// span no rectangle. More than one rectangle can occur only outside convex regions. Precondition: v1 and v2 are
// interior and of valence >= 3. O(length of the separatrices of v1 and v2).
std::vector<PairFrame> find_frames(const QuadMesh& mesh, VertexId v1, VertexId v2);

// The same rectangle seen from v2. O(d1 + d2).
PairFrame seen_from_other_end(const QuadMesh& mesh, const PairFrame& frame);
// The frame, and the same seen from the other end.
std::array<PairFrame, 2> both_ends(const QuadMesh& mesh, const PairFrame& frame);

// The outward separatrices of v1, counter-clockwise: l(v1) - 2 of them.
std::vector<HalfEdgeId> outward(const QuadMesh& mesh, const PairFrame& frame);
// The outward separatrices of v1, then those of v2: counter-clockwise round R_alpha, as the paper numbers them. Of a
// merged pair, all edges of its vertex from first_leg on. O(d1 + d2).
std::vector<HalfEdgeId> outward_of_both(const QuadMesh& mesh, const PairFrame& frame);

// A shortest path from v1 to v2: along v1's first leg, then along v2's second leg backwards. Empty for a merged pair.
std::vector<HalfEdgeId> path_between(const QuadMesh& mesh, const PairFrame& frame);
// The closed path round R_alpha, counter-clockwise from v1. A segment is walked there and back. O(d1 + d2).
std::vector<HalfEdgeId> rim(const QuadMesh& mesh, const PairFrame& frame);
// The faces of R_alpha, row by row along the first leg; none for a segment. Nothing if R_alpha is not as Lemma 7.8
// says: a face is missing, or a vertex other than v1 and v2 is irregular or on the boundary. O(d1 d2 + d1 + d2).
std::optional<std::vector<FaceId>> grid(const QuadMesh& mesh, const PairFrame& frame);
// The faces that have a corner on R_alpha, those of R_alpha included: the smallest convex region that holds the pair
// (Lemma 7.8). In the order of their ids. Precondition: grid() is there, or the pair is merged. O(d1 d2 log(d1 d2)).
std::vector<FaceId> ring(const QuadMesh& mesh, const PairFrame& frame);

// Whether R_alpha overlaps itself, or the faces round it overlap it or one another: a vertex or a face of ring() counts
// twice. This never happens in a convex region. Precondition: grid() is there, or the pair is merged; else false.
// O(d1 d2 log(d1 d2)).
bool overlaps_itself(const QuadMesh& mesh, const PairFrame& frame);
// Whether R_alpha lies free: grid() is there, ring() does not overlap itself, all its vertices but v1 and v2 are
// regular, and all edges between them are edges of its faces. O(d1 d2 log(d1 d2)).
bool has_room(const QuadMesh& mesh, const PairFrame& frame);

}  // namespace requad::mesh
