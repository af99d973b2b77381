// How many fillings a convex region has: a count of its own, which lists nothing and knows no theorem about pairs.
//
// Terms
//   filling   a quadrangulated disk with the region's boundary. Its interior vertices have valence 4, except some whose
//             valences are given: the budget. Two fillings are the same if an isomorphism that fixes the boundary joins
//             them.
//   hole      a part of the region that has no quads yet, as a cyclic word. Each letter is a vertex. It holds the
//             number of quads that the vertex has so far, whether the vertex lies on the region's boundary, and whether
//             the edge to the next letter does. Quads that would lie outside the region count, too, so that every
//             boundary vertex has 4 in the end.
//
// The recurrence. Take an edge of a hole. In a filling, either a quad lies on it inside the hole, or it is the same
// edge as another one of the hole.
//   - A quad: both ends of the edge gain one, and two vertices with one quad each come between them.
//   - The same: the hole falls into two. Two pairs of vertices become one vertex each, and their quads add up. An even
//     number of edges lies between the two, since a quadrangulated disk has an even boundary. The two edges do not both
//     lie on the region's boundary; nor do two vertices that become one.
// A vertex that no hole has left is finished: it has 4 quads, or a number of the budget, which is then used up. A
// filling determines each of these choices. So the numbers of both cases are added, and those of the two holes
// multiplied.
//
// check-1  (discrete Gauss-Bonnet) The letters of a hole have sum of (quads - 2) = 4 - sum of (4 - l) over what it uses
//          of the budget. So there are few ways to part the budget between two holes.
//
// check-2  A hole that uses nothing of the budget is filled by a part of the square grid, perhaps with overlaps. So its
//          boundary closes up if it is drawn in the grid, with a turn of (quads - 2) right angles to the left at each
//          letter. This ends branches early.
//
// check-3  The recurrence also counts quadrangulations in which two edges join the same two vertices. With the budgets
//          3-3, 3-5, 5-5, 2 and 6 there are none, so that it counts the simple ones. Proof: let two edges join a and b.
//          They bound a disk D, with q_a and q_b corners of quads at a and b. Discrete Gauss-Bonnet for D says that q_a
//          + q_b is the sum of (4 - l) over the vertices inside D. This sum is at most 2, and q_a, q_b >= 1, so both
//          are 1. The quad in the corner at a has both edges as sides. So it has two corners at b, and q_b >= 2. An
//          edge from a vertex to itself does not occur, since every closed path has even length.
//
// No proof says that the recurrence ends. If a hole needs its own number, that is reported.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "verify/check/region.hpp"

namespace check {

class FillingCounter {
 public:
  // The number of fillings whose irregular vertices are the pair of the region, or the one merged vertex instead.
  // Throws Undecided if it takes more than kMostHoles holes. What is known of a hole is kept for the next region.
  std::uint64_t with_pair(const Region& region);
  std::uint64_t with_merged_vertex(const Region& region);

  static constexpr std::size_t kMostHoles = 4'000'000;
  static constexpr std::size_t kKeptHoles = 500'000;  // for the next region
  static constexpr std::size_t kDeepest = 8'000;      // holes within holes

 public:
  // The letters of a hole, and the valences that are left, in ascending order.
  using Word = std::string;
  using Budget = std::string;

  std::uint64_t count(const Region& region, const Budget& budget);
  std::uint64_t hole(Word word, const Budget& budget);
  std::uint64_t covered(const Word& word, const Budget& budget);
  std::uint64_t glued(const Word& word, const Budget& budget);

  std::unordered_map<std::string, std::uint64_t> known_;  // by the least rotation of the word, and the budget
  std::size_t depth_ = 0;
};

}  // namespace check
