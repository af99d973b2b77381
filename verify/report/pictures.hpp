// The pictures of the HTML report: configurations and their moves, a region of each family, counts, times.
//
// Legend of meshes, as in the figures: an irregular vertex is a polygon with as many corners as its valence, v3 blue, v5
// orange, v6 and more red, v2 (a rhombus) purple; R_alpha is blue.
#pragma once

#include <string>

#include "verify/campaign.hpp"

namespace requad::verify {

struct Picture {
  std::string svg;      // an element
  std::string caption;  // plain text: what is seen, with the numbers that the picture shows
};

// The graph of Figure 10, 11 or 12 for a small region of the pair's type: each node is the mesh of a configuration, each
// line a move that was made. All of it is found by making moves on meshes.
Picture graph_picture(theory::PairType type);

// The mesh of a small region of the family.
Picture family_picture(Family family);

// Of all regular regions of theorems 7.2 and 7.3, against the side L: the predicted number tau(L) as a line, and the
// number that each method found as a mark. The svg is "" if the result has no such region.
Picture counts_picture(const CampaignResult& result);

// How long each method and the comparisons took.
Picture times_picture(const CampaignResult& result);

}  // namespace requad::verify
