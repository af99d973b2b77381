// Graphs for other programs to read: named attributes at the nodes and edges of an undirected multigraph, written as
// DOT and as GraphML by Boost.Graph, and as the JSON that networkx calls node-link.
#pragma once

#include <array>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

namespace requad::enumerate {

struct AttributedGraph {
  // The values of one attribute: one for each node, or one for each edge.
  using Column = std::variant<std::vector<std::string>, std::vector<long>, std::vector<double>>;

  std::vector<std::string> names;          // of the nodes, all different: their ids in DOT
  std::vector<std::array<int, 2>> edges;   // indices of nodes
  std::map<std::string, Column> at_nodes;  // attributes by their names
  std::map<std::string, Column> at_edges;
};

// All write nodes and edges in their order and attributes in that of their names. The same graph gives the same bytes.
// GraphML numbers the nodes n0, n1, ... Its attributes have their types: string, long or double.
std::string to_dot(AttributedGraph graph);
std::string to_graphml(AttributedGraph graph);
// {"directed": false, "multigraph": true, "graph": {}, "nodes": [{"id": "n0", ...}, ...], "links": [{"source": "n0",
// "target": "n1", "key": 0, ...}, ...], "edges": [..]}: networkx.node_link_graph() reads it. The links stand twice, for
// networkx has called them "edges" since version 3.6. "key" numbers the edges that join the same
// two nodes.
nlohmann::ordered_json to_node_link(const AttributedGraph& graph);

}  // namespace requad::enumerate
