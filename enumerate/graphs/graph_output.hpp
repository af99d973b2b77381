// Configuration graphs as JSON of two kinds, DOT, GraphML and CSV.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "enumerate/exploration.hpp"

namespace requad::enumerate {

// {"nodes":[{"d1":..,"d2":..,"p":..,"faces":..},...],"edges":[[i,j],...],"steps":["open",...],
// "scripts":[["split 8 9 0",...],...],"components":n,"complete":true}: each node as in node_json(), and one entry for
// each edge of the multigraph, with i <= j, sorted; a self-loop is [i,i]. The step and the script of an edge lead from i
// to j. A script is of operations on the mesh that mesh::from_signature() makes of the signature of i.
nlohmann::ordered_json graph_json(const Exploration& found, theory::Apex apex);
// The graph of a region that has no configuration.
nlohmann::ordered_json empty_graph_json();
// The same graph with the attributes d1, d2, p, faces, label and signature at the nodes n0, n1, ..., and step and script
// at the edges. DOT has the place of each node in points (pos), so `neato -n2` draws the grid; the others have it in grid
// units (x, y), see grid_position.hpp.
std::string graph_dot(const Exploration& found, theory::Apex apex);
std::string graph_graphml(const Exploration& found, theory::Apex apex);
nlohmann::ordered_json graph_node_link(const Exploration& found, theory::Apex apex);
// The nodes alone, as configuration_rows.hpp writes them.
std::string graph_csv(const Exploration& found, theory::Apex apex);

// d1, d2, p (theory/configurations.hpp; 1 for the merged vertex), for a 3-5 pair m and n, the number of faces, the label
// that the figures use, and the signature.
nlohmann::ordered_json node_json(theory::PairType type, const FoundNode& node);

}  // namespace requad::enumerate
