// Labels of configurations, read off their faces by tracing separatrices.
//
// Terms (section 7 of the paper)
//   separatrix   a straight path of edges that leaves an irregular vertex. At each vertex of valence 4 it goes on by
//                the edge opposite the one that it came by.
//   R_alpha      the grid of which the two vertices of the pair, v1 of valence l1 and v2 of valence l2, are opposite
//                corners (Lemma 7.8); a segment if d1 or d2 is 0.
//   legs         the two separatrices of each vertex along R_alpha. Counter-clockwise the first comes before the
//                second, with R_alpha between them, and the outward ones follow. The first leg of v1 is d2 edges long,
//                the second one d1.
//   labelling    d1, d2, p and e_1 .. e_k: outward separatrix i, those of v1 counted first, has e_i edges and meets
//                side i + p - 1 of the region, indices modulo k.
//
// check-4  The side that bears label i has the length
//            E_i = e_{i-1} + e_{i+1} + (d1 if i is the first outward separatrix of v1 or v2)
//                                    + (d2 if i is the last outward separatrix of v1 or v2).
//
// check-5  A segment has two labellings, (d, 0, p, e) and (0, d, p + 1, e') with e'_i = e_{i+1}. Of two equal vertices
//          either may be v1; p and p + k/2 are then the same, and p stands for the lesser. The merged vertex has the
//          labellings (0, 0, p), e_i being the separatrix that meets side i + p - 1. Any other configuration has one
//          labelling.
#pragma once

#include <string>
#include <vector>

#include "verify/check/disk.hpp"
#include "verify/check/region.hpp"

namespace check {

struct Labelling {
  int d1 = 0;
  int d2 = 0;
  int p = 1;
  std::vector<int> e;
  friend auto operator<=>(const Labelling&, const Labelling&) = default;
};

// The paper's label: "(m,n)", or "(m,n,p)" in a hexagon; m and n are d1 and d2, or e_1 and e_2 for a 3-5 pair. The
// merged vertex has "(0,0)".
std::string label(const Region& region, const Labelling& labelling);

// All labellings of a configuration (check-5): first the one by which it is known, which has d1 > 0, and p = 1 if the
// vertex is merged. Throws Rejected if the irregular vertices are neither the pair nor the merged vertex, or if their
// separatrices do not run as section 7 says, check-4 included. O(faces).
std::vector<Labelling> read_labellings(const Region& region, const Disk& disk);

}  // namespace check
