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

// A shortest path of node indices, both ends included, by breadth-first search.
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

// Tries the moves of the pair in its present configuration. Keeps the one after which the mesh is in this
// configuration.
void step_to(const Configuration& next, PairType type, Realisation& made) {
  for (const mesh::PairMove& move : moves_of(made.region, read(made.region, type))) {
    const mesh::MoveReport report = mesh::move_pair(made.region.mesh, move);
    if (report.refusal != mesh::Refusal::none) continue;
    if (read(made.region, type).configuration == next) {
      made.path.push_back(next);
      made.moves.push_back(move);
      made.operations.insert(made.operations.end(), report.operations.begin(), report.operations.end());
      return;
    }
    mesh::apply_all(made.region.mesh, report.undo);
  }
  throw std::logic_error("the step to " + theory::label(type, next) + " was refused");
}

}  // namespace

Realisation realise(const RegionShape& shape, const Configuration& from, const Configuration& to) {
  const PairType type = shape.type();
  const theory::ConfigurationMap map = theory::configuration_map(shape, theory::Apex::with);
  const auto index_of = [&](const Configuration& c) {
    const int node = map.find(c);
    if (node < 0) throw std::invalid_argument(theory::label(type, c) + " is no configuration of this region");
    return node;
  };
  const auto configuration = [&](int node) { return map.nodes[static_cast<std::size_t>(node)].configuration; };
  const int start = index_of(from);
  const std::vector<int> path = shortest_path(map, start, index_of(to));
  Realisation made{glue_region(type, configuration(start)), {configuration(start)}, {}, {}};
  for (std::size_t i = 1; i < path.size(); ++i) step_to(configuration(path[i]), type, made);
  return made;
}

}  // namespace requad::enumerate
