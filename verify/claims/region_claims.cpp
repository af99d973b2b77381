// The claims about convex regions and what can be made of them (sections 1, 7, 8).
#include "verify/claims/judging.hpp"
#include "verify/claims/table.hpp"

namespace requad::verify {

std::vector<Claim> region_claims() {
  using enum Family;
  const std::set<Family> kPairs{regular_digon, regular_hexagon, quad, other_digon, other_hexagon};
  const std::set<Family> kEqualPairs{regular_digon, regular_hexagon, other_digon, other_hexagon};
  constexpr Method kMoves = Method::moves;
  constexpr Method kSearch = Method::search;
  constexpr Method kWalk = Method::walk;
  constexpr const char* kTheoremCompares =
      "closed form, parameter set, configurations and graph found by moves, with labels, fillings found by search, "
      "configurations and edges walked on one mesh, by separatrix vectors";
  return {
      {
          .id = "T1",
          .where = "Theorem 7.1",
          .statement =
              "A single irregular vertex whose valence 4 does not divide has at most one configuration. (Sharp: in a "
              "regular region of side L, a v8 or v12 has (L-1)^2.)",
          .compares = "fillings found by search, positive solutions of the circulant system, glued",
          .fails_if = "the search finds a filling that no positive solution gives, or lacks one; or two where 4 does "
                      "not divide the valence; or not (L-1)^2 in a regular region where it does",
          .families = {single_vertex},
          .methods = {kSearch},
          .check = judge_theorem_1,
      },
      {
          .id = "T2",
          .where = "Theorem 7.2",
          .statement = "A regular digon of side L with a 3-3 pair has tau(L) configurations, parametrised by (m,n), "
                       "four steps; a non-regular one has at most tau of the smallest regular digon around it.",
          .compares = kTheoremCompares,
          .fails_if = "two of the counts differ, or two of the sets of signatures; an edge, a label or the order of "
                      "the moves round a configuration differs from the predicted one; or the count exceeds the bound",
          .families = {regular_digon, other_digon},
          .methods = {kMoves, kSearch, kWalk},
          .check = judge_theorem,
      },
      {
          .id = "T3",
          .where = "Theorem 7.3",
          .statement =
              "A regular hexagon of side L with a 5-5 pair has tau(L) configurations, parametrised by (m,n,p), four "
              "steps; a non-regular one has at most tau of the smallest regular hexagon around it.",
          .compares = kTheoremCompares,
          .fails_if = "two of the counts differ, or two of the sets of signatures; an edge, a label or the order of "
                      "the moves round a configuration differs from the predicted one; or the count exceeds the bound",
          .families = {regular_hexagon, other_hexagon},
          .methods = {kMoves, kSearch, kWalk},
          .check = judge_theorem,
      },
      {
          .id = "T4",
          .where = "Theorem 7.4",
          .statement = "A convex region with a 3-5 pair has K = M N configurations, parametrised by (m,n), four steps.",
          .compares = kTheoremCompares,
          .fails_if = "two of the counts differ, or two of the sets of signatures; or an edge, a label or the order of "
                      "the moves round a configuration differs from the predicted one",
          .families = {quad},
          .methods = {kMoves, kSearch, kWalk},
          .check = judge_theorem,
      },
      {
          .id = "G1",
          .where = "Equation 1",
          .statement = "Discrete Gauss-Bonnet, on disks, annuli, spheres, tori and a surface of genus two.",
          .compares = "turns and indices of every configuration, and of surfaces made of it by cutting out quads and "
                      "doubling; 4 chi as the surface is made",
          .fails_if =
              "on one mesh the turns and indices do not sum to 4 chi, or vertices, edges and faces do not give chi",
          .families = kPairs,
          .methods = {kMoves},
          .check = judge_gauss_bonnet,
      },
      {
          .id = "L8",
          .where = "Lemma 7.8",
          .statement = "R_alpha is unique and a d1 x d2 grid; the smallest convex region is its 1-ring.",
          .compares = "rectangles spanned by separatrices; the 1-ring, with the sides of all e_i = 1; all convex "
                      "regions inside a small mesh that have the pair inside, by exhaustion",
          .fails_if = "the separatrices span another number of rectangles, R_alpha is not a d1 x d2 grid of regular "
                      "vertices, its 1-ring is not convex, or a convex region with the pair inside does not contain it",
          .families = kPairs,
          .methods = {kMoves},
          .check = judge_lemma_8,
      },
      {
          .id = "L9",
          .where = "Lemma 7.9",
          .statement = "A convex region has 4 - G sides.",
          .compares = "corners counted on the boundary, indices counted inside",
          .fails_if = "the corners counted on one boundary are not 4 minus the indices inside",
          .families = kPairs,
          .methods = {kMoves},
          .check = judge_lemma_9,
      },
      {
          .id = "L10",
          .where = "Lemmas 7.10, 7.12-7.14",
          .statement =
              "Every convex region grows from R_alpha by strips, with the side lengths of the paper's equations.",
          .compares = "sides after every strip; the grown, the glued and the moved mesh",
          .fails_if = "a strip gives a side another length than the equations, a stage is not convex, or the grown "
                      "region is another mesh than the moves made",
          .families = kPairs,
          .methods = {kMoves},
          .check = judge_growth,
      },
      {
          .id = "T11",
          .where = "Theorem 7.11",
          .statement = "The vector (S_ij, u_ij) determines the configuration.",
          .compares = "separatrix vectors of all configurations of a region",
          .fails_if = "two configurations of one region have the same vector",
          .families = kPairs,
          .methods = {kMoves},
          .check = judge_theorem_11,
      },
      {
          .id = "D5",
          .where = "Definition 7.5",
          .statement = "A sharp convex turn point counts as two corners with a side of length zero between. So R_alpha "
                       "has the sides of the equations with all e_i = 0, and a convex region with irregular vertices "
                       "on its boundary has 4 - G sides.",
          .compares = "sides of R_alpha on the mesh and in the equations; sides and indices of all convex regions "
                      "inside a small mesh, by exhaustion",
          .fails_if = "R_alpha has a side of another length, or one convex region has another number of sides",
          .families = kPairs,
          .methods = {kMoves},
          .check = judge_sharp_turns,
      },
      {
          .id = "S1",
          .where = "Lemma 7.10",
          .statement =
              "Adding a strip to one side is atomic: no convex region with the same irregular vertices lies between. "
              "So a mesh has as many convex regions around its pair as there are choices of 1 to e_i strips.",
          .compares = "all convex regions inside a small mesh, by exhaustion, each with the least larger ones",
          .fails_if = "a least larger region is not the smaller one with one quad at each edge of one side, or their "
                      "number is not the product of the e_i",
          .families = kPairs,
          .methods = {kMoves},
          .check = judge_expansions,
      },
      {
          .id = "U2",
          .where = "proof of 7.2",
          .statement =
              "In a digon each side meets a separatrix of one vertex between two of the other: u20 < u11 < u22, with "
              "u11 - u20 = d1 and u22 - u11 = d2, with the d1 and d2 of Equations 2 and 3. (The proof has d1 and d2 "
              "exchanged, which the symmetric equations of a digon allow.) A segment of length d: one separatrix of "
              "each vertex, d apart.",
          .compares = "where separatrices meet the sides, extents of R_alpha",
          .fails_if = "a side meets other separatrices, or they are not d1 and d2 apart in this order",
          .families = {regular_digon, other_digon},
          .methods = {kMoves},
          .check = judge_digon_meetings,
      },
      {
          .id = "U3",
          .where = "proof of 7.3",
          .statement =
              "In a hexagon exactly four sides meet two separatrices, one of each vertex: two opposite pairs of "
              "neighbours, d2 apart on the first and d1 on the second, counter-clockwise. (As Equation 2 has them; "
              "that the proof names them the other way round is an erratum.) A segment of length d: two opposite "
              "sides, "
              "d apart.",
          .compares = "where separatrices meet the sides, extents of R_alpha",
          .fails_if = "other sides meet two separatrices, both are of one vertex, or they are not d1 and d2 apart in "
                      "this order",
          .families = {regular_hexagon, other_hexagon},
          .methods = {kMoves},
          .check = judge_hexagon_meetings,
      },
      {
          .id = "M1",
          .where = "section 1",
          .statement = "The three moves perform all possible edits: the configuration graph of every convex region "
                       "with a 3-3, 5-5 or 3-5 pair is connected. (The paper has no moves for other pairs.)",
          .compares = "configurations reached from one, parameter set, fillings found by search",
          .fails_if =
              "one configuration of the parameter set, or one filling, is not reached from the first configuration",
          .families = kPairs,
          .methods = {kMoves, kSearch},
          .check = judge_connected,
      },
      {
          .id = "R1",
          .where = "proof of 7.2",
          .statement = "Every configuration is realised by a shortest path of moves: from (0,0) or (0,1) in a regular "
                       "region, in any other one from its simplest configuration.",
          .compares = "the mesh at the end of the path, the mesh found by exploration, distances in the found graph",
          .fails_if = "a path ends in another mesh, or it has more moves than the distance in the found graph",
          .families = kPairs,
          .methods = {kMoves},
          .check = judge_realisation,
      },
      {
          .id = "F1",
          .where = "Figures 10, 11",
          .statement = "Odd and even grids are disconnected from each other, and dual.",
          .compares = "faces of the grid of found moves, nodes and edges of the next smaller one",
          .fails_if = "a configuration has another parity than L, or the faces of the found grid and their neighbours "
                      "are not the nodes and edges of the smaller grid",
          .families = {regular_digon, regular_hexagon},
          .methods = {kMoves},
          .check = judge_dual,
      },
      {
          .id = "N1",
          .where = "section 7",
          .statement = "A 3-5 pair cannot be cancelled inside a convex region.",
          .compares = "fillings of the boundary without irregular vertices, by search; pairs kept by all moves, sides "
                      "of their meshes",
          .fails_if = "the search finds a filling without irregular vertices, a move loses the pair, or a mesh has "
                      "equal opposite sides",
          .families = {quad},
          .methods = {kMoves, kSearch},
          .check = judge_no_cancelling,
      },
      {
          .id = "N2",
          .where = "sections 1, 8",
          .statement =
              "In a regular region a 3-3 or 5-5 pair merges iff its graph distance is even, and it can always "
              "be aligned. (In a non-regular hexagon it merges iff the merged vertex has a configuration there.)",
          .compares = "graph distance on the mesh, what moves reach",
          .fails_if = "a pair at even distance cannot reach the merged vertex, one at odd distance can, or slides do "
                      "not align a pair of a regular region",
          .families = kEqualPairs,
          .methods = {kMoves},
          .check = judge_merging,
      },
      {
          .id = "N3",
          .where = "section 1",
          .statement =
              "Three irregular vertices, a v3 among them, can be edited by cancelling or merging: from every filling "
              "pair moves, transports and single operations lead to fewer irregular vertices. (A 3-5 pair is cancelled "
              "at once, with the help of the third, iff the region can be filled with one vertex, and then in every "
              "filling. With two v3s, edits join all fillings of a region. Three v5s need room: basic operations lead "
              "to fewer irregular vertices iff the region has such a filling.)",
          .compares = "every filling with three vertices, found by search, and the graph of all edits between them; "
                      "the fillings with one or two vertices of any valences, by search, and those that edits reach",
          .fails_if =
              "an edit makes a filling that the search does not know; no path of edits leads from a filling with "
              "a v3 to fewer vertices; a pair is cancelled in some fillings of a region but not where the "
              "search finds one with one vertex; from three v5s operations reach fewer vertices but the search "
              "finds no such filling, or the other way round; no edit reaches a filling with fewer vertices "
              "that an operation parts",
          .families = {three_vertices},
          .methods = {kSearch},
          .check = judge_three_vertices,
      },
      {
          .id = "N4",
          .where = "section 1",
          .statement = "The moves change the smallest possible region.",
          .compares = "the same move in the smallest convex region that holds both ends",
          .fails_if = "the smallest region has no such move, or it takes another number of operations there, or the "
                      "move changes a valence outside that region",
          .families = kPairs,
          .methods = {kMoves},
          .check = judge_locality,
      },
      {
          .id = "N5",
          .where = "section 8",
          .statement = "The last step of a cancellation can be a 3-3-5-5 removal, which cancels two pairs at once.",
          .compares = "in a regular grid all cancellations of a v3 with a v5 after a flip has made 3-3-5-5 and one "
                      "operation has moved them; the last operation of each",
          .fails_if = "in a grid no cancellation ends in a flip that leaves no irregular vertex of four",
          .families = {single_vertex},
          .methods = {kMoves},
          .check = judge_double_removal,
      },
  };
}

}  // namespace requad::verify
