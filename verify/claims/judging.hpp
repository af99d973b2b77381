// What the checks of claims.hpp share: violations at a node, a move or a region, and loops over both.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

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

inline std::vector<theory::Integer> side_list(const theory::IntegerVector& sides) {
  return {sides.begin(), sides.end()};
}

// The violation at a node, at a move, or by the region as a whole. The last one has the region's first known mesh.
Violation at_node(const PairStudy& s, std::size_t node, std::string what);
Violation at_move(const PairStudy& s, const enumerate::FoundMove& move, std::string what);
Violation at_region(const PairStudy& s, std::string what);
Violation at_region(const VertexStudy& s, std::string what);

// Judges every found configuration. `problem` returns what is wrong, or "". Does not apply where nothing was found.
template <class Problem>
Judgement for_each_node(const PairStudy& s, Problem&& problem) {
  Judgement j;
  for (std::size_t i = 0; i < s.found.nodes.size() && !j.violation; ++i) {
    ++j.checks;
    if (std::string what = problem(s.found.nodes[i]); !what.empty()) j.violation = at_node(s, i, std::move(what));
  }
  j.applies = j.checks > 0;
  return j;
}

// Judges every move that was made. Does not apply where no move was made.
template <class Problem>
Judgement for_each_move(const PairStudy& s, Problem&& problem) {
  Judgement j;
  for (const enumerate::FoundMove& move : s.found.moves) {
    if (move.to < 0) continue;
    ++j.checks;
    if (std::string what = problem(move); !what.empty()) {
      j.violation = at_move(s, move, std::move(what));
      break;
    }
  }
  j.applies = j.checks > 0;
  return j;
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

// The edges of a graph as a multiset of pairs of names, the lesser name first. names[i] is the name of vertex i.
std::map<std::pair<int, int>, int> edges_of(const theory::ConfigurationGraph& graph, const std::vector<int>& names);

// The checks, grouped by source.
// theorems.cpp
Judgement judge_theorem_1(const VertexStudy& s);
Judgement judge_theorem(const PairStudy& s);  // T2, T3, T4
// grids.cpp
Judgement judge_connected(const PairStudy& s);    // M1
Judgement judge_realisation(const PairStudy& s);  // R1
Judgement judge_dual(const PairStudy& s);         // F1
// merging.cpp
Judgement judge_no_cancelling(const PairStudy& s);  // N1
Judgement judge_merging(const PairStudy& s);        // N2
// moves.cpp
Judgement judge_distance_kept(const PairStudy& s);     // P1
Judgement judge_distance_changed(const PairStudy& s);  // P2
Judgement judge_faces(const PairStudy& s);             // P3
Judgement judge_locality(const PairStudy& s);          // N4
// transport.cpp
Judgement judge_detour(const PairStudy& s);            // P4
Judgement judge_three_vertices(const TripleStudy& s);  // N3
// regions.cpp
Judgement judge_gauss_bonnet(const PairStudy& s);  // G1
Judgement judge_lemma_8(const PairStudy& s);
Judgement judge_lemma_9(const PairStudy& s);
Judgement judge_growth(const PairStudy& s);  // L10
Judgement judge_theorem_11(const PairStudy& s);
// operations.cpp
Judgement judge_single_vertex_operations(const VertexStudy& s);  // B1
Judgement judge_valence_changes(const Study& s);                 // B2
Judgement judge_inverses(const Study& s);                        // B3
Judgement judge_adjacent_pair(const PairStudy& s);               // A1
Judgement judge_vertex_steps(const VertexStudy& s);              // A2
Judgement judge_quadruple(const VertexStudy& s);                 // A3
Judgement judge_type_changes(const VertexStudy& s);              // A4

}  // namespace requad::verify
