// Graphs for other programs to read: named attributes at the nodes and edges of an undirected multigraph, written as
// DOT and as GraphML by Boost.Graph.
#pragma once

#include <array>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace requad::enumerate {

struct AttributedGraph {
  // The values of one attribute: one for each node, or one for each edge.
  using Column = std::variant<std::vector<std::string>, std::vector<long>>;

  std::vector<std::string> names;          // of the nodes, all different: their ids in DOT
  std::vector<std::array<int, 2>> edges;   // indices of nodes
  std::map<std::string, Column> at_nodes;  // attributes by their names
  std::map<std::string, Column> at_edges;
};

// Both write nodes and edges in their order and attributes in that of their names. The same graph gives the same bytes.
// GraphML numbers the nodes n0, n1, ...
std::string to_dot(AttributedGraph graph);
std::string to_graphml(AttributedGraph graph);

}  // namespace requad::enumerate
