#include "enumerate/realisation.hpp"

#include <algorithm>
#include <deque>
#include <stdexcept>

#include "enumerate/generators.hpp"

namespace requad::enumerate {

using theory::Configuration;
using theory::PairType;
using theory::RegionShape;

Configuration simplest_configuration(const RegionShape& shape) {
  if (const auto merged = theory::merged_configurations(shape); !merged.empty()) return merged.front();
  const auto all = theory::parameter_set(shape);
  if (all.empty())
    throw std::invalid_argument("the region has no configuration with a " + shape.type().name() + " pair");
  return *std::min_element(all.begin(), all.end(), [](const Configuration& a, const Configuration& b) {
    return a.d1() + a.d2() < b.d1() + b.d2();
  });
}

namespace {

std::vector<int> shortest_path(const theory::ConfigurationMap& map, int from, int to) {
  std::vector<int> before(map.nodes.size(), -1);
  std::deque<int> queue{from};
  before[static_cast<std::size_t>(from)] = from;
  while (!queue.empty() && before[static_cast<std::size_t>(to)] < 0) {
    const int node = queue.front();
    queue.pop_front();
    for (const theory::Dart& dart : map.nodes[static_cast<std::size_t>(node)].moves) {
      if (dart.target < 0 || before[static_cast<std::size_t>(dart.target)] >= 0) continue;
      before[static_cast<std::size_t>(dart.target)] = node;
      queue.push_back(dart.target);
    }
  }
  if (before[static_cast<std::size_t>(to)] < 0)
    throw std::invalid_argument("no path of moves joins the two configurations");
  std::vector<int> path{to};
  while (path.back() != from) path.push_back(before[static_cast<std::size_t>(path.back())]);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace

Realisation realise(const RegionShape& shape, const Configuration& from, const Configuration& to) {
  const PairType type = shape.type();
  const theory::ConfigurationMap map = theory::configuration_map(shape, theory::Apex::with);
  const int start = map.find(from);
  const int target = map.find(to);
  for (const auto& [node, c] : {std::pair{start, from}, std::pair{target, to}}) {
    if (node < 0) throw std::invalid_argument(theory::label(type, c) + " is no configuration of this region");
  }
  Realisation result;
  result.region = glue_region(type, map.nodes[static_cast<std::size_t>(start)].configuration);
  for (const int node : shortest_path(map, start, target)) {
    const Configuration& next = map.nodes[static_cast<std::size_t>(node)].configuration;
    if (!result.path.empty()) {
      // Try the moves of the pair as it now lies, and keep the one after which the mesh reads as the next node.
      const Reading here = read(result.region, type);
      bool made = false;
      for (const mesh::PairMove& move : moves_of(result.region, here)) {
        const mesh::MoveReport report = mesh::move_pair(result.region.mesh, move);
        if (report.refusal != mesh::Refusal::none) continue;
        if (read(result.region, type).configuration == next) {
          result.moves.push_back(move);
          result.operations.insert(result.operations.end(), report.operations.begin(), report.operations.end());
          made = true;
          break;
        }
        mesh::apply_all(result.region.mesh, report.undo);
      }
      if (!made) throw std::logic_error("the step to " + theory::label(type, next) + " was refused");
    }
    result.path.push_back(next);
  }
  return result;
}

}  // namespace requad::enumerate
