// What the checks of claims.hpp share: violations at a node, a move or a region, and loops over things of one kind.
#pragma once

#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesh/program/layout.hpp"
#include "verify/claims/claims.hpp"

namespace requad::verify {

// Regular in the sense of Theorems 7.2 and 7.3, which say nothing about a 3-5 pair.
inline bool is_regular(const PairStudy& s) { return s.shape.type().symmetric() && s.shape.is_regular(); }
inline bool is_digon(const PairStudy& s) { return s.shape.type() == theory::kDigon; }
inline bool is_hexagon(const PairStudy& s) { return s.shape.type() == theory::kHexagon; }
inline bool is_quad(const PairStudy& s) { return s.shape.type() == theory::kQuad; }

inline Judgement not_applicable() {
  Judgement j;
  j.applies = false;
  return j;
}

// The judgement where an exception kept a check from ending.
inline Judgement broken_off(const std::exception& error) {
  Judgement j;
  j.violation = Violation{error.what(), "", "", std::nullopt};
  return j;
}

inline std::vector<theory::Integer> side_list(const theory::IntegerVector& sides) {
  return {sides.begin(), sides.end()};
}

// The violation at a node, at a move, or by the region as a whole. The last one has the region's first known mesh.
Violation at_node(const PairStudy& s, std::size_t node, std::string what);
Violation at_move(const PairStudy& s, const enumerate::FoundMove& move, std::string what);
Violation at_region(const PairStudy& s, std::string what);
Violation at_region(const VertexStudy& s, std::string what);

using program::counted;

// Judges things of one kind. `predicted` is true of each of them; the judgement says of how many it was found to be.
// problem(x) returns what is wrong with x, or "". violation(x, what) places that. Does not apply where there is nothing
// of the kind.
template <class Things, class Problem, class Place>
Judgement for_each_of(const Things& things, const std::string& thing, std::string predicted, Problem&& problem,
                      Place&& violation) {
  Judgement j;
  std::int64_t true_of = 0;
  for (const auto& x : things) {
    ++j.checks;
    std::string what = problem(x);
    if (what.empty()) ++true_of;
    if (!what.empty() && !j.violation) j.violation = violation(x, std::move(what));
  }
  j.applies = j.checks > 0;
  j.predicted = std::move(predicted);
  j.found = std::to_string(true_of) + " of " + counted(j.checks, thing);
  return j;
}

// Judges every found configuration for which wanted(node) holds.
template <class Wanted, class Problem>
Judgement for_each_node(const PairStudy& s, Wanted&& wanted, std::string predicted, Problem&& problem) {
  using Node = const enumerate::FoundNode*;
  std::vector<Node> nodes;
  for (const enumerate::FoundNode& node : s.found.nodes) {
    if (wanted(node)) nodes.push_back(&node);
  }
  return for_each_of(
      nodes, "configuration", std::move(predicted), [&](Node node) { return problem(*node); },
      [&s](Node node, std::string what) {
        return at_node(s, static_cast<std::size_t>(node - s.found.nodes.data()), std::move(what));
      });
}
// Judges every found configuration.
template <class Problem>
Judgement for_each_node(const PairStudy& s, std::string predicted, Problem&& problem) {
  const auto any = [](const enumerate::FoundNode&) { return true; };
  return for_each_node(s, any, std::move(predicted), problem);
}
inline bool holds_pair(const enumerate::FoundNode& node) { return !node.reading.configuration.merged(); }

// Judges every move that was made.
template <class Problem>
Judgement for_each_move(const PairStudy& s, std::string predicted, Problem&& problem) {
  using Move = const enumerate::FoundMove*;
  std::vector<Move> made;
  for (const enumerate::FoundMove& move : s.found.moves) {
    if (move.to >= 0) made.push_back(&move);
  }
  return for_each_of(
      made, "move", std::move(predicted), [&](Move move) { return problem(*move); },
      [&s](Move move, std::string what) { return at_move(s, *move, std::move(what)); });
}

// Counts requirements and keeps the first violation.
class Requirements {
 public:
  explicit Requirements(Judgement& j) : j_(j) {}
  void that(bool holds, Violation otherwise) {
    ++j_.checks;
    if (!holds && !j_.violation) j_.violation = std::move(otherwise);
  }

 private:
  Judgement& j_;
};

// For each found configuration: the number of moves on a shortest path of found moves from `start` to it, or -1 if no
// path leads there. O(nodes + moves).
std::vector<int> distances_from(const PairStudy& s, std::size_t start);

// The edges of a graph as a multiset of pairs of names, the lesser name first. names[i] is the name of vertex i.
std::map<std::pair<int, int>, int> edges_of(const theory::ConfigurationGraph& graph, const std::vector<int>& names);

// The checks, grouped by source.
// theorems.cpp
Judgement judge_theorem_1(const VertexStudy& s);  // T1
Judgement judge_theorem(const PairStudy& s);      // T2, T3, T4
// grids.cpp
Judgement judge_connected(const PairStudy& s);    // M1
Judgement judge_realisation(const PairStudy& s);  // R1
Judgement judge_dual(const PairStudy& s);         // F1
// merging.cpp
Judgement judge_no_cancelling(const PairStudy& s);     // N1
Judgement judge_merging(const PairStudy& s);           // N2
Judgement judge_double_removal(const VertexStudy& s);  // N5
// moves.cpp
Judgement judge_distance_kept(const PairStudy& s);     // P1
Judgement judge_distance_changed(const PairStudy& s);  // P2
Judgement judge_faces(const PairStudy& s);             // P3
Judgement judge_locality(const PairStudy& s);          // N4
Judgement judge_closed_surfaces(const PairStudy& s);   // P6
// transport.cpp
Judgement judge_detour(const PairStudy& s);    // P4
Judgement judge_pipeline(const PairStudy& s);  // P5
// three_vertices.cpp
Judgement judge_three_vertices(const TripleStudy& s);  // N3
// regions.cpp
Judgement judge_gauss_bonnet(const PairStudy& s);  // G1
Judgement judge_lemma_9(const PairStudy& s);       // L9
Judgement judge_growth(const PairStudy& s);        // L10
// expansions.cpp
Judgement judge_lemma_8(const PairStudy& s);      // L8
Judgement judge_expansions(const PairStudy& s);   // S1
Judgement judge_sharp_turns(const PairStudy& s);  // D5
// separatrices.cpp
Judgement judge_theorem_11(const PairStudy& s);        // T11
Judgement judge_digon_meetings(const PairStudy& s);    // U2
Judgement judge_hexagon_meetings(const PairStudy& s);  // U3
// operations.cpp
Judgement judge_single_vertex_operations(const VertexStudy& s);  // B1
Judgement judge_valence_changes(const Study& s);                 // B2
Judgement judge_inverses(const Study& s);                        // B3
Judgement judge_rotations(const VertexStudy& s);                 // B4
// atomic.cpp
Judgement judge_adjacent_pair(const PairStudy& s);   // A1
Judgement judge_vertex_steps(const VertexStudy& s);  // A2
Judgement judge_quadruple(const VertexStudy& s);     // A3
Judgement judge_type_changes(const VertexStudy& s);  // A4
Judgement judge_pair_removal(const VertexStudy& s);  // A5
Judgement judge_any_valence(const VertexStudy& s);   // A6

}  // namespace requad::verify
