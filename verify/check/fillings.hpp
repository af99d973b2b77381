// How many fillings a convex region has: a count of its own, which lists nothing and knows no theorem about pairs.
//
// Terms
//   filling   a quadrangulated disk with the region's boundary whose interior vertices have valence 4, but for some
//             whose valences are given: the budget. Two are the same if an isomorphism that fixes the boundary joins
//             them.
//   hole      a part of the region that has no quads yet. It is a cyclic word. Each letter is a vertex, with the number
//             of quads that it has so far (those that would lie outside the region included, so that every boundary
//             vertex is to have 4 in the end), whether it lies on the region's boundary, and whether the edge to the
//             next letter does.
//
// The recurrence. In a filling, an edge of the hole either has a quad on it inside the hole, or it is the same as
// another edge of the hole. In the first case both its ends gain a quad, and two vertices with one quad come between
// them. In the second case the hole falls into two, two pairs of vertices become one vertex each, and their quads add
// up. The two edges have an even number of edges between them, since a quadrangulated disk has an even boundary. They
// are not both on the region's boundary, and neither are two vertices that become one. A vertex that no hole has left
// is finished: it has 4 quads, or a number of the budget, which is used up. Each filling makes these choices in one
// way, so the numbers add up, and multiply over the two holes.
//
// check-1  (discrete Gauss-Bonnet) The letters of a hole have sum of (quads - 2) = 4 - sum of (4 - l) over what it uses
//          of the budget. So the budget is parted between two holes in few ways.
//
// check-3  A hole that uses up nothing of the budget is filled by a part of the square grid, perhaps with overlaps. So
// its
//          boundary, drawn in the grid with a turn of (quads - 2) right angles to the left at each letter, closes up.
//          This ends branches early.
//
// check-2  The recurrence counts quadrangulations in which two edges may join the same two vertices, too. With a budget
//          of 3-3, 3-5, 5-5, 2 or 6 there are none, so it counts the simple ones. For let two edges join a and b. They
//          bound a disk D with q_a and q_b corners of quads at a and b, and discrete Gauss-Bonnet for D is
//          q_a + q_b = sum of (4 - l) over the vertices inside D. The sum is at most 2, and q_a, q_b >= 1, so both are
//          1. The quad in the corner at a has both edges as sides, so it has two corners at b, and q_b >= 2. Edges that
//          join a vertex to itself do not occur, since every closed path has even length.
//
// Whether the recurrence ends is not proved but seen: a hole that would need its own number is an error.
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
