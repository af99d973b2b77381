// Claims about all configurations of a region: Theorems 7.1-7.4, the configuration graph and its grids.
#include <algorithm>
#include <deque>
#include <map>
#include <numeric>
#include <set>

#include "enumerate/generators.hpp"
#include "enumerate/realisation.hpp"
#include "enumerate/search/search.hpp"
#include "mesh/topology/distances.hpp"
#include "mesh/topology/signature.hpp"
#include "verify/claims/judging.hpp"

namespace requad::verify {

using enumerate::FoundMove;
using enumerate::FoundNode;
using nlohmann::ordered_json;
using theory::Configuration;

namespace {

// Multisets of edges by predicted node, for the found and the predicted graph.
std::map<std::pair<int, int>, int> edges_of(const theory::ConfigurationGraph& graph, const std::vector<int>& names) {
  std::map<std::pair<int, int>, int> result;
  for (const auto e : boost::make_iterator_range(boost::edges(graph))) {
    const int a = names[boost::source(e, graph)];
    const int b = names[boost::target(e, graph)];
    ++result[{std::min(a, b), std::max(a, b)}];
  }
  return result;
}

// The map, or its part that holds the pair, as a graph; names are indices into map.nodes.
theory::ConfigurationGraph predicted_graph(const Study& s, theory::Apex apex, std::vector<int>& names) {
  const theory::ConfigurationGraph all = theory::configuration_graph(s.map);
  std::vector<std::size_t> keep(num_vertices(all), 0);
  names.clear();
  for (std::size_t v = 0; v < num_vertices(all); ++v) {
    if (apex == theory::Apex::without && all[v].configuration.merged()) continue;
    keep[v] = names.size() + 1;
    names.push_back(static_cast<int>(v));
  }
  theory::ConfigurationGraph graph(names.size());
  for (const auto e : boost::make_iterator_range(boost::edges(all))) {
    const std::size_t a = keep[source(e, all)];
    const std::size_t b = keep[target(e, all)];
    if (a > 0 && b > 0) add_edge(a - 1, b - 1, graph);
  }
  return graph;
}

struct GraphComparison {
  bool isomorphic = false;  // with labels
  std::size_t edges = 0;    // found
  std::string difference;
};

GraphComparison compare_graphs(const Study& s, theory::Apex apex) {
  GraphComparison result;
  std::vector<int> predicted_names, node_of, found_names;
  const auto predicted = predicted_graph(s, apex, predicted_names);
  theory::ConfigurationGraph found;
  try {
    found = enumerate::found_graph(s.found, apex, &node_of);
  } catch (const std::logic_error& error) {
    result.difference = error.what();
    return result;
  }
  for (const int node : node_of) found_names.push_back(s.predicted_of[static_cast<std::size_t>(node)]);
  result.edges = num_edges(found);
  std::vector<int> sorted = found_names;
  std::sort(sorted.begin(), sorted.end());
  if (sorted != predicted_names) {
    result.difference = std::to_string(sorted.size()) + " found configurations are not the " +
                        std::to_string(predicted_names.size()) + " predicted ones";
    return result;
  }
  const auto found_edges = edges_of(found, found_names);
  const auto predicted_edges = edges_of(predicted, predicted_names);
  result.isomorphic = found_edges == predicted_edges;
  if (!result.isomorphic) {
    const auto [f, p] =
        std::mismatch(found_edges.begin(), found_edges.end(), predicted_edges.begin(), predicted_edges.end());
    const auto& edge = f != found_edges.end() ? *f : *p;
    result.difference =
        "edges between " +
        theory::label(s.region.type, s.map.nodes[static_cast<std::size_t>(edge.first.first)].configuration) + " and " +
        theory::label(s.region.type, s.map.nodes[static_cast<std::size_t>(edge.first.second)].configuration) +
        " differ";
  }
  return result;
}

theory::Integer tau(const Study& s, theory::Integer length) {
  return is_digon(s) ? theory::tau_digon(length) : theory::tau_hexagon(length);
}

// Keeps the first violation.
class Verdict {
 public:
  explicit Verdict(Judgement& j) : j_(j) {}
  void require(bool holds, Violation otherwise) {
    ++j_.checks;
    if (!holds && !j_.violation) j_.violation = std::move(otherwise);
  }

 private:
  Judgement& j_;
};

// What moves found against the parameter set, the predicted graph and the theorem's steps.
void judge_moves(const Study& s, Judgement& j) {
  Verdict verdict(j);
  const int predicted = s.pairs_predicted();
  const int found = s.pairs_found();
  const GraphComparison pair_graph = compare_graphs(s, theory::Apex::without);
  const GraphComparison full_graph = compare_graphs(s, theory::Apex::with);
  j.row["moves"] = found;
  j.row["edges"] = pair_graph.edges;
  j.row["isomorphic"] = pair_graph.isomorphic && full_graph.isomorphic;
  verdict.require(predicted == found, at_region(s, "the parameter set has " + std::to_string(predicted) +
                                                       " configurations, moves find " + std::to_string(found)));
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    const std::string& problem = s.found.nodes[i].reading.problem;
    verdict.require(s.predicted_of[i] >= 0,
                    at_node(s, i, problem.empty() ? "this configuration is not in the parameter set" : problem));
  }
  verdict.require(pair_graph.isomorphic,
                  at_region(s, "the graph differs from the predicted one: " + pair_graph.difference));
  verdict.require(full_graph.isomorphic,
                  at_region(s, "the graph with apex differs from the predicted one: " + full_graph.difference));
  if (j.violation) return;

  // Move by move: each step is one of the theorem's four, each step that theory allows in this region was realised in it,
  // and so every other one refused.
  theory::ConfigurationMap map;
  try {
    map = found_map(s);
  } catch (const std::logic_error& error) {
    j.violation = at_region(s, error.what());
    return;
  }
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    const auto node = static_cast<std::size_t>(s.predicted_of[i]);
    for (std::size_t slot = 0; slot < map.nodes[node].moves.size(); ++slot) {
      const theory::Dart& here = map.nodes[node].moves[slot];
      const theory::Dart& there = s.map.nodes[node].moves[slot];
      verdict.require(here.target == there.target && here.slot == there.slot,
                      at_node(s, i,
                              here.target < 0 ? "a step that theory allows was refused"
                                              : "a step leads elsewhere than theory says"));
    }
  }
  for (const FoundMove& move : s.found.moves) {
    if (move.to >= 0) {
      verdict.require(move.restored, at_move(s, move, "undoing the move's operations does not restore the mesh"));
      verdict.require(move.inverse_returns, at_move(s, move, "the reported inverse move does not lead back"));
    } else {
      verdict.require(move.refused_unchanged, at_move(s, move, "the refused move changed the mesh"));
    }
  }
}

// What search found against the parameter set: the very same meshes, rel boundary.
void judge_search(const Study& s, Judgement& j) {
  Verdict verdict(j);
  std::vector<std::string> pairs, merged;
  for (const theory::MapNode& node : s.map.nodes) {
    (node.configuration.merged() ? merged : pairs)
        .push_back(mesh::signature(enumerate::glue_region(s.region.type, node.configuration)));
  }
  std::sort(pairs.begin(), pairs.end());
  std::sort(merged.begin(), merged.end());
  j.row["search"] = s.searched->size();
  verdict.require(pairs == *s.searched,
                  at_region(s, "search finds " + std::to_string(s.searched->size()) + " fillings, not the " +
                                   std::to_string(pairs.size()) + " of the parameter set"));
  if (s.searched_merged) {
    verdict.require(merged == *s.searched_merged,
                    at_region(s, "search finds " + std::to_string(s.searched_merged->size()) +
                                     " merged fillings, theory " + std::to_string(merged.size())));
  }
}

// The walk on one mesh: each configuration of the parameter set once, each predicted edge both ways, nothing else.
void judge_walk(const Study& s, Judgement& j) {
  Verdict verdict(j);
  const enumerate::WalkResult& w = *s.walked;
  j.row["walk"] = w.configurations;
  j.row["walk_edges"] = w.edges;
  j.checks += w.identifications;
  verdict.require(w.problem.empty(), {"walk: " + w.problem, w.configuration, "", w.mesh});
  verdict.require(w.configurations == s.exact_count,
                  at_region(s, "the closed form gives " + std::to_string(s.exact_count) + ", the walk visits " +
                                   std::to_string(w.configurations)));
  verdict.require(w.complete(),
                  at_region(s, "the walk visits " + std::to_string(w.configurations) + " of " +
                                   std::to_string(w.predicted) + " configurations and " + std::to_string(w.edges) +
                                   " of " + std::to_string(w.predicted_edges) + " edges"));
}

}  // namespace

// Unique unless 4 divides the valence; then as many as the singular circulant has positive solutions, (L-1)^2 in a
// regular region of side L. Found by search; the predicted meshes are glued.
Judgement judge_theorem_1(const Study& s) {
  if (!s.searched || s.region.type.side_count() == 4) return not_applicable();
  Judgement j;
  Verdict verdict(j);
  const int valence = s.region.type.side_count();
  std::vector<std::string> predicted;
  for (const mesh::Region& region : s.single) predicted.push_back(mesh::signature(region));
  std::sort(predicted.begin(), predicted.end());
  j.row = {
      {"valence", valence}, {"sides", side_list(s)}, {"predicted", predicted.size()}, {"search", s.searched->size()}};
  verdict.require(predicted == *s.searched, at_region(s, "search finds " + std::to_string(s.searched->size()) +
                                                             " configurations, the circulant has " +
                                                             std::to_string(predicted.size()) + " positive solutions"));
  verdict.require(valence % 4 == 0 || s.searched->size() <= 1,
                  at_region(s, "more than one configuration though 4 does not divide the valence"));
  const bool regular = s.region.sides.minCoeff() == s.region.sides.maxCoeff();
  const auto length = static_cast<std::size_t>(s.region.sides(0));
  if (regular && valence % 4 == 0) {
    verdict.require(s.searched->size() == (length - 1) * (length - 1), at_region(s, "not (L-1)^2 configurations"));
  }
  return j;
}

Judgement judge_theorem(const Study& s) {
  Judgement j;
  Verdict verdict(j);
  const int predicted = s.pairs_predicted();
  j.row = {{"sides", side_list(s)}, {"predicted", s.exact_count}, {"parameters", predicted}};
  verdict.require(s.exact_count == predicted, at_region(s, "the closed form gives " + std::to_string(s.exact_count) +
                                                               ", the parameter set has " + std::to_string(predicted)));
  if (is_regular(s)) {
    const theory::Integer expected = tau(s, s.region.sides(0));
    j.row["tau"] = expected;
    verdict.require(expected == predicted, at_region(s, "tau is " + std::to_string(expected) +
                                                            ", the parameter set has " + std::to_string(predicted)));
  } else if (!is_quad(s)) {
    const theory::Integer bound = tau(s, theory::smallest_regular({s.region.type, s.region.sides}));
    j.row["bound"] = bound;
    verdict.require(predicted <= bound, at_region(s, std::to_string(predicted) + " configurations exceed the bound " +
                                                         std::to_string(bound)));
  } else {
    const theory::QuadCount quad = theory::quad_count({s.region.type, s.region.sides});
    j.row["M"] = quad.m;
    j.row["N"] = quad.n;
  }
  if (!s.found.nodes.empty()) judge_moves(s, j);
  if (s.searched) judge_search(s, j);
  if (s.walked) judge_walk(s, j);
  return j;
}

Judgement judge_connected(const Study& s) {
  if (s.found.nodes.empty()) return not_applicable();
  Judgement j;
  Verdict verdict(j);
  std::set<int> reached(s.predicted_of.begin(), s.predicted_of.end());
  for (std::size_t i = 0; i < s.map.nodes.size(); ++i) {
    const Configuration& c = s.map.nodes[i].configuration;
    if (c.merged()) continue;
    verdict.require(
        reached.count(static_cast<int>(i)) > 0,
        {"moves do not reach this configuration from " + theory::label(s.region.type, s.map.nodes[0].configuration),
         theory::label(s.region.type, c), "", enumerate::glue_region(s.region.type, c)});
  }
  if (s.searched) {
    // Whatever search knows, moves reach.
    std::set<std::string> signatures;
    for (const FoundNode& node : s.found.nodes) signatures.insert(node.signature);
    for (const std::string& text : *s.searched) {
      verdict.require(signatures.count(text) > 0,
                      {"moves do not reach a filling that search finds", "", "", mesh::from_signature(text)});
    }
  }
  return j;
}

Judgement judge_realisation(const Study& s) {
  if (s.found.nodes.empty()) return not_applicable();
  const Configuration start = enumerate::simplest_configuration({s.region.type, s.region.sides});
  // Distances by moves as found, from the start.
  std::vector<std::vector<int>> next(s.found.nodes.size());
  for (const FoundMove& move : s.found.moves) {
    if (move.to >= 0) next[static_cast<std::size_t>(move.from)].push_back(move.to);
  }
  std::vector<int> distance(s.found.nodes.size(), -1);
  std::deque<std::size_t> queue;
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    if (s.found.nodes[i].reading.configuration == start) queue.push_back(i), distance[i] = 0;
  }
  while (!queue.empty()) {
    const std::size_t i = queue.front();
    queue.pop_front();
    for (const int to : next[i]) {
      if (distance[static_cast<std::size_t>(to)] >= 0) continue;
      distance[static_cast<std::size_t>(to)] = distance[i] + 1;
      queue.push_back(static_cast<std::size_t>(to));
    }
  }
  return for_each_node(s, [&](const FoundNode& node) -> std::string {
    const enumerate::Realisation made =
        enumerate::realise({s.region.type, s.region.sides}, start, node.reading.configuration);
    if (mesh::signature(made.region) != node.signature)
      return "the path of moves from " + theory::label(s.region.type, start) + " makes another mesh";
    const int shortest = distance[static_cast<std::size_t>(&node - s.found.nodes.data())];
    if (static_cast<int>(made.moves.size()) != shortest) {
      return "the path has " + std::to_string(made.moves.size()) + " moves, a shortest one " + std::to_string(shortest);
    }
    return "";
  });
}

// The nodes of the found grid all have the parity of L, and its dual is the grid of the next smaller region. The found
// grid has the order of its moves round each node from their labels (found_map()).
Judgement judge_dual(const Study& s) {
  if (!is_regular(s) || s.found.nodes.empty()) return not_applicable();
  Judgement j;
  Verdict verdict(j);
  const theory::Integer length = s.region.sides(0);
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    const Configuration& c = s.found.nodes[i].reading.configuration;
    verdict.require((c.d1() + c.d2() - length) % 2 == 0, at_node(s, i, "its parity is not that of L"));
  }
  theory::DualGrid dual;
  try {
    dual = theory::dual_grid(found_map(s));
  } catch (const std::logic_error& error) {
    verdict.require(false, at_region(s, error.what()));
    return j;
  }
  const theory::IntegerVector smaller_sides = theory::IntegerVector::Constant(s.region.sides.size(), length - 1);
  const theory::ConfigurationMap smaller =
      theory::configuration_map({s.region.type, smaller_sides}, theory::Apex::with);
  // Name the faces by the nodes of the smaller grid at their centres.
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
  const bool same = sorted == all && dual_edges == edges_of(theory::configuration_graph(smaller), all);
  j.row = {{"sides", side_list(s)},
           {"faces_of_grid", dual.faces.size()},
           {"nodes_of_smaller_grid", smaller.nodes.size()},
           {"dual_edges", dual.edges.size()},
           {"isomorphic", same}};
  verdict.require(same, at_region(s, "the dual is not the grid of side " + std::to_string(length - 1)));
  return j;
}

// Cancelling would leave a filling of the same boundary without any irregular vertex: search finds none. The sides of the
// meshes that moves made are never those of a regular grid.
Judgement judge_no_cancelling(const Study& s) {
  Judgement j = for_each_node(s, [](const FoundNode& node) -> std::string {
    if (node.reading.irregular.size() != 2) return "a move lost the pair";
    const std::vector<int> e = mesh::side_lengths(node.region);
    return e[0] == e[2] && e[1] == e[3] ? "opposite sides are equal: a regular grid fits" : "";
  });
  if (s.searched) {
    enumerate::SearchLimits limits;
    limits.threads = 1;
    const auto regular =
        enumerate::search(enumerate::search_problem({s.region.sides.begin(), s.region.sides.end()}, {}), limits, {});
    Verdict(j).require(regular.count == 0, at_region(s, "search finds a filling without irregular vertices"));
    j.applies = true;
  }
  return j;
}

// Moves reach the merged vertex iff the region has room for one, in a regular region (and in every digon) iff the graph
// distance of the pair is even. Slides alone align the pair in a regular region.
Judgement judge_merging(const Study& s) {
  if (s.found.nodes.empty()) return not_applicable();
  Judgement j;
  Verdict verdict(j);
  const std::size_t n = s.found.nodes.size();
  std::vector<std::vector<int>> by_any(n), by_slides(n);
  for (const FoundMove& move : s.found.moves) {
    if (move.to < 0) continue;
    // Against the direction of the moves: from the goal back. Moves have inverses, but that is not taken for granted.
    by_any[static_cast<std::size_t>(move.to)].push_back(move.from);
    const bool slide = move.move.step == mesh::PairStep::slide_first || move.move.step == mesh::PairStep::slide_second;
    if (slide) by_slides[static_cast<std::size_t>(move.to)].push_back(move.from);
  }
  const auto reaching = [n](const std::vector<std::vector<int>>& backwards, std::vector<int> stack) {
    std::vector<bool> can(n, false);
    while (!stack.empty()) {
      const auto node = static_cast<std::size_t>(stack.back());
      stack.pop_back();
      if (can[node]) continue;
      can[node] = true;
      for (const int from : backwards[node]) stack.push_back(from);
    }
    return can;
  };
  std::vector<int> merged, aligned;
  for (std::size_t i = 0; i < n; ++i) {
    const Configuration& c = s.found.nodes[i].reading.configuration;
    if (c.merged()) merged.push_back(static_cast<int>(i));
    if (c.degenerate() && !c.merged()) aligned.push_back(static_cast<int>(i));
  }
  const std::vector<bool> can_merge = reaching(by_any, merged);
  const std::vector<bool> can_align = reaching(by_slides, aligned);
  const bool room = std::any_of(s.map.nodes.begin(), s.map.nodes.end(),
                                [](const theory::MapNode& node) { return node.configuration.merged(); });
  for (std::size_t i = 0; i < n; ++i) {
    const FoundNode& node = s.found.nodes[i];
    if (node.reading.configuration.merged()) continue;
    const int distance = mesh::graph_distance(node.region.mesh, node.reading.irregular[0], node.reading.irregular[1]);
    verdict.require(distance == node.reading.configuration.d1() + node.reading.configuration.d2(),
                    at_node(s, i, "the graph distance " + std::to_string(distance) + " is not d1 + d2"));
    verdict.require(
        can_merge[i] == room,
        at_node(s, i, can_merge[i] ? "merges where there is no room" : "does not merge though there is room"));
    if (is_digon(s) || is_regular(s)) {
      verdict.require(can_merge[i] == (distance % 2 == 0),
                      at_node(s, i,
                              std::string(can_merge[i] ? "merges" : "does not merge") + " at distance " +
                                  std::to_string(distance)));
    }
    if (is_regular(s)) verdict.require(can_align[i], at_node(s, i, "can not be aligned by slides"));
  }
  return j;
}

}  // namespace requad::verify
