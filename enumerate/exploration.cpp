#include "enumerate/exploration.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "enumerate/generators.hpp"
#include "mesh/topology/signature.hpp"

namespace requad::enumerate {

using mesh::PairMove;
using mesh::Refusal;
using mesh::Region;
using theory::PairType;

namespace {

std::size_t slot(int i) { return static_cast<std::size_t>(i); }

std::optional<theory::Configuration> labelling(const Region& region, PairType type, const mesh::PairFrame& frame) {
  if (frame.merged()) return read(region, type).configuration;
  return labelling_of(region, mesh::boundary_positions(region), type, frame);
}

class Explorer {
 public:
  explicit Explorer(const theory::RegionShape& shape) : found_{shape, {}, {}} {}

  void explore_from(const Region& start) {
    node_of(start);
    while (explored_ < found_.nodes.size()) try_all_moves(explored_++);
  }

  Exploration found() && { return std::move(found_); }

 private:
  PairType type() const { return found_.shape.type(); }
  int node_of(const Region& region);
  void try_all_moves(std::size_t node);
  FoundMove try_move(const FoundNode& node, const PairMove& move, Region& work) const;
  void record_made(const FoundNode& node, const Region& after, mesh::MoveReport& report, FoundMove& result) const;

  Exploration found_;
  std::unordered_map<std::string, int> index_;  // of the nodes, by signature
  std::size_t explored_ = 0;                    // the moves of all nodes before this one have been tried
};

// The node with this region's signature. Adds one if there is none.
int Explorer::node_of(const Region& region) {
  const auto [it, is_new] = index_.emplace(mesh::signature(region), static_cast<int>(found_.nodes.size()));
  if (is_new) found_.nodes.push_back({region, it->first, read(region, type())});
  return it->second;
}

void Explorer::try_all_moves(std::size_t node) {
  if (!found_.nodes[node].reading.problem.empty()) return;  // there is nothing to move; the node keeps its problem
  for (const PairMove& move : moves_of(found_.nodes[node].region, found_.nodes[node].reading)) {
    Region work = found_.nodes[node].region;
    FoundMove result = try_move(found_.nodes[node], move, work);
    result.from = static_cast<int>(node);
    if (result.refusal == Refusal::none) result.to = node_of(work);
    found_.moves.push_back(std::move(result));
  }
}

// Makes the move on `work`, which is a copy of the node's region.
FoundMove Explorer::try_move(const FoundNode& node, const PairMove& move, Region& work) const {
  FoundMove result;
  result.move = move;
  result.before = labelling(node.region, type(), move.frame);
  mesh::MoveReport report = mesh::move_pair(work.mesh, move);
  result.refusal = report.refusal;
  if (report.refusal == Refusal::none) {
    record_made(node, work, report, result);
  } else {
    result.refused_unchanged = work.mesh == node.region.mesh;
  }
  return result;
}

void Explorer::record_made(const FoundNode& node, const Region& after, mesh::MoveReport& report,
                           FoundMove& result) const {
  result.operations = static_cast<int>(report.operations.size());
  result.faces_made = report.faces_made();
  result.faces_deleted = report.faces_deleted();
  result.after = labelling(after, type(), report.inverse.frame);
  Region back = after;
  result.inverse_returns =
      mesh::move_pair(back.mesh, report.inverse).refusal == Refusal::none && mesh::signature(back) == node.signature;
  Region undone = after;
  result.restored = mesh::apply_all(undone.mesh, report.undo) == Refusal::none && undone.mesh == node.region.mesh;
  result.script = std::move(report.operations);
}

// Puts the nodes in the order of their configurations, the merged ones last.
void sort_nodes(Exploration& found) {
  std::vector<int> order(found.nodes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&found](int a, int b) {
    const auto& x = found.nodes[slot(a)].reading.configuration;
    const auto& y = found.nodes[slot(b)].reading.configuration;
    return x.merged() != y.merged() ? y.merged() : x < y;
  });
  std::vector<int> rank(order.size());
  std::vector<FoundNode> nodes;
  for (const int node : order) {
    rank[slot(node)] = static_cast<int>(nodes.size());
    nodes.push_back(std::move(found.nodes[slot(node)]));
  }
  found.nodes = std::move(nodes);
  for (FoundMove& move : found.moves) {
    move.from = rank[slot(move.from)];
    if (move.to >= 0) move.to = rank[slot(move.to)];
  }
}

}  // namespace

std::vector<PairMove> moves_of(const Region& region, const Reading& reading) {
  const auto& v = reading.irregular;
  return v.size() == 1 ? mesh::parting_moves(region.mesh, v[0]) : mesh::pair_moves(region.mesh, v[0], v[1]);
}

Exploration explore(const theory::RegionShape& shape, const std::vector<Region>& starts) {
  Explorer explorer(shape);
  for (const Region& start : starts) explorer.explore_from(start);
  return std::move(explorer).found();
}

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

// --- the graph -------------------------------------------------------------------------------------------------------

namespace {

// The number of moves from one graph vertex to another, by (from, to). `vertex_of` has the graph vertex of each node,
// or -1 if the node is left out.
std::map<std::pair<int, int>, int> count_moves(const Exploration& found, const std::vector<int>& vertex_of) {
  std::map<std::pair<int, int>, int> count;
  for (const FoundMove& move : found.moves) {
    if (move.to < 0) continue;
    const int from = vertex_of[slot(move.from)];
    const int to = vertex_of[slot(move.to)];
    if (from >= 0 && to >= 0) ++count[{from, to}];
  }
  return count;
}

}  // namespace

theory::ConfigurationGraph found_graph(const Exploration& found, theory::Apex apex, std::vector<int>* node_of) {
  std::vector<int> vertex_of(found.nodes.size(), -1);
  std::vector<int> nodes;
  for (std::size_t i = 0; i < found.nodes.size(); ++i) {
    if (apex == theory::Apex::without && !found.holds_pair(static_cast<int>(i))) continue;
    vertex_of[i] = static_cast<int>(nodes.size());
    nodes.push_back(static_cast<int>(i));
  }
  theory::ConfigurationGraph graph(nodes.size());
  for (std::size_t v = 0; v < nodes.size(); ++v) {
    graph[v].configuration = found.nodes[slot(nodes[v])].reading.configuration;
  }
  const auto count = count_moves(found, vertex_of);
  for (const auto& [ends, moves] : count) {
    const auto [from, to] = ends;
    if (from > to) continue;
    const auto back = count.find({to, from});
    if (back == count.end() || back->second != moves)
      throw std::logic_error("moves between two configurations do not pair up");
    if (from == to && moves % 2 != 0) throw std::logic_error("moves of a configuration to itself do not pair up");
    for (int i = 0; i < (from == to ? moves / 2 : moves); ++i) add_edge(slot(from), slot(to), graph);
  }
  if (node_of != nullptr) *node_of = std::move(nodes);
  return graph;
}

}  // namespace requad::enumerate
