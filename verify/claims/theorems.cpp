// Theorems 7.1 to 7.4: how many configurations a region has, and which.
#include <algorithm>
#include <map>

#include "enumerate/generators.hpp"
#include "mesh/topology/signature.hpp"
#include "verify/claims/judging.hpp"
#include "verify/studies/found_map.hpp"

namespace requad::verify {

using enumerate::FoundMove;
using nlohmann::ordered_json;

namespace {

// The map, or the part of it that holds the pair, as a graph. Names are indices into map.nodes.
theory::ConfigurationGraph predicted_graph(const PairStudy& s, theory::Apex apex, std::vector<int>& names) {
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
  bool isomorphic = false;    // with labels
  std::size_t predicted = 0;  // edges
  std::size_t edges = 0;      // found
  std::string difference;
};

GraphComparison compare_graphs(const PairStudy& s, theory::Apex apex) {
  GraphComparison result;
  std::vector<int> predicted_names, node_of, found_names;
  const auto predicted = predicted_graph(s, apex, predicted_names);
  result.predicted = num_edges(predicted);
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
        theory::label(s.shape.type(), s.map.nodes[static_cast<std::size_t>(edge.first.first)].configuration) + " and " +
        theory::label(s.shape.type(), s.map.nodes[static_cast<std::size_t>(edge.first.second)].configuration) +
        " differ";
  }
  return result;
}

theory::Integer tau(const PairStudy& s, theory::Integer length) {
  return is_digon(s) ? theory::tau_digon(length) : theory::tau_hexagon(length);
}

// "tau(6) = N (N - 1) = 6 with N = 3", as Theorems 7.2 and 7.3 write it.
std::string tau_text(const PairStudy& s, theory::Integer length) {
  return "tau(" + std::to_string(length) + ") = " + (is_digon(s) ? "" : "3 ") +
         (length % 2 == 0 ? "N (N - 1)" : "N^2") + " = " + std::to_string(tau(s, length)) +
         " with N = " + std::to_string(length / 2);
}

// The number of edges, the merged configuration included.
std::string edges_text(const PairStudy& s, std::size_t edges) {
  const bool merges = std::any_of(s.map.nodes.begin(), s.map.nodes.end(),
                                  [](const theory::MapNode& node) { return node.configuration.merged(); });
  return counted(static_cast<std::int64_t>(edges), "edge") +
         (merges ? " with the v" + std::to_string(s.shape.type().side_count()) : "");
}

// Adds what one method found.
void add_found(Judgement& j, Method method, const std::string& text) {
  j.found += (j.found.empty() ? "" : "; ") + (name(method) + (": " + text));
}

// Compares what moves found with the parameter set, the predicted graph and the theorem's steps.
void judge_moves(const PairStudy& s, Judgement& j) {
  Requirements required(j);
  const int predicted = s.pairs_predicted();
  const int found = s.pairs_found();
  const GraphComparison pair_graph = compare_graphs(s, theory::Apex::without);
  const GraphComparison full_graph = compare_graphs(s, theory::Apex::with);
  j.row["moves"] = found;
  j.row["edges"] = pair_graph.edges;
  j.row["edges_with_apex"] = full_graph.edges;  // what the walk counts, too
  j.row["isomorphic"] = pair_graph.isomorphic && full_graph.isomorphic;
  j.predicted += ", " + edges_text(s, full_graph.predicted);
  add_found(j, Method::moves, counted(found, "configuration") + ", " + edges_text(s, full_graph.edges));
  required.that(predicted == found, at_region(s, "the parameter set has " + std::to_string(predicted) +
                                                     " configurations, moves find " + std::to_string(found)));
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    const std::string& problem = s.found.nodes[i].reading.problem;
    required.that(s.predicted_of[i] >= 0,
                  at_node(s, i, problem.empty() ? "this configuration is not in the parameter set" : problem));
  }
  required.that(pair_graph.isomorphic,
                at_region(s, "the graph differs from the predicted one: " + pair_graph.difference));
  required.that(full_graph.isomorphic,
                at_region(s, "the graph with apex differs from the predicted one: " + full_graph.difference));
  if (j.violation) return;

  // Move by move: each step is one of the theorem's four, each step that theory allows in this region was realised, so
  // that every other one was refused, and they lie in this order round the configuration.
  theory::ConfigurationMap map;
  try {
    map = found_map(s);
  } catch (const std::logic_error& error) {
    j.violation = at_region(s, error.what());
    return;
  }
  for (std::size_t i = 0; i < s.found.nodes.size(); ++i) {
    const std::string difference = node_difference(s.map, map, static_cast<std::size_t>(s.predicted_of[i]));
    required.that(difference.empty(), at_node(s, i, difference));
  }
  for (const FoundMove& move : s.found.moves) {
    if (move.to >= 0) {
      required.that(move.restored, at_move(s, move, "undoing the move's operations does not restore the mesh"));
      required.that(move.inverse_returns, at_move(s, move, "the reported inverse move does not lead back"));
    } else {
      required.that(move.refused_unchanged, at_move(s, move, "the refused move changed the mesh"));
    }
  }
}

// Compares what the search found with the parameter set: the same meshes, rel boundary.
void judge_search(const PairStudy& s, Judgement& j) {
  Requirements required(j);
  std::vector<std::string> pairs, merged;
  for (const theory::MapNode& node : s.map.nodes) {
    (node.configuration.merged() ? merged : pairs)
        .push_back(mesh::signature(enumerate::glue_region(s.shape.type(), node.configuration)));
  }
  std::sort(pairs.begin(), pairs.end());
  std::sort(merged.begin(), merged.end());
  j.row["search"] = s.searched->size();
  add_found(j, Method::search, counted(static_cast<std::int64_t>(s.searched->size()), "filling"));
  required.that(pairs == *s.searched,
                at_region(s, "search finds " + std::to_string(s.searched->size()) + " fillings, not the " +
                                 std::to_string(pairs.size()) + " of the parameter set"));
  if (s.searched_merged) {
    required.that(merged == *s.searched_merged,
                  at_region(s, "search finds " + std::to_string(s.searched_merged->size()) +
                                   " merged fillings, theory " + std::to_string(merged.size())));
  }
}

// The walk visits each configuration of the parameter set once, each predicted edge both ways, and nothing else.
void judge_walk(const PairStudy& s, Judgement& j) {
  Requirements required(j);
  const enumerate::WalkResult& w = *s.walked;
  j.row["walk"] = w.configurations;
  j.row["walk_edges"] = w.edges;
  add_found(j, Method::walk,
            counted(w.configurations, "configuration") + ", " + std::to_string(w.edges) + " of " +
                counted(w.predicted_edges, "edge"));
  j.checks += w.identifications;
  required.that(w.problem.empty(), {"walk: " + w.problem, w.configuration, "", w.mesh});
  required.that(w.configurations == s.exact_count,
                at_region(s, "the closed form gives " + std::to_string(s.exact_count) + ", the walk visits " +
                                 std::to_string(w.configurations)));
  required.that(w.complete(),
                at_region(s, "the walk visits " + std::to_string(w.configurations) + " of " +
                                 std::to_string(w.predicted) + " configurations and " + std::to_string(w.edges) +
                                 " of " + std::to_string(w.predicted_edges) + " edges"));
}

}  // namespace

// There is at most one configuration unless 4 divides the valence. Then there are as many as the singular circulant has
// positive solutions: (L-1)^2 in a regular region of side L. Compares the search with the predicted meshes, which are
// glued.
Judgement judge_theorem_1(const VertexStudy& s) {
  if (!s.searched || s.valence() == 4) return not_applicable();
  Judgement j;
  Requirements required(j);
  const int valence = s.valence();
  std::vector<std::string> predicted;
  for (const mesh::Region& region : s.glued) predicted.push_back(mesh::signature(region));
  std::sort(predicted.begin(), predicted.end());
  j.row = {{"valence", valence},
           {"sides", side_list(s.sides)},
           {"predicted", predicted.size()},
           {"search", s.searched->size()}};
  j.predicted = counted(static_cast<std::int64_t>(predicted.size()), "positive solution") + " of the circulant";
  j.found = counted(static_cast<std::int64_t>(s.searched->size()), "filling") + " by search";
  required.that(predicted == *s.searched, at_region(s, "search finds " + std::to_string(s.searched->size()) +
                                                           " configurations, the circulant has " +
                                                           std::to_string(predicted.size()) + " positive solutions"));
  required.that(valence % 4 == 0 || s.searched->size() <= 1,
                at_region(s, "more than one configuration though 4 does not divide the valence"));
  const bool regular = s.sides.minCoeff() == s.sides.maxCoeff();
  const auto length = static_cast<std::size_t>(s.sides(0));
  if (regular && valence % 4 == 0) {
    required.that(s.searched->size() == (length - 1) * (length - 1), at_region(s, "not (L-1)^2 configurations"));
  }
  return j;
}

Judgement judge_theorem(const PairStudy& s) {
  const int predicted = s.pairs_predicted();
  // Only the search can find out that a region has no configuration. Without it theory would be compared with theory.
  const bool predicted_empty = s.exact_count == 0 && s.map.nodes.empty();
  if (predicted_empty && !s.search_asked && s.found.nodes.empty()) return not_applicable();
  Judgement j;
  Requirements required(j);
  required.that(!s.search_asked || s.searched, at_region(s, "the region was not searched"));
  j.row = {{"sides", side_list(s.shape.sides())}, {"predicted", s.exact_count}, {"parameters", predicted}};
  required.that(s.exact_count == predicted, at_region(s, "the closed form gives " + std::to_string(s.exact_count) +
                                                             ", the parameter set has " + std::to_string(predicted)));
  if (is_regular(s)) {
    const theory::Integer expected = tau(s, s.shape.longest());
    j.row["tau"] = expected;
    j.predicted = tau_text(s, s.shape.longest());
    required.that(expected == predicted, at_region(s, "tau is " + std::to_string(expected) +
                                                          ", the parameter set has " + std::to_string(predicted)));
  } else if (!is_quad(s)) {
    const theory::Integer length = theory::smallest_regular(s.shape);
    const theory::Integer bound = tau(s, length);
    j.row["bound"] = bound;
    j.predicted = "exactly " + std::to_string(s.exact_count) + ", at most " + tau_text(s, length);
    required.that(predicted <= bound, at_region(s, std::to_string(predicted) + " configurations exceed the bound " +
                                                       std::to_string(bound)));
  } else {
    const theory::QuadCount quad = theory::quad_count(s.shape);
    j.row["M"] = quad.m;
    j.row["N"] = quad.n;
    j.predicted = "K = " + std::to_string(quad.m) + " x " + std::to_string(quad.n) + " = " + std::to_string(quad.k());
  }
  if (!s.found.nodes.empty()) judge_moves(s, j);
  if (s.searched) judge_search(s, j);
  if (s.walked) judge_walk(s, j);
  if (predicted_empty) j.row = nullptr;  // the report counts these regions; it has a row for each of the others
  return j;
}

}  // namespace requad::verify
