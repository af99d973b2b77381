// The predicted configuration graph. Its nodes are configurations, its edges the steps of Theorems 7.2, 7.3 and 7.4.
//
// The graph is drawn on a surface: a cone over one quadrant for a digon, a cone over three quadrants for a hexagon, a
// rectangle for a 3-5 region. So it comes as a map: each node has up to four moves in counter-clockwise order. The map
// gives a multigraph, and it gives the faces that the dual grid needs (captions of Figures 10 and 11).
//
// theory-4  each level s = d1 + d2 of a digon is a closed cycle of s nodes, of a regular hexagon one of 3 s nodes. At
//           s = 1 the digon's cycle is a self-loop, at s = 2 a double edge. Between levels s and s + 2 there are s + 1
//           edges (3 (s + 1) for a regular hexagon). The apex (0,0) hangs on level 2 by one edge (by three).
#pragma once

#include <array>
#include <map>
#include <vector>

#include <boost/graph/adjacency_list.hpp>

#include "theory/configurations.hpp"

namespace requad::theory {

// The steps of the theorems in grid coordinates (m, n), counter-clockwise from the first: (+1,+1), (-1,+1), (-1,-1),
// (+1,-1) for equal valences; (+1,0), (0,+1), (-1,0), (0,-1) for a 3-5 pair.
inline constexpr int kStepCount = 4;
GridPoint step_offset(PairType type, int step);
// The step that undoes a step.
inline int reverse_step(int step) { return (step + 2) % kStepCount; }

// The labelling that a step leads to, strips included; p stays. The result need not be canonical. If an entry is out of
// range it is not a configuration at all (is_configuration()).
Configuration stepped(PairType type, const Configuration& from, int step);
bool is_configuration(const Configuration& c);

// One end of a predicted edge.
struct Dart {
  int target = -1;  // node index, -1 where the region has no room for the step
  int slot = -1;    // which of the target's moves leads back
};

// A node and its moves, counter-clockwise round it. The last two moves of a degenerate node belong to its other
// labelling.
struct MapNode {
  Configuration configuration;
  std::vector<Dart> moves;                // four; of a merged node as many as it has directions to part in
  std::vector<Configuration> labellings;  // of moves[i]: the labelling that the step applies to
  std::vector<int> steps;                 // of moves[i]: the step in that labelling
};

enum class Apex { without, with };

struct ConfigurationMap {
  PairType type;
  std::vector<MapNode> nodes;          // in the order of parameter_set(), the merged ones last
  std::map<Configuration, int> index;  // of canonical configurations

  // The index of a configuration, given by any of its labellings, or -1 if it is not in the map.
  int find(const Configuration& labelling) const;
};

// O(nodes log nodes) beyond parameter_set().
ConfigurationMap configuration_map(const RegionShape& shape, Apex apex);

struct NodeProperty {
  Configuration configuration;
};
// An undirected multigraph; parallel edges and self-loops are kept.
using ConfigurationGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, NodeProperty>;
ConfigurationGraph configuration_graph(const ConfigurationMap& map);

// The inner faces of the map and their adjacency. Each bounded face is a node of the dual, labelled by the grid point
// at its centre, which belongs to the next smaller or larger region. Each edge of the map that has bounded faces on
// both sides, or the same one twice, is an edge of the dual. Precondition: the valences are equal.
struct DualGrid {
  std::vector<Configuration> faces;       // canonical (d1, d2, p); strips are left empty
  std::vector<std::array<int, 2>> edges;  // indices into faces, sorted
};
DualGrid dual_grid(const ConfigurationMap& map);

}  // namespace requad::theory
