// Claims about the configuration graph as a whole: it is connected (M1), a shortest path realises each configuration
// (R1), and the grids of neighbouring sizes are dual (F1).
#include <algorithm>
#include <deque>
#include <map>
#include <numeric>
#include <set>

#include "enumerate/generators.hpp"
#include "enumerate/realisation.hpp"
#include "mesh/topology/signature.hpp"
#include "verify/claims/judging.hpp"
#include "verify/studies/found_map.hpp"

namespace requad::verify {

using enumerate::FoundMove;
using enumerate::FoundNode;
using theory::Configuration;

std::map<std::pair<int, int>, int> edges_of(const theory::ConfigurationGraph& graph, const std::vector<int>& names) {
  std::map<std::pair<int, int>, int> result;
  for (const auto e : boost::make_iterator_range(boost::edges(graph))) {
    const int a = names[boost::source(e, graph)];
    const int b = names[boost::target(e, graph)];
    ++result[{std::min(a, b), std::max(a, b)}];
  }
  return result;
}

std::vector<int> distances_from(const PairStudy& s, std::size_t start) {
  std::vector<std::vector<int>> next(s.found.nodes.size());
  for (const FoundMove& move : s.found.moves) {
    if (move.to >= 0) next[static_cast<std::size_t>(move.from)].push_back(move.to);
  }
  std::vector<int> distance(s.found.nodes.size(), -1);
  std::deque<std::size_t> queue{start};
  distance[start] = 0;
  while (!queue.empty()) {
    const std::size_t i = queue.front();
    queue.pop_front();
    for (const int to : next[i]) {
      if (distance[static_cast<std::size_t>(to)] >= 0) continue;
      distance[static_cast<std::size_t>(to)] = distance[i] + 1;
      queue.push_back(static_cast<std::size_t>(to));
    }
  }
  return distance;
}

// Moves lead from the first found configuration to every one that theory predicts and to every filling that the search
// finds. An exploration may have had several starts, so a configuration that was found need not be reached.
Judgement judge_connected(const PairStudy& s) {
  if (s.found.nodes.empty()) return not_applicable();
  Judgement j;
  Requirements required(j);
  const std::string start = theory::label(s.shape.type(), s.found.nodes[0].reading.configuration);
  const std::vector<int> distance = distances_from(s, 0);
  std::set<int> reached;
  std::set<std::string> signatures;
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    if (distance[i] < 0) continue;
    reached.insert(s.predicted_of[i]);
    signatures.insert(s.found.nodes[i].signature);
  }
  int pairs_reached = 0;
  for (std::size_t i = 0; i < s.map.nodes.size(); ++i) {
    const Configuration& c = s.map.nodes[i].configuration;
    if (c.merged()) continue;
    const bool is_reached = reached.count(static_cast<int>(i)) > 0;
    pairs_reached += is_reached ? 1 : 0;
    required.that(is_reached, {"moves do not reach this configuration from " + start, theory::label(s.shape.type(), c),
                               "", enumerate::glue_region(s.shape.type(), c)});
  }
  j.predicted = counted(s.pairs_predicted(), "configuration") + " connected by moves";
  j.found = std::to_string(pairs_reached) + " reached from " + start;
  if (s.searched) {
    int fillings_reached = 0;
    for (const std::string& text : *s.searched) {
      const bool is_reached = signatures.count(text) > 0;
      fillings_reached += is_reached ? 1 : 0;
      required.that(is_reached, {"moves do not reach a filling that search finds", "", "", mesh::from_signature(text)});
    }
    j.found += ", and " + std::to_string(fillings_reached) + " of " +
               counted(static_cast<std::int64_t>(s.searched->size()), "filling") + " that search finds";
  }
  return j;
}

Judgement judge_realisation(const PairStudy& s) {
  if (s.found.nodes.empty()) return not_applicable();
  const Configuration start = enumerate::simplest_configuration(s.shape);
  const std::string start_label = theory::label(s.shape.type(), start);
  const auto first = std::find_if(s.found.nodes.begin(), s.found.nodes.end(),
                                  [&](const FoundNode& node) { return node.reading.configuration == start; });
  const std::vector<int> distance = first == s.found.nodes.end()
                                        ? std::vector<int>(s.found.nodes.size(), -1)
                                        : distances_from(s, static_cast<std::size_t>(first - s.found.nodes.begin()));
  return for_each_node(
      s, "made by a shortest path of moves from " + start_label, [&](const FoundNode& node) -> std::string {
        const enumerate::Realisation made = enumerate::realise(s.shape, start, node.reading.configuration);
        if (mesh::signature(made.region) != node.signature)
          return "the path of moves from " + start_label + " makes another mesh";
        const int shortest = distance[static_cast<std::size_t>(&node - s.found.nodes.data())];
        if (static_cast<int>(made.moves.size()) != shortest) {
          return "the path has " + std::to_string(made.moves.size()) + " moves, a shortest one " +
                 std::to_string(shortest);
        }
        return "";
      });
}

// All nodes of the found grid have the parity of L, and its dual is the grid of the next smaller region. The order of
// the moves round each node is read off the meshes (found_map()).
Judgement judge_dual(const PairStudy& s) {
  if (!is_regular(s) || s.found.nodes.empty()) return not_applicable();
  Judgement j;
  Requirements required(j);
  const theory::Integer length = s.shape.longest();
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    const Configuration& c = s.found.nodes[i].reading.configuration;
    required.that((c.d1() + c.d2() - length) % 2 == 0, at_node(s, i, "its parity is not that of L"));
  }
  theory::DualGrid dual;
  try {
    dual = theory::dual_grid(found_map(s));
  } catch (const std::logic_error& error) {
    j.predicted = "a dual that is the grid of side " + std::to_string(length - 1);
    j.found = "moves that are no map, or no dual";
    required.that(false, at_region(s, error.what()));
    return j;
  }
  const theory::ConfigurationMap smaller =
      theory::configuration_map(theory::RegionShape::regular(s.shape.type(), length - 1), theory::Apex::with);
  // Each face takes the name of the node of the smaller grid at its centre.
  std::map<std::tuple<theory::Integer, theory::Integer, int>, int> node_at;
  for (std::size_t i = 0; i < smaller.nodes.size(); ++i) {
    const Configuration& c = smaller.nodes[i].configuration;
    node_at[{c.d1(), c.d2(), c.p}] = static_cast<int>(i);
  }
  std::vector<int> names;
  for (const Configuration& face : dual.faces) {
    const auto it = node_at.find({face.d1(), face.d2(), face.p});
    names.push_back(it == node_at.end() ? -1 : it->second);
  }
  std::map<std::pair<int, int>, int> dual_edges;
  for (const auto& [a, b] : dual.edges) {
    const int x = names[static_cast<std::size_t>(a)];
    const int y = names[static_cast<std::size_t>(b)];
    ++dual_edges[{std::min(x, y), std::max(x, y)}];
  }
  std::vector<int> all(smaller.nodes.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<int> sorted = names;
  std::sort(sorted.begin(), sorted.end());
  const theory::ConfigurationGraph smaller_graph = theory::configuration_graph(smaller);
  const bool same = sorted == all && dual_edges == edges_of(smaller_graph, all);
  const auto grid = [](std::size_t nodes, std::size_t edges) {
    return counted(static_cast<std::int64_t>(nodes), "node") + " and " +
           counted(static_cast<std::int64_t>(edges), "edge");
  };
  j.predicted = "a dual with the " + grid(smaller.nodes.size(), num_edges(smaller_graph)) + " of the grid of side " +
                std::to_string(length - 1);
  j.found = "a dual with " + grid(dual.faces.size(), dual.edges.size());
  j.row = {{"sides", side_list(s.shape.sides())},
           {"faces_of_grid", dual.faces.size()},
           {"nodes_of_smaller_grid", smaller.nodes.size()},
           {"dual_edges", dual.edges.size()},
           {"isomorphic", same}};
  required.that(same, at_region(s, "the dual is not the grid of side " + std::to_string(length - 1)));
  return j;
}

}  // namespace requad::verify
