#include "enumerate/exploration.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "enumerate/generators.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::enumerate {

using mesh::PairMove;
using mesh::Region;
using theory::PairType;

namespace {

std::optional<theory::Configuration> labelling(const Region& region, PairType type, const mesh::PairFrame& frame) {
  if (frame.v1 == frame.v2) return read(region, type).configuration;
  return labelling_of(region, mesh::boundary_positions(region), type, frame);
}

// Every move of one node; new configurations become nodes by node_index.
void explore_node(Exploration& found, std::size_t i, const std::function<int(const Region&)>& node_index) {
  const PairType type = found.shape.type();
  if (!found.nodes[i].reading.problem.empty()) return;  // the caller sees the problem; there is nothing to move
  for (const PairMove& move : moves_of(found.nodes[i].region, found.nodes[i].reading)) {
    FoundMove result;
    result.from = static_cast<int>(i);
    result.move = move;
    const Region& before = found.nodes[i].region;
    result.before = labelling(before, type, move.frame);
    Region work = before;
    mesh::MoveReport report = mesh::move_pair(work.mesh, move);
    result.refusal = report.refusal;
    if (report.refusal != mesh::Refusal::none) {
      result.refused_unchanged = work.mesh == before.mesh;
      found.moves.push_back(std::move(result));
      continue;
    }
    result.operations = static_cast<int>(report.operations.size());
    result.faces_made = report.faces_made();
    result.faces_deleted = report.faces_deleted();
    result.after = labelling(work, type, report.inverse.frame);
    Region back = work;
    result.inverse_returns = mesh::move_pair(back.mesh, report.inverse).refusal == mesh::Refusal::none &&
                             mesh::signature(back) == found.nodes[i].signature;
    Region undone = work;
    result.restored = mesh::apply_all(undone.mesh, report.undo) == mesh::Refusal::none && undone.mesh == before.mesh;
    result.script = std::move(report.operations);
    result.to = node_index(work);  // may move found.nodes: no reference into it is used from here on
    found.moves.push_back(std::move(result));
  }
}

}  // namespace

std::vector<PairMove> moves_of(const Region& region, const Reading& reading) {
  const auto& v = reading.irregular;
  return v.size() == 1 ? mesh::parting_moves(region.mesh, v[0]) : mesh::pair_moves(region.mesh, v[0], v[1]);
}

Exploration explore(const theory::RegionShape& shape, const std::vector<Region>& starts) {
  Exploration found{shape, {}, {}};
  std::unordered_map<std::string, int> index;
  const auto node_index = [&](const Region& region) {
    const auto [it, is_new] = index.emplace(mesh::signature(region), static_cast<int>(found.nodes.size()));
    if (is_new) found.nodes.push_back({region, it->first, read(region, shape.type())});
    return it->second;
  };
  std::size_t i = 0;  // nodes before i are explored
  const auto explore_new_nodes = [&] {
    for (; i < found.nodes.size(); ++i) explore_node(found, i, node_index);
  };
  for (const Region& start : starts) {
    node_index(start);
    explore_new_nodes();
  }
  return found;
}

namespace {

// Nodes in the order of their configurations, the merged ones last.
void sort_nodes(Exploration& found) {
  std::vector<int> order(found.nodes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&found](int a, int b) {
    const auto& x = found.nodes[static_cast<std::size_t>(a)].reading.configuration;
    const auto& y = found.nodes[static_cast<std::size_t>(b)].reading.configuration;
    return x.merged() != y.merged() ? y.merged() : x < y;
  });
  std::vector<int> place(order.size());
  std::vector<FoundNode> nodes;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    nodes.push_back(std::move(found.nodes[static_cast<std::size_t>(order[i])]));
  }
  found.nodes = std::move(nodes);
  for (FoundMove& move : found.moves) {
    move.from = place[static_cast<std::size_t>(move.from)];
    if (move.to >= 0) move.to = place[static_cast<std::size_t>(move.to)];
  }
}

}  // namespace

Exploration explore_all(const theory::RegionShape& shape, theory::Apex apex) {
  std::vector<Region> starts;
  for (const auto& c : theory::parameter_set(shape)) starts.push_back(glue_region(shape.type(), c));
  if (apex == theory::Apex::with) {
    for (const auto& c : theory::merged_configurations(shape)) starts.push_back(glue_region(shape.type(), c));
  }
  Exploration found = explore(shape, starts);
  sort_nodes(found);
  return found;
}

theory::ConfigurationGraph found_graph(const Exploration& found, theory::Apex apex, std::vector<int>* node_of) {
  std::vector<int> vertex(found.nodes.size(), -1);
  std::vector<int> nodes;
  for (std::size_t i = 0; i < found.nodes.size(); ++i) {
    if (apex == theory::Apex::without && !found.holds_pair(static_cast<int>(i))) continue;
    vertex[i] = static_cast<int>(nodes.size());
    nodes.push_back(static_cast<int>(i));
  }
  theory::ConfigurationGraph graph(nodes.size());
  for (std::size_t v = 0; v < nodes.size(); ++v) {
    graph[v].configuration = found.nodes[static_cast<std::size_t>(nodes[v])].reading.configuration;
  }
  std::map<std::pair<int, int>, int> count;
  for (const FoundMove& move : found.moves) {
    if (move.to < 0 || vertex[static_cast<std::size_t>(move.from)] < 0 || vertex[static_cast<std::size_t>(move.to)] < 0)
      continue;
    ++count[{vertex[static_cast<std::size_t>(move.from)], vertex[static_cast<std::size_t>(move.to)]}];
  }
  for (const auto& [ends, number] : count) {
    const auto [from, to] = ends;
    if (from > to) continue;
    const auto back = count.find({to, from});
    if (from != to && (back == count.end() || back->second != number)) {
      throw std::logic_error("moves between two configurations do not pair up");
    }
    if (from == to && number % 2 != 0) throw std::logic_error("moves of a configuration to itself do not pair up");
    for (int i = 0; i < (from == to ? number / 2 : number); ++i) {
      boost::add_edge(static_cast<std::size_t>(from), static_cast<std::size_t>(to), graph);
    }
  }
  if (node_of != nullptr) *node_of = std::move(nodes);
  return graph;
}

}  // namespace requad::enumerate
