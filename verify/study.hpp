// A study: everything that is found out about one region, before any claim is judged.
//
// Facts come from two sides that do not know each other: theory/ predicts from the side lengths, enumerate/ moves pairs
// on meshes and reads labels off them. The claims (claims.hpp) only compare.
#pragma once

#include <string>
#include <vector>

#include "enumerate/exploration.hpp"
#include "theory/configuration_graph.hpp"
#include "theory/counts.hpp"

namespace requad::verify {

enum class Family { regular_digon, regular_hexagon, quad, other_digon, other_hexagon };
const char* name(Family family);  // "regular digons", ...

// What to study.
struct RegionCase {
  Family family;
  theory::PairType type;
  theory::IntegerVector sides;
};

struct Study {
  RegionCase region;
  // Predicted.
  theory::Integer exact_count = 0;
  theory::ConfigurationMap map;             // with apex
  // Found, from one start: a configuration of the lowest level, glued.
  enumerate::Exploration found;
  std::vector<int> predicted_of;            // per found node: index into map.nodes, -1 if its label is not predicted

  int pairs_predicted() const;              // nodes of the map that hold the pair
  int pairs_found() const;
};

// Throws std::invalid_argument on impossible sides. O(nodes * moves * mesh).
Study study(const RegionCase& region);

// "5-5 hexagon 3 3 3 3 3 3".
std::string describe(const RegionCase& region);

}  // namespace requad::verify
