// The claims about operations on a mesh: basic, atomic and pair-wise (sections 2, 4, 5, 6).
#include "verify/claims/judging.hpp"
#include "verify/claims/table.hpp"

namespace requad::verify {

std::vector<Claim> operation_claims() {
  using enum Family;
  const std::set<Family> kPairs{regular_digon, regular_hexagon, quad, other_digon, other_hexagon};
  const std::set<Family> kEqualPairs{regular_digon, regular_hexagon, other_digon, other_hexagon};
  const std::set<Family> kAll{regular_digon, regular_hexagon, quad, other_digon, other_hexagon, single_vertex};
  constexpr Method kMoves = Method::moves;
  return {
      {
          .id = "B1",
          .where = "section 2",
          .statement = "Every basic operation applied at a single irregular vertex of a regular neighbourhood "
                       "increases the number of irregular vertices.",
          .compares = "irregular vertices before and after every operation at the vertex",
          .fails_if = "an operation at the vertex leaves at most one irregular vertex, or there are not 9 l + l (l - "
                      "1) / 2 of them",
          .families = {single_vertex},
          .methods = {kMoves},
          .check = judge_single_vertex_operations,
      },
      {
          .id = "B2",
          .where = "section 4",
          .statement = "The valence changes of collapse, split and flip.",
          .compares = "all valences before and after every operation at every site",
          .fails_if =
              "after one operation the valence of any vertex is another than section 4 gives, or a vertex is missing",
          .families = kAll,
          .methods = {kMoves},
          .check = judge_valence_changes,
      },
      {
          .id = "B3",
          .where = "section 4",
          .statement = "Collapse and split are inverse; a flip's inverse is the other flip; a flip is one split and "
                       "one collapse; neither collapse nor split is a combination of the other two.",
          .compares = "every operation and its inverse; every flip and all splits with a collapse at its ends; faces "
                      "made, by which no flips and splits make a collapse",
          .fails_if = "an inverse of the stated kind does not restore the mesh, a flip is no split and collapse at its "
                      "ends, or the number of faces changes by another number than 0, 1 or -1",
          .families = kAll,
          .methods = {kMoves},
          .check = judge_inverses,
      },
      {
          .id = "B4",
          .where = "section 2",
          .statement = "A vertex rotation at a single irregular vertex of a regular neighbourhood increases the number "
                       "of irregular vertices.",
          .compares = "irregular vertices before and after the rotation of the vertex and of each vertex on its faces",
          .fails_if = "a rotation leaves at most one irregular vertex, or makes no mesh without taking an edge of a v2",
          .families = {single_vertex},
          .methods = {kMoves},
          .check = judge_rotations,
      },
      {
          .id = "A1",
          .where = "section 5",
          .statement = "An adjacent 3-5 pair moves to each of its six adjacent vertices: two by collapse, two by "
                       "split, two by flip.",
          .compares =
              "all operations after which one adjacent 3-5 pair is left, and which of the six vertices it has moved to",
          .fails_if = "one of the six vertices is not reached by exactly one operation, or not by a collapse next to "
                      "the v3, a flip next to the v5 on a face of their edge, and a split elsewhere",
          .families = {quad},
          .methods = {kMoves},
          .check = judge_adjacent_pair,
      },
      {
          .id = "A2",
          .where = "section 5",
          .statement =
              "v3: each direction by two collapses and two flips, and by one split, which the paper leaves out; "
              "v5: each of five directions by two splits and two flips; nothing else moves them so.",
          .compares = "all operations after which a neighbour has the vertex's valence beside an adjacent 3-5 pair",
          .fails_if = "towards one neighbour there are not exactly so many operations of each kind",
          .families = {single_vertex},
          .methods = {kMoves},
          .check = judge_vertex_steps,
      },
      {
          .id = "A3",
          .where = "section 5",
          .statement = "One flip makes, and one unmakes, 3-3-5-5.",
          .compares = "all flips of a regular grid, and back",
          .fails_if = "one flip makes other valences than 3-3-5-5, or the other flip leaves an irregular vertex",
          .families = {single_vertex},
          .methods = {kMoves},
          .check = judge_quadruple,
      },
      {
          .id = "A4",
          .where = "section 5",
          .statement = "v2 becomes 3-3 by one collapse, v6 becomes 5-5 by one split; any valence other than 3, 4, 5 "
                       "reduces to v3s or v5s.",
          .compares = "all operations at the vertex; splits until no valence is beyond 5",
          .fails_if = "no collapse of a v2 makes 3-3, no split of a v6 makes 5-5, or no sequence of splits ends in v3s "
                      "and v5s alone",
          .families = {single_vertex},
          .methods = {kMoves},
          .check = judge_type_changes,
      },
      {
          .id = "A5",
          .where = "section 5",
          .statement =
              "A v3 beside an adjacent 3-5 pair removes the pair by one split or flip and moves by an edge, a "
              "v5 by one collapse or flip: Figure 4 in reverse. (A v3 also by the collapse that undoes a split.)",
          .compares = "from every mesh that A2 makes, all operations after which one irregular vertex is left",
          .fails_if = "from one of these meshes no operation of the inverse kind leads back, or one that leaves a "
                      "single vertex leads to another mesh",
          .families = {single_vertex},
          .methods = {kMoves},
          .check = judge_pair_removal,
      },
      {
          .id = "A6",
          .where = "section 5",
          .statement = "A vertex of any valence l gets l + 2 by a collapse of each of its l faces. A split along any "
                       "two of its edges with a and b >= 1 others on the two sides parts it in a + 2 and b + 2. The "
                       "other vertices change by one.",
          .compares = "all operations at a vertex of valence 2 to 12, by the irregular valences afterwards",
          .fails_if = "one of these operations makes other valences, or there are not l of the collapses and l (l - 3) "
                      "/ 2 of the splits",
          .families = {single_vertex},
          .methods = {kMoves},
          .check = judge_any_valence,
      },
      {
          .id = "P1",
          .where = "section 6",
          .statement = "A 3-5 move keeps (d1,d2), in four directions.",
          .compares = "labels read off the meshes before and after each move",
          .fails_if = "a move changes d1 or d2, two of the four directions are one step, or not four were tried",
          .families = {quad},
          .methods = {kMoves},
          .check = judge_distance_kept,
      },
      {
          .id = "P2",
          .where = "section 6",
          .statement = "A 3-3 or 5-5 move changes (d1,d2) by one of (+-1,+-1), four directions.",
          .compares = "labels read off the meshes before and after each move",
          .fails_if = "a move changes d1 or d2 by another number than 1, two of the four directions are one step, or "
                      "not four were tried",
          .families = kEqualPairs,
          .methods = {kMoves},
          .check = judge_distance_changed,
      },
      {
          .id = "P3",
          .where = "section 6",
          .statement = "The length of the connecting path determines the faces created or deleted.",
          .compares = "faces of the meshes, faces reported by the move, the closed form of the face count, the length "
                      "of the path",
          .fails_if = "the faces that a move adds are not d1 and d2 combined as the step says, or a mesh has another "
                      "number of faces than the closed form",
          .families = kPairs,
          .methods = {kMoves},
          .check = judge_faces,
      },
      {
          .id = "P4",
          .where = "section 6",
          .statement =
              "The transported pair may take any path, so a sharp feature stays untouched: wherever a path leads round "
              "it, a transport takes one, and every path makes what a move makes.",
          .compares = "each move again, with a feature on an edge that its direct path removes: what the move and "
                      "transports in all directions make, and whether the feature is there; up to perimeter 12 what "
                      "basic operations make that move one adjacent pair round the feature in any order",
          .fails_if =
              "a transport removes the feature or makes what no move makes; some order of operations round the "
              "feature makes what no move makes, or none makes what a transport made; all transports are refused "
              "though some order leads round the feature",
          .families = kPairs,
          .methods = {kMoves},
          .check = judge_detour,
      },
      {
          .id = "P5",
          .where = "section 6",
          .statement = "A 3-5 pair at distance 3 or more moves in each direction from either vertex: the first "
                       "operation moves that vertex and leaves an adjacent 3-5 pair, which is transported until it "
                       "moves the other one. From the v5 only the last operation changes the v3. From the v3 the pair "
                       "may have to pass the v5, which is a v6 meanwhile.",
          .compares = "to perimeter 18, what basic operations make in any order that start at one vertex and move one "
                      "adjacent pair, with what moves make; in larger regions, slides started at either vertex",
          .fails_if =
              "from one vertex no order of operations makes a move, or one makes what no moves make; or a slide "
              "is refused from one vertex, starts at the other one, or makes another mesh",
          .families = {quad},
          .methods = {kMoves},
          .check = judge_pipeline,
      },
      {
          .id = "P6",
          .where = "section 6",
          .statement =
              "On closed surfaces a pair move changes (d1,d2) and the number of quads as its step says, no valence of "
              "any other irregular vertex, and can be undone; or it is refused and changes nothing. Where R_alpha has "
              "room, that is, where it and the faces "
              "round it do not overlap and hold no other irregular vertex, no move is refused, and the inverse move "
              "leads back. The pairs v1, v2 and v2, v1 have the same moves.",
          .compares = "moves of pairs on spheres, tori and surfaces of genus two made of the regions: rectangles and "
                      "quads before and after, the undone move, the inverse move; in the regions, room and strips",
          .fails_if = "a move leaves an invalid mesh, another rectangle, another number of quads or other irregular "
                      "vertices, cannot be undone, "
                      "or is refused and changes the mesh; the move or its inverse is refused where there is room, or "
                      "the inverse does not lead back there; or R_alpha has room in a region though an e_i is 1, or "
                      "none though all are 2 or more",
          .families = kPairs,
          .methods = {kMoves},
          .check = judge_closed_surfaces,
      },
  };
}

}  // namespace requad::verify
