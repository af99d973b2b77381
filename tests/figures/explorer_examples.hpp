// What the tests of the explorer's data and of its page share: regions, and what the theory predicts of them.
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

// A mesh from the page's face list, null where an id is free, with the root edge v -> w.
mesh::Region rebuilt(const nlohmann::json& faces, const nlohmann::json& root);
// The page's face list after these operations.
nlohmann::json patched(nlohmann::json faces, const nlohmann::json& operations);

// For each configuration by its label, and each arrow key: the label that the theory says the key leads to, "" if there
// is no room. The order of a predicted node's moves is that of configuration_graph.hpp, not of the mesh.
std::map<std::string, std::map<std::string, std::string>> predicted_keys(const Example& example);
// Moves on a shortest path in the predicted graph.
int predicted_distance(const Example& example, const std::string& from, const std::string& to);

}  // namespace requad::tests
