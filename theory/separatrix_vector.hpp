// The vector of Theorem 7.11: where the separatrices of a pair meet the boundary, and how that determines the pair.
//
// Terms
//   crossing     (S, u) of one separatrix: the side that it meets, and the distance from the start of that side. Here
//                a crossing also has the separatrix's length, which the theorem does not need.
//   frame order  the separatrices of a vertex counter-clockwise: first leg, second leg, outward ones. R_alpha lies
//                between the two legs.
//
// theory-5  Let (d1, d2, e, p) be a labelling with sides E, so that label i lies on side i + p - 1 of the region
//           (indices modulo k). Let f and l be the labels of a vertex's first and last outward separatrix, and f' and
//           l' those of the other vertex. Then
//             outward separatrix i   meets side i at e_{i-1} + (d1 if i is a first one), after e_i edges
//             first leg              meets side f' at e_{f'-1}, after d2 + e_{f'} edges
//             second leg             meets side l' at E_{l'} - e_{l'+1}, after d1 + e_{l'} edges
// In words: beyond R_alpha a leg runs beside an outward separatrix of the other vertex and ends on the same side: the
// first leg before the first outward separatrix, the second leg beyond the last. A leg that joins the two vertices
// meets no side (the second legs do if d2 = 0).
//
// theory-6  (Theorem 7.11) So the vector determines the labelling: e_{i-1} is the position of the first crossing of
//           side i, e_{i+1} is the rest of the side after the last crossing, and d1 and d2 are the distances between.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "theory/configurations.hpp"

namespace requad::theory {

struct Crossing {
  int side = -1;          // 0-based, from side 1 of the region on; -1: the separatrix ends at the other vertex
  Integer distance = -1;  // from the side's start, counter-clockwise
  Integer length = 0;     // in edges
  friend bool operator==(const Crossing&, const Crossing&) = default;
};

// The most sides that a region may have here. The arrays have a fixed size, so nothing is allocated.
inline constexpr int kMostSides = 8;
inline constexpr int kMostSeparatrices = 8;  // of one vertex

// A labelling as plain numbers; e has side_count() entries.
struct Labelling {
  int p = 1;
  Integer d1 = 0;
  Integer d2 = 0;
  std::array<Integer, kMostSides> e{};
  friend bool operator==(const Labelling&, const Labelling&) = default;
};
Labelling to_labelling(const Configuration& configuration);
Configuration to_configuration(PairType type, const Labelling& labelling);

// The crossings of both vertices in frame order (theory-5). Precondition: shape.side_count() <= kMostSides, d1 > 0 or
// d2 > 0.
struct SeparatrixVector {
  std::array<Crossing, kMostSeparatrices> at_v1{};
  std::array<Crossing, kMostSeparatrices> at_v2{};
};
SeparatrixVector separatrix_vector(const RegionShape& shape, const Labelling& labelling);

// A pair found by its vector. The labelling is canonical: d1 > 0 and, for equal valences, p <= k / 2.
struct Located {
  Labelling labelling;
  bool swapped = false;  // whether the second vertex has the first labels (equal valences only)
  int leg1 = 0;          // index of the first leg in at_v1
  int leg2 = 0;          // in at_v2
};
// Finds the labelling that has this vector, lengths included (theory-6). Returns nothing if there is none. The
// crossings of each vertex are in counter-clockwise order and may start with any separatrix. O(l1 l2), without
// allocation.
std::optional<Located> locate(const RegionShape& shape, std::span<const Crossing> at_v1,
                              std::span<const Crossing> at_v2);

// The same for the merged vertex, whose separatrix i meets side i at e_{i-1}, after e_i edges. Returns the index of the
// separatrix that meets side 1, or -1 if no merged vertex has this vector.
int locate_merged(const RegionShape& shape, std::span<const Crossing> at_v);

}  // namespace requad::theory
