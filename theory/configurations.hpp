// Parameter sets: all configurations of a pair that the side lengths of a region allow, each exactly once.
//
// Terms
//   labelling       the numbers 1..k laid on the sides of a region so that theory-1 (pair_system.hpp) holds. Label i
//                   lies on side i + p - 1 of the region; p counts from 1. If the valences are equal, p and p + k/2
//                   differ only by a swap of v1 and v2, so p runs over 1..k/2. It is the third index of Theorem 7.3.
//   configuration   a requadrangulation with its pair, up to isomorphisms that fix the boundary.
//
// theory-3  (d, 0, p) with strips e is the configuration (0, d, p + 1) with strips shifted by one, e'_i = e_{i+1}.
// In words: R_alpha is then a segment, and the leg of length zero may be taken on either side of it. This glues the
// three quadrants of a hexagon into a cone (Figure 11) and closes the one quadrant of a digon (Figure 10). Apart from
// this, and from swapping equal vertices, a configuration has one labelling.
#pragma once

#include <string>
#include <vector>

#include "theory/region_shape.hpp"

namespace requad::theory {

// A position in the configuration graph: (d1, d2, p), and the strips that go with it.
struct Configuration {
  StripParameters parameters;
  int p = 1;

  Integer d1() const { return parameters.d1; }
  Integer d2() const { return parameters.d2; }
  bool degenerate() const { return d1() == 0 || d2() == 0; }
  // True for (0, 0): the pair merged into one vertex of valence l1 + l2 - 4.
  bool merged() const { return d1() == 0 && d2() == 0; }
};

// Order and equality by (p, d1, d2, e).
bool operator==(const Configuration& a, const Configuration& b);
bool operator<(const Configuration& a, const Configuration& b);

// The coordinates that tell apart the configurations of one labelling: (d1, d2), but (e1, e2) where 4 divides the number
// of sides, as for a 3-5 pair, since the sides fix d1 and d2 there. They are those of Theorems 7.2, 7.3 and 7.4.
struct GridPoint {
  Integer m = 0;
  Integer n = 0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};
GridPoint grid_point(PairType type, const Configuration& configuration);

// "(m,n)", or "(m,n,p)" if the type has a third index; the merged configuration is "(0,0)".
std::string label(PairType type, const Configuration& configuration);
std::string label(PairType type, const GridPoint& at, int p);

// One line that says why no pair has these parameters, or "" if one has: d1, d2 >= 0 and not both 0, k strips, each
// >= 1, no length beyond kMaxLength.
std::string parameters_problem(PairType type, const StripParameters& parameters);

// The second labelling of a degenerate configuration (theory-3). Precondition: exactly one of d1, d2 is 0.
Configuration other_labelling(PairType type, const Configuration& configuration);
// The canonical labelling of a configuration: d2 = 0 rather than d1 = 0, and p = 1 for the merged one. Accepts any
// labelling with p in 1..k.
Configuration canonical(PairType type, Configuration configuration);

// The side lengths of a configuration's region. They start with side 1 of the region, not of the labelling.
IntegerVector region_sides(PairType type, const Configuration& configuration);

// All configurations of the region that hold the pair, canonical and sorted by p, d1, d2, e. Merged ones are not among
// them. Solves the system O(L^2) times, where L is the longest side.
std::vector<Configuration> parameter_set(const RegionShape& shape);

// The merged configurations (0,0): the positive solutions of E_i = e_{i-1} + e_{i+1}. There is at most one unless 4
// divides k, and none if the valences differ.
std::vector<Configuration> merged_configurations(const RegionShape& shape);

}  // namespace requad::theory
