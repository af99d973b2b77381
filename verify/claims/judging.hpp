// What the checks of claims.hpp share: violations at a node, a move or a region, and loops over both.
#pragma once

#include <string>
#include <utility>

#include "verify/claims/claims.hpp"

namespace requad::verify {

inline bool is_regular(const Study& s) {
  return s.region.family == Family::regular_digon || s.region.family == Family::regular_hexagon;
}
inline bool is_digon(const Study& s) { return s.region.type == theory::kDigon; }
inline bool is_hexagon(const Study& s) { return s.region.type == theory::kHexagon; }
inline bool is_quad(const Study& s) { return s.region.type == theory::kQuad; }

inline Judgement not_applicable() {
  Judgement j;
  j.applies = false;
  return j;
}

inline std::vector<theory::Integer> side_list(const Study& s) { return {s.region.sides.begin(), s.region.sides.end()}; }

// The violation of a node, a move, or the region as a whole (whose first known mesh goes with it).
Violation at_node(const Study& s, std::size_t node, std::string what);
Violation at_move(const Study& s, const enumerate::FoundMove& move, std::string what);
Violation at_region(const Study& s, std::string what);

// Judges every found configuration; `problem` gives "" or what is wrong. Does not apply where nothing was found.
template <class Problem>
Judgement for_each_node(const Study& s, Problem&& problem) {
  Judgement j;
  for (std::size_t i = 0; i < s.found.nodes.size() && !j.violation; ++i) {
    ++j.checks;
    if (std::string what = problem(s.found.nodes[i]); !what.empty()) j.violation = at_node(s, i, std::move(what));
  }
  j.applies = j.checks > 0;
  return j;
}

// Judges every move that was made. Does not apply where none was.
template <class Problem>
Judgement for_each_move(const Study& s, Problem&& problem) {
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

// The checks, by the files that hold them.
// claims_pairs.cpp
Judgement judge_theorem_1(const Study& s);
Judgement judge_theorem(const Study& s);        // T2, T3, T4
Judgement judge_connected(const Study& s);      // M1
Judgement judge_realisation(const Study& s);    // R1
Judgement judge_dual(const Study& s);           // F1
Judgement judge_no_cancelling(const Study& s);  // N1
Judgement judge_merging(const Study& s);        // N2
// claims_moves.cpp
Judgement judge_distance_kept(const Study& s);     // P1
Judgement judge_distance_changed(const Study& s);  // P2
Judgement judge_faces(const Study& s);             // P3
Judgement judge_locality(const Study& s);          // N4
// claims_couriers.cpp
Judgement judge_detour(const Study& s);          // P4
Judgement judge_three_vertices(const Study& s);  // N3
// claims_regions.cpp
Judgement judge_gauss_bonnet(const Study& s);  // G1
Judgement judge_lemma_8(const Study& s);
Judgement judge_lemma_9(const Study& s);
Judgement judge_growth(const Study& s);  // L10
Judgement judge_theorem_11(const Study& s);
// claims_operations.cpp
Judgement judge_single_vertex_operations(const Study& s);  // B1
Judgement judge_valence_changes(const Study& s);           // B2
Judgement judge_inverses(const Study& s);                  // B3
Judgement judge_adjacent_pair(const Study& s);             // A1
Judgement judge_vertex_steps(const Study& s);              // A2
Judgement judge_quadruple(const Study& s);                 // A3
Judgement judge_type_changes(const Study& s);              // A4

}  // namespace requad::verify
