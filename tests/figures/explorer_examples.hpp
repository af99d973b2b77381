// Regions, and predictions of theory/ about them, for the tests of the explorer's data and of its page.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "enumerate/exploration.hpp"
#include "mesh/topology/region.hpp"
#include "theory/configurations.hpp"

namespace requad::tests {

using Example = theory::RegionShape;
std::vector<Example> examples();
enumerate::Exploration explored(const Example& example);

// The mesh with the page's face list, which has null for a free id, and with the root edge v -> w.
mesh::Region rebuilt(const nlohmann::json& faces, const nlohmann::json& root);
// The page's face list after operations on it.
nlohmann::json patched(nlohmann::json faces, const nlohmann::json& operations);

// For the label of each configuration, and for each arrow key: the label to which the key must lead, or "" if there is
// no room. It follows from the order of a node's moves in configuration_graph.hpp, and not from a mesh.
std::map<std::string, std::map<std::string, std::string>> predicted_keys(const Example& example);
// The number of moves on a shortest path in the predicted graph.
int predicted_distance(const Example& example, const std::string& from, const std::string& to);

}  // namespace requad::tests
