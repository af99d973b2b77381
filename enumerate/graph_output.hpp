// Configuration graphs as DOT, GraphML (both by Boost.Graph) and JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "enumerate/exploration.hpp"

namespace requad::enumerate {

// A found graph with what a reader wants at each node: d1, d2, p (0 where there is no third index), m, n for a 3-5 pair,
// the number of faces, the signature, and the label that the figures use.
//   json      {"nodes":[{"d1":..,"d2":..,"p":..,"faces":..},...],"edges":[[i,j],...],"components":n}, an entry for each
//             edge of the multigraph, a self-loop as [i,i], i <= j, sorted
//   dot, graphml   the same attributes at the nodes
nlohmann::ordered_json graph_json(const Exploration& found, theory::Apex apex);
std::string graph_dot(const Exploration& found, theory::Apex apex);
std::string graph_graphml(const Exploration& found, theory::Apex apex);

// The attributes of one node, as above.
nlohmann::ordered_json node_json(theory::PairType type, const FoundNode& node);

}  // namespace requad::enumerate
