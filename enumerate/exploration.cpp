#include "enumerate/exploration.hpp"

#include <map>
#include <stdexcept>
#include <unordered_map>

#include "enumerate/generators.hpp"
#include "mesh/signature.hpp"

namespace requad::enumerate {

using mesh::PairMove;
using mesh::Region;
using theory::PairType;

namespace {

std::vector<PairMove> moves_of(const FoundNode& node) {
  const auto& v = node.reading.irregular;
  return v.size() == 1 ? mesh::parting_moves(node.region.mesh, v[0]) : mesh::pair_moves(node.region.mesh, v[0], v[1]);
}

std::optional<theory::Configuration> labelling(const Region& region, PairType type, const mesh::PairFrame& frame) {
  if (frame.v1 == frame.v2) return read(region, type).configuration;
  return labelling_of(region, mesh::boundary_positions(region), type, frame);
}

}  // namespace

Exploration explore(PairType type, const std::vector<Region>& starts) {
  Exploration found{type, {}, {}};
  std::unordered_map<std::string, int> index;
  const auto node_index = [&](const Region& region) {
    const auto [it, is_new] = index.emplace(mesh::signature(region), static_cast<int>(found.nodes.size()));
    if (is_new) found.nodes.push_back({region, it->first, read(region, type)});
    return it->second;
  };
  for (const Region& start : starts) node_index(start);
  for (std::size_t i = 0; i < found.nodes.size(); ++i) {
    if (!found.nodes[i].reading.problem.empty()) continue;  // the caller sees the problem; there is nothing to move
    for (const PairMove& move : moves_of(found.nodes[i])) {
      FoundMove result;
      result.from = static_cast<int>(i);
      result.move = move;
      const Region& before = found.nodes[i].region;
      if (const auto label = labelling(before, type, move.frame)) result.before = *label;
      Region work = before;
      mesh::MoveReport report = mesh::move_pair(work.mesh, move);
      result.refusal = report.refusal;
      if (report.refusal != mesh::Refusal::none) {
        result.refused_unchanged = work.mesh == before.mesh;
        found.moves.push_back(std::move(result));
        continue;
      }
      result.operations = static_cast<int>(report.operations.size());
      result.faces_made = static_cast<int>(report.faces_made.size());
      result.faces_deleted = static_cast<int>(report.faces_deleted.size());
      if (const auto label = labelling(work, type, report.inverse.frame)) result.after = *label;
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
  return found;
}

Exploration explore_all(PairType type, const theory::IntegerVector& sides, theory::Apex apex) {
  std::vector<Region> starts;
  for (const auto& c : theory::parameter_set(type, sides)) starts.push_back(glue_region(type, c));
  if (apex == theory::Apex::with) {
    for (const auto& c : theory::merged_configurations(type, sides)) starts.push_back(glue_region(type, c));
  }
  return explore(type, starts);
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
    if (move.to < 0 || vertex[static_cast<std::size_t>(move.from)] < 0 || vertex[static_cast<std::size_t>(move.to)] < 0) continue;
    ++count[{vertex[static_cast<std::size_t>(move.from)], vertex[static_cast<std::size_t>(move.to)]}];
  }
  for (const auto& [ends, number] : count) {
    const auto [from, to] = ends;
    if (from > to) continue;
    const auto back = count.find({to, from});
    if (from != to && (back == count.end() || back->second != number)) {
      // Where three or more directions at the merged vertex give one configuration, they are one edge.
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
