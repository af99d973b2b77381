// Exhaustive exploration: every configuration that pair moves reach from given regions.
//
// Law enumerate-2   explore() finds every configuration that pair moves reach from the starts, precisely once up to
//                   isomorphism rel boundary: equal signatures from the root.
//
// Merged configurations on the way are included. A configuration is represented by the mesh on which it was reached
// first. At each one explore() tries every move that mesh::pair_moves() or mesh::parting_moves() lists. Labels are read
// off each mesh (labels.hpp). A start whose pair has no room to move is the only configuration that is found from it.
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
  std::optional<theory::Configuration> before;  // the labelling of move.frame; nothing if it cannot be read
  std::optional<theory::Configuration> after;   // the labelling of the frame that the move reports; nothing if refused
  mesh::Refusal refusal = mesh::Refusal::none;
  int operations = 0;
  int faces_made = 0;
  int faces_deleted = 0;
  bool restored = true;           // the reported undo gave back the very same arrays
  bool inverse_returns = true;    // the reported inverse move, made on the result, gave the signature of `from`
  bool refused_unchanged = true;  // the refused move left the very same arrays
  std::vector<mesh::BasicOperation> script;
};

// The moves that the pair of a region, or its merged vertex, could make if there were room.
std::vector<mesh::PairMove> moves_of(const mesh::Region& region, const Reading& reading);

struct Exploration {
  theory::RegionShape shape;
  std::vector<FoundNode> nodes;
  std::vector<FoundMove> moves;

  bool holds_pair(int node) const { return !nodes[static_cast<std::size_t>(node)].reading.configuration.merged(); }
};

// Explores everything from the first start, then from each further start that was not reached. If read() finds a
// problem in a node's region, the node is kept with that problem and no move is tried on it. Precondition:
// region_problem() is "" for each start, and its sides are those of the shape. O(nodes * moves * mesh).
Exploration explore(const theory::RegionShape& shape, const std::vector<mesh::Region>& starts);
// Explores from all configurations that theory predicts, glued (generators.hpp); from the merged ones only with the
// apex. So no predicted configuration is missing even if the graph is not connected. Nodes are sorted by configuration,
// merged ones last.
Exploration explore_all(const theory::RegionShape& shape, theory::Apex apex);

// The multigraph of an exploration. Moves come in pairs that undo each other: n moves from i to another node j are n
// edges, n moves from i to itself are n / 2 loops. Apex::without leaves the merged nodes out. Nodes keep their order;
// `node_of` receives the exploration's node of each graph vertex. Throws std::logic_error if the moves do not pair up.
theory::ConfigurationGraph found_graph(const Exploration& found, theory::Apex apex,
                                       std::vector<int>* node_of = nullptr);

}  // namespace requad::enumerate
