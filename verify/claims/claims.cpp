// The table of claims: what each states, what its check compares, and the check.
#include "verify/claims/claims.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "mesh/program/errors.hpp"
#include "verify/claims/judging.hpp"

namespace requad::verify {

Violation at_node(const PairStudy& s, std::size_t node, std::string what) {
  const enumerate::FoundNode& n = s.found.nodes[node];
  return {std::move(what), n.reading.problem.empty() ? theory::label(s.shape.type(), n.reading.configuration) : "", "",
          n.region};
}

Violation at_move(const PairStudy& s, const enumerate::FoundMove& move, std::string what) {
  Violation v = at_node(s, static_cast<std::size_t>(move.from), std::move(what));
  v.move = mesh::name(move.move.step);
  return v;
}

Violation at_region(const PairStudy& s, std::string what) {
  Violation v{std::move(what), "", "", std::nullopt};
  if (!s.found.nodes.empty()) v.mesh = s.found.nodes[0].region;
  return v;
}

Violation at_region(const VertexStudy& s, std::string what) {
  Violation v{std::move(what), "", "", std::nullopt};
  if (!s.glued.empty()) v.mesh = s.glued[0];
  return v;
}

std::string described(const Violation& violation) {
  std::string at;
  if (!violation.configuration.empty()) at += "configuration " + violation.configuration;
  if (!violation.move.empty()) at += (at.empty() ? "" : ", ") + ("move " + violation.move);
  return (at.empty() ? "" : at + ": ") + violation.what;
}

std::string counted(std::int64_t number, const std::string& thing) {
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

namespace {

template <class Kind>
Judgement judged(Judgement (*check)(const Kind&), const Study& study) {
  if constexpr (std::is_same_v<Kind, Study>) {
    return check(study);
  } else {
    const Kind* const one = std::get_if<Kind>(&study);
    return one != nullptr ? check(*one) : not_applicable();
  }
}

}  // namespace

Judgement Claim::judge(const Study& study) const {
  if (families.count(family_of(study)) == 0) return not_applicable();
  return std::visit([&study](const auto known) { return judged(known, study); }, check);
}

Judgement Claim::judge_safely(const Study& study) const {
  try {
    return judge(study);
  } catch (const std::exception& error) {
    if (program::is_exhaustion(error)) throw;
    return broken_off(error);
  }
}

const Claim* find_claim(const std::string& id) {
  const auto it = std::find_if(claims().begin(), claims().end(), [&id](const Claim& c) { return c.id == id; });
  return it == claims().end() ? nullptr : &*it;
}

std::vector<RegionVerdict> judge_region(const Study& study, const std::vector<std::string>& ids) {
  std::vector<RegionVerdict> verdicts;
  for (const std::string& id : ids) {
    const Claim* const claim = find_claim(id);
    if (Judgement j = claim->judge_safely(study); j.applies) verdicts.push_back({claim, std::move(j)});
  }
  return verdicts;
}

const std::vector<Claim>& claims() {
  using enum Family;
  static const std::set<Family> kPairs{regular_digon, regular_hexagon, quad, other_digon, other_hexagon};
  static const std::set<Family> kEqualPairs{regular_digon, regular_hexagon, other_digon, other_hexagon};
  static const std::set<Family> kAll{regular_digon, regular_hexagon, quad, other_digon, other_hexagon, single_vertex};
  constexpr Method kMoves = Method::moves;
  constexpr Method kSearch = Method::search;
  constexpr Method kWalk = Method::walk;
  constexpr const char* kTheoremCompares =
      "closed form, parameter set, configurations and graph found by moves, with labels, fillings found by search, "
      "configurations and edges walked on one mesh, by separatrix vectors";
  static const std::vector<Claim> kClaims{
      {"B1",
       "section 2",
       "Every basic operation applied at a single irregular vertex of a regular neighbourhood increases the number of "
       "irregular vertices.",
       "irregular vertices before and after every operation at the vertex",
       {single_vertex},
       {kMoves},
       judge_single_vertex_operations},
      {"B2",
       "section 4",
       "The valence changes of collapse, split and flip.",
       "all valences before and after every operation at every site",
       kAll,
       {kMoves},
       judge_valence_changes},
      {"B3",
       "section 4",
       "Collapse and split are inverse; a flip's inverse is the other flip; a flip is one split and one collapse; "
       "neither collapse nor split is a combination of the other two.",
       "every operation and its inverse; every flip and all splits with a collapse at its ends; faces made, by which "
       "no flips and splits make a collapse",
       kAll,
       {kMoves},
       judge_inverses},
      {"A1",
       "section 5",
       "An adjacent 3-5 pair moves to each of its six adjacent vertices: two by collapse, two by split, two by flip.",
       "all operations after which one adjacent 3-5 pair is left",
       {quad},
       {kMoves},
       judge_adjacent_pair},
      {"A2",
       "section 5",
       "v3: each direction by two collapses and two flips; v5: each of five directions by two splits and two flips.",
       "all operations after which a neighbour has the vertex's valence beside an adjacent 3-5 pair",
       {single_vertex},
       {kMoves},
       judge_vertex_steps},
      {"A3",
       "section 5",
       "One flip makes, and one unmakes, 3-3-5-5.",
       "all flips of a regular grid, and back",
       {single_vertex},
       {kMoves},
       judge_quadruple},
      {"A4",
       "section 5",
       "v2 becomes 3-3 by one collapse, v6 becomes 5-5 by one split; any valence other than 3, 4, 5 reduces to v3s or "
       "v5s.",
       "all operations at the vertex; splits until no valence is beyond 5",
       {single_vertex},
       {kMoves},
       judge_type_changes},
      {"P1",
       "section 6",
       "A 3-5 move keeps (d1,d2), in four directions.",
       "labels read off the meshes before and after each move",
       {quad},
       {kMoves},
       judge_distance_kept},
      {"P2",
       "section 6",
       "A 3-3 or 5-5 move changes (d1,d2) by one of (+-1,+-1), four directions.",
       "labels read off the meshes before and after each move",
       kEqualPairs,
       {kMoves},
       judge_distance_changed},
      {"P3",
       "section 6",
       "The length of the connecting path determines the faces created or deleted.",
       "faces of the meshes, faces reported by the move, the closed form of the face count, the length of the path",
       kPairs,
       {kMoves},
       judge_faces},
      {"P4",
       "section 6",
       "The transported pair may take any path, so a sharp feature stays untouched.",
       "adjacent pairs transported in all directions, with a feature on an edge that the direct path removes: the "
       "feature, the configurations they make, those that moves reach",
       kPairs,
       {kMoves},
       judge_detour},
      {"T1",
       "Theorem 7.1",
       "A single irregular vertex whose valence 4 does not divide has one configuration. (Sharp: in a regular region "
       "of side L, a v8 or v12 has (L-1)^2.)",
       "fillings found by search, positive solutions of the circulant system, glued",
       {single_vertex},
       {kSearch},
       judge_theorem_1},
      {"T2",
       "Theorem 7.2",
       "A regular digon of side L with a 3-3 pair has tau(L) configurations, parametrised by (m,n), four steps; a "
       "non-regular one has at most tau of the smallest regular digon around it.",
       kTheoremCompares,
       {regular_digon, other_digon},
       {kMoves, kSearch, kWalk},
       judge_theorem},
      {"T3",
       "Theorem 7.3",
       "A regular hexagon of side L with a 5-5 pair has tau(L) configurations, parametrised by (m,n,p), four steps; a "
       "non-regular one has at most tau of the smallest regular hexagon around it.",
       kTheoremCompares,
       {regular_hexagon, other_hexagon},
       {kMoves, kSearch, kWalk},
       judge_theorem},
      {"T4",
       "Theorem 7.4",
       "A convex region with a 3-5 pair has K = M N configurations, parametrised by (m,n), four steps.",
       kTheoremCompares,
       {quad},
       {kMoves, kSearch, kWalk},
       judge_theorem},
      {"G1",
       "Equation 1",
       "Discrete Gauss-Bonnet.",
       "turns and indices of every configuration, 4 chi",
       kPairs,
       {kMoves},
       judge_gauss_bonnet},
      {"L8",
       "Lemma 7.8",
       "R_alpha is unique and a d1 x d2 grid; the smallest convex region is its 1-ring.",
       "rectangles spanned by separatrices; that the 1-ring, which every region with the pair inside contains, is "
       "convex, with the sides of all e_i = 1",
       kPairs,
       {kMoves},
       judge_lemma_8},
      {"L9",
       "Lemma 7.9",
       "A convex region has 4 - G sides.",
       "corners counted on the boundary, indices counted inside",
       kPairs,
       {kMoves},
       judge_lemma_9},
      {"L10",
       "Lemmas 7.10, 7.12-7.14",
       "Every convex region grows from R_alpha by strips, with the side lengths of the paper's equations.",
       "sides after every strip; the grown, the glued and the moved mesh",
       kPairs,
       {kMoves},
       judge_growth},
      {"T11",
       "Theorem 7.11",
       "The vector (S_ij, u_ij) determines the configuration.",
       "separatrix vectors of all configurations of a region",
       kPairs,
       {kMoves},
       judge_theorem_11},
      {"M1",
       "section 1",
       "The three moves perform all possible edits: the configuration graph of every convex region with two irregular "
       "vertices is connected.",
       "configurations reached from one, parameter set, fillings found by search",
       kPairs,
       {kMoves, kSearch},
       judge_connected},
      {"R1",
       "proof of 7.2",
       "Every configuration is realised from (0,0) or (0,1) by a shortest path of moves.",
       "the mesh at the end of the path, the mesh found by exploration, distances in the found graph",
       kPairs,
       {kMoves},
       judge_realisation},
      {"F1",
       "Figures 10, 11",
       "Odd and even grids are disconnected from each other, and dual.",
       "faces of the grid of found moves, nodes and edges of the next smaller one",
       {regular_digon, regular_hexagon},
       {kMoves},
       judge_dual},
      {"N1",
       "section 7",
       "A 3-5 pair cannot be cancelled inside a convex region.",
       "fillings of the boundary without irregular vertices, by search; pairs kept by all moves, sides of their meshes",
       {quad},
       {kMoves, kSearch},
       judge_no_cancelling},
      {"N2",
       "sections 1, 8",
       "In a regular region a 3-3 or 5-5 pair merges iff its graph distance is even, and it can always be aligned. "
       "(In a non-regular hexagon it merges iff there is room for the merged vertex.)",
       "graph distance on the mesh, what moves reach",
       kEqualPairs,
       {kMoves},
       judge_merging},
      {"N3",
       "section 1",
       "Three irregular vertices can be edited by cancelling or merging: a 3-5 pair is cancelled with the help of the "
       "third iff the region can be filled with one vertex, and then in every configuration.",
       "every filling with three vertices, found by search: cancelled and merged by transport and moves, the results "
       "among the fillings with one or two vertices that the search finds",
       {three_vertices},
       {kSearch},
       judge_three_vertices},
      {"N4",
       "section 1",
       "The moves change the smallest possible region.",
       "the same move in the smallest convex region that holds both ends",
       kPairs,
       {kMoves},
       judge_locality},
  };
  return kClaims;
}

}  // namespace requad::verify
