// The predicted configuration graph of regions with hundreds of thousands of configurations, in a few bytes for each.
// Configurations are numbers rather than nodes, and moves are computed on request.
//
// A configuration is found by its grid point and p. Its moves have the slots of MapNode::moves
// (configuration_graph.hpp); a test compares the two representations move by move.
#pragma once

#include <cstdint>
#include <vector>

#include "theory/configuration_graph.hpp"

namespace requad::theory {

// A labelling as a position in the grid.
struct Place {
  int p = 1;
  GridPoint at;
  friend bool operator==(const Place&, const Place&) = default;
};

class ConfigurationTable {
 public:
  // All configurations of the region, merged ones included. Throws std::invalid_argument if the region has more than
  // one merged configuration. O(L^2) numbers of memory, besides parameter_set() on the way.
  explicit ConfigurationTable(const RegionShape& shape);

  const RegionShape& shape() const { return shape_; }
  // The configurations that hold the pair are numbered 0..pairs()-1; the merged one, if there is one, is number
  // pairs().
  int pairs() const { return pairs_; }
  bool has_merged() const { return merged_; }
  int size() const { return pairs_ + (merged_ ? 1 : 0); }
  // A configuration with the fewest quads. Precondition: pairs() > 0.
  const Configuration& smallest() const { return smallest_; }
  // The greatest numbers of quads and of vertices that a configuration has, the merged one included.
  Integer most_faces() const { return most_faces_; }
  Integer most_vertices() const { return most_faces_ + 1 + shape_.perimeter() / 2; }
  // The number of edges of the predicted multigraph, those of the merged configuration included. O(size()).
  std::int64_t count_edges() const;

  std::size_t bytes() const { return number_.capacity() * sizeof(number_[0]); }

  // The number of the configuration at a canonical place (d2 = 0 rather than d1 = 0), or -1 if there is none. O(1).
  int find(const Place& place) const;

  // A move. A pair has kStepCount slots for moves, the merged one rotation_count().
  struct Move {
    int target = -1;     // a number; -1 where the region has no room for the step
    Place to;            // canonical, of the target
    int back_slot = -1;  // the slot of the target that leads back
    int step = -1;       // in the labelling that the slot belongs to
    bool other = false;  // whether that labelling is other_labelling() of the configuration
  };
  // O(1). Precondition: the place is canonical and 0 <= slot < slot_count().
  Move move(const Place& place, int slot) const;
  int slot_count(const Place& place) const { return is_merged(place) ? type_.rotation_count() : kStepCount; }
  bool is_merged(const Place& place) const { return type_.symmetric() && place.at.m == 0 && place.at.n == 0; }

 private:
  bool degenerate(const Place& place) const { return type_.symmetric() && (place.at.m == 0 || place.at.n == 0); }

  RegionShape shape_;
  PairType type_;
  int pairs_ = 0;
  bool merged_ = false;
  Configuration smallest_;
  Integer most_faces_ = 0;
  Integer columns_ = 0;  // values of m, from 0 on
  Integer rows_ = 0;     // values of n
  std::vector<std::int32_t> number_;
};

}  // namespace requad::theory
