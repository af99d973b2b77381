// Regions from the separatrix-strip parameters (d1, d2, e_1..e_k), in two independent ways. A third, by moves, is in
// realisation.hpp. All three must agree rel boundary.
//
// A configuration's label 1 lies on side p of the region (theory/configurations.hpp); the region's root is the start of
// its side 1.
#pragma once

#include <vector>

#include "mesh/topology/region.hpp"
#include "theory/configurations.hpp"

namespace requad::enumerate {

// Grows a region as Lemma 7.10 says: from R_alpha, by one strip of quads along one side at a time (Lemmas 7.12-7.14).
// Sides may have length zero at first, where a v5's outward separatrices leave side by side; the region is a mesh once
// every side has had a strip.
class StripGrowth {
 public:
  // R_alpha of size d1 x d2 (a segment if one is 0, a vertex if both are) for this pair, no strips yet.
  StripGrowth(theory::PairType type, theory::Integer d1, theory::Integer d2);

  // Adds a strip along side `label`, 1..k. O(length of the side).
  void add_strip(int label);

  std::vector<int> side_lengths() const;
  // Whether every side has had a strip.
  bool complete() const;
  // The region so far, rooted at the start of side `label`. Precondition: complete(). O(F log F).
  mesh::Region region(int label) const;

 private:
  int new_vertex() { return vertices_++; }

  int vertices_ = 0;
  std::vector<std::array<int, 4>> faces_;
  std::vector<std::vector<int>> sides_;  // vertices counter-clockwise, corners in both neighbours
  std::vector<int> strips_;              // per side
};

// The region of a configuration (merged ones too), grown strip by strip, sides in turn.
mesh::Region grow_region(theory::PairType type, const theory::Configuration& configuration);

// The same, glued from the rectangles into which the separatrices cut the region: R_alpha, one between consecutive
// outward separatrices of a vertex, three round each corner of R_alpha that is no irregular vertex.
mesh::Region glue_region(theory::PairType type, const theory::Configuration& configuration);

// The region of a single irregular vertex of valence k = e.size() >= 2 with e_i strips towards side i; a regular grid if
// k = 4. Side i has the length e_{i-1} + e_{i+1}.
mesh::Region glue_vertex(const theory::IntegerVector& e);

// Both throw std::invalid_argument if parameters_problem() has something to say (d1 = d2 = 0 is allowed here).

}  // namespace requad::enumerate
