// Exhaustive exploration: from one configuration, every pair move until nothing new is found.
//
// Contract. explore() produces every configuration that pair moves reach from the starts, precisely once up to
// isomorphism rel boundary (equal signatures from the root), the merged configurations that lie on the way included. At
// each it tries every move that pair_moves() or parting_moves() lists. Labels are read off each mesh (labels.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "enumerate/labels.hpp"
#include "mesh/irregular/pair_moves.hpp"
#include "theory/configuration_graph.hpp"

namespace requad::enumerate {

struct FoundNode {
  mesh::Region region;
  std::string signature;
  Reading reading;
};

struct FoundMove {
  int from = -1;
  int to = -1;                                  // -1: refused
  mesh::PairMove move;                          // on nodes[from].region
  std::optional<theory::Configuration> before;  // the labelling of move.frame; nothing if it can not be read
  std::optional<theory::Configuration> after;   // the labelling of the frame that the move reports; nothing if refused
  mesh::Refusal refusal = mesh::Refusal::none;
  int operations = 0;
  int faces_made = 0;
  int faces_deleted = 0;
  bool restored = true;           // the reported undo gave back the very same arrays
  bool inverse_returns = true;    // the reported inverse move, made on the result, gave the start's signature
  bool refused_unchanged = true;  // a refused move left the very same arrays
  std::vector<mesh::BasicOperation> script;
};

// The moves that the pair, or the merged vertex, of a region could make if there were room.
std::vector<mesh::PairMove> moves_of(const mesh::Region& region, const Reading& reading);

struct Exploration {
  theory::RegionShape shape;
  std::vector<FoundNode> nodes;
  std::vector<FoundMove> moves;

  bool holds_pair(int node) const { return !nodes[static_cast<std::size_t>(node)].reading.configuration.merged(); }
};

// The first start is explored to the end; a further one becomes a node only if it was not reached, and is explored then.
// Precondition: the starts have this shape, and region_problem() is "" for each. A node in whose region read() finds a problem is kept, with the problem, and
// not moved. O(nodes * moves * mesh).
Exploration explore(const theory::RegionShape& shape, const std::vector<mesh::Region>& starts);
// From the first configuration of parameter_set(), glued, and from whatever moves did not reach of the others (the merged
// ones too if apex says so), so that nothing is missing even if the graph were not connected. Nodes are sorted by
// configuration, merged ones last.
Exploration explore_all(const theory::RegionShape& shape, theory::Apex apex);

// The multigraph of an exploration: moves come in pairs that undo each other, so n moves from i to j, i != j, are n
// edges and n moves from i to itself n / 2 edges. Throws std::logic_error if the moves do not pair up so. Apex::without
// leaves the merged nodes out; nodes keep their order. `node_of` receives each graph vertex's exploration node.
theory::ConfigurationGraph found_graph(const Exploration& found, theory::Apex apex,
                                       std::vector<int>* node_of = nullptr);

}  // namespace requad::enumerate
