// Regions made from the separatrix-strip parameters (d1, d2, e_1..e_k), in two independent ways.
//
// Law enumerate-1   grow_region(), glue_region() and realise() (realisation.hpp, by moves) make isomorphic regions rel
//                   boundary from the same configuration.
//
// Label 1 of a configuration lies on side p of the region (theory/configurations.hpp). The region's root is the start
// of its side 1. Both ways take time O(F log F) for a region of F quads.
#pragma once

#include <array>
#include <vector>

#include "mesh/topology/region.hpp"
#include "theory/configurations.hpp"

namespace requad::enumerate {

// Grows a region as the proof of Lemma 7.10 does: from R_alpha, by one strip of quads along one side at a time (Lemmas
// 7.12-7.14). At first a side has length 0 where the outward separatrices of a v5 leave side by side. So the region is
// a mesh only once every side has had a strip.
class StripGrowth {
 public:
  // R_alpha of size d1 x d2, without strips: a segment if one extent is 0, a vertex if both are.
  StripGrowth(theory::PairType type, theory::Integer d1, theory::Integer d2);

  // Adds a strip along the side with this label, 1..k. O(length of the side).
  void add_strip(int label);

  // By label.
  std::vector<int> side_lengths() const;
  // Whether every side has had a strip.
  bool complete() const;
  // The region so far, rooted at the start of the side with this label, 1..k. Precondition: complete(). O(F log F).
  mesh::Region region(int label) const;

 private:
  using Line = std::vector<int>;  // the vertices along a path
  struct Core {                   // the sides of R_alpha, counter-clockwise
    Line from_v1, to_v2, from_v2, to_v1;
  };

  int new_vertex() { return vertices_++; }
  Core make_core(int d1, int d2);
  void add_sides(const Line& second_leg, const Line& first_leg, int outward);

  int vertices_ = 0;
  std::vector<std::array<int, 4>> faces_;
  std::vector<Line> sides_;  // by label, counter-clockwise; a corner is in both of its sides
  std::vector<int> strips_;  // by label: how many
};

// The region of a configuration, merged ones included, grown strip by strip with the sides in turn. Throws
// std::invalid_argument if parameters_problem() finds something wrong (d1 = d2 = 0 is allowed here), and beyond 20
// million quads.
mesh::Region grow_region(theory::PairType type, const theory::Configuration& configuration);

// The same region, glued from the rectangles into which the separatrices cut it: R_alpha; one rectangle between any two
// consecutive outward separatrices of a vertex; and at each corner of R_alpha that is no irregular vertex, three.
// Throws like grow_region().
mesh::Region glue_region(theory::PairType type, const theory::Configuration& configuration);

// The region of a single irregular vertex of valence k = e.size() >= 2 with e_i strips towards side i; a regular grid
// if k = 4. Side i has the length e_{i-1} + e_{i+1}. Throws like grow_region().
mesh::Region glue_vertex(const theory::IntegerVector& e);

}  // namespace requad::enumerate
