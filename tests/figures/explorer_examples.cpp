#include "tests/figures/explorer_examples.hpp"

#include <array>
#include <deque>

#include "tests/support/catch.hpp"
#include "tests/support/theory/integer_vector.hpp"
#include "theory/configuration_graph.hpp"

namespace requad::tests {

using nlohmann::json;
using theory::Apex;
using theory::Configuration;

std::vector<Example> examples() {
  return {{theory::kDigon, sides({6, 6})},
          {theory::kDigon, sides({3, 3})},
          {theory::kDigon, sides({5, 9})},
          {theory::kHexagon, sides({5, 5, 5, 5, 5, 5})},
          {theory::kHexagon, sides({6, 6, 6, 6, 6, 6})},
          {theory::kHexagon, sides({5, 6, 7, 6, 5, 7})},
          {theory::kQuad, sides({6, 5, 5, 8})},
          {theory::kQuad, sides({6, 5, 6, 9})},
          {theory::kQuad, sides({6, 5, 4, 7})}};
}

enumerate::Exploration explored(const Example& e) { return enumerate::explore_all(e, Apex::with); }

mesh::Region rebuilt(const json& faces, const json& root) {
  std::map<int, int> name;
  std::vector<std::array<int, 4>> lists;
  for (const json& face : faces) {
    if (face.is_null()) continue;
    std::array<int, 4> corners{};
    for (std::size_t k = 0; k < 4; ++k) {
      corners[k] = name.emplace(face[k].get<int>(), static_cast<int>(name.size())).first->second;
    }
    lists.push_back(corners);
  }
  mesh::Region region{mesh::QuadMesh::from_faces(static_cast<int>(name.size()), lists), {}};
  region.root = region.mesh.find_half_edge(mesh::VertexId(name.at(root[0])), mesh::VertexId(name.at(root[1])));
  return region;
}

json patched(json faces, const json& operations) {
  for (const json& operation : operations) {
    for (const json& entry : operation["patch"]) {
      const auto face = entry[0].get<std::size_t>();
      while (faces.size() <= face) faces.push_back(nullptr);
      faces[face] = entry.size() == 1 ? json() : json{entry[1], entry[2], entry[3], entry[4]};
    }
  }
  return faces;
}

std::map<std::string, std::map<std::string, std::string>> predicted_keys(const Example& e) {
  const theory::ConfigurationMap map = theory::configuration_map(e, Apex::with);
  std::map<std::string, std::map<std::string, std::string>> keys;
  for (const theory::MapNode& node : map.nodes) {
    auto& here = keys[theory::label(e.type(), node.configuration)];
    for (std::size_t i = 0; i < node.moves.size(); ++i) {
      std::string key;
      const Configuration& labelling = node.labellings[i];
      if (!e.type().symmetric()) {
        key = std::array{"right", "up", "left", "down"}[static_cast<std::size_t>(node.steps[i])];
      } else if (node.configuration.merged()) {
        key = e.type() == theory::kDigon
                  ? "up"
                  : std::array{"left", "right", "down"}[static_cast<std::size_t>(labelling.p - 1)];
      } else {
        key = std::array{"up", "left", "down", "right"}[static_cast<std::size_t>(node.steps[i])];
        if (key == "up" && !(labelling == node.configuration)) key = "down";  // a segment opens on both sides
      }
      const int target = node.moves[i].target;
      REQUIRE(here.count(key) == 0);
      here[key] = target < 0 ? "" : theory::label(e.type(), map.nodes[static_cast<std::size_t>(target)].configuration);
    }
  }
  return keys;
}

int predicted_distance(const Example& e, const std::string& from, const std::string& to) {
  const auto keys = predicted_keys(e);
  std::map<std::string, int> distance{{from, 0}};
  std::deque<std::string> queue{from};
  while (!queue.empty()) {
    const std::string here = queue.front();
    queue.pop_front();
    for (const auto& [key, there] : keys.at(here)) {
      if (!there.empty() && distance.emplace(there, distance.at(here) + 1).second) queue.push_back(there);
    }
  }
  return distance.at(to);
}

}  // namespace requad::tests
