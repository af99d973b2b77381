// Configuration graphs as JSON, DOT and GraphML.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "enumerate/exploration.hpp"

namespace requad::enumerate {

// {"nodes":[{"d1":..,"d2":..,"p":..,"faces":..},...],"edges":[[i,j],...],"components":n}: each node as in node_json(),
// and one entry for each edge of the multigraph, with i <= j, sorted; a self-loop is [i,i].
nlohmann::ordered_json graph_json(const Exploration& found, theory::Apex apex);
// The same graph with the attributes d1, d2, p, faces, label and signature at the nodes n0, n1, ...
std::string graph_dot(const Exploration& found, theory::Apex apex);
std::string graph_graphml(const Exploration& found, theory::Apex apex);

// d1, d2, p (0 where there is no third index), for a 3-5 pair m and n, the number of faces, the label that the figures
// use, and the signature.
nlohmann::ordered_json node_json(theory::PairType type, const FoundNode& node);

}  // namespace requad::enumerate
