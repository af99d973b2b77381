// The complementary operations of section 8: cancel, merge, align, and changes of type.
//
// All of them are couriers sent from one irregular vertex to another (transport.hpp), or pair moves (pair_moves.hpp)
// where the pair spans a rectangle. Each leaves the mesh as it was if it can not be finished, and then says why.
#pragma once

#include <array>
#include <vector>

#include "mesh/irregular/pair_moves.hpp"
#include "mesh/irregular/transport.hpp"

namespace requad::mesh {

// What a cancellation did.
struct Cancellation {
  Refusal refusal = Refusal::none;
  Obstacles obstacles;  // in the way of couriers, where the refusal is no_way
  int transports = 0;
  int steps = 0;                  // operations
  std::vector<VertexId> helpers;  // where the vertices that took the couriers are now, those that are still irregular
};

// Cancels a v3 and a v5 (or brings a vertex of higher valence nearer to regular). The v3 walks to the v5 along a
// shortest path; every step sends a courier to one of the helpers, which moves by an edge each time; the last courier
// is the adjacent pair itself. The helpers are the third vertices of section 8, at least one; a helper that a courier
// makes regular drops out (a 3-3-5-5 removal).
//
// A fixed vertex is a v3 or v5 by the excess of one of its sectors (sectors.hpp).
//
// Refusals: wrong_valences; index for two of one sign, which can not cancel each other; lone_pair without helpers;
// no_way if the v3 can not reach the v5 or a courier no helper. Cost: (distance of the pair) journeys.
Cancellation cancel_pair(Editor& editor, PairTransport& transport, VertexId three, VertexId five,
                         const std::vector<VertexId>& helpers);

// The vertices nearest to some vertex for which wanted(v) holds, nearest first, at most `most`. Looks through vertices
// that may change, no further than it must and not beyond fixed ones.
template <class Wanted>
std::vector<VertexId> nearest(const Editor& editor, BreadthFirstDistances& surroundings, VertexId from, int most,
                              Wanted&& wanted) {
  std::vector<VertexId> found;
  surroundings.measure(
      editor.mesh(), std::array{from}, [&](VertexId v) { return editor.sectors().may_change(v); },
      [&](VertexId v) { return !editor.is_fixed(v); },
      [&](VertexId v, int) {
        if (v != from && wanted(v)) found.push_back(v);
        return static_cast<int>(found.size()) >= most;
      });
  return found;
}

// A pair that a sequence of pair moves made.
struct PairResult {
  Refusal refusal = Refusal::none;
  int moves = 0;
  PairFrame frame;  // of the pair in the end; extents 0, 0 if it is merged
};
// Merges a 3-3 pair into a v2, or a 5-5 pair into a v6, by pair moves. Refusals: wrong_valences, odd_distance, or the
// one of the move that was refused. A pair that spans no rectangle: no_rectangle.
PairResult merge_pair(Editor& editor, VertexId v1, VertexId v2);
// Moves a 3-3 or 5-5 pair until d1 or d2 is 0, by as few moves as there are ways, first those that change the fewest
// faces.
PairResult align_pair(Editor& editor, VertexId v1, VertexId v2);

// Parts a vertex of valence 2 or more than 5 by one operation into vertices nearer to regular: a v2 by a collapse, a
// higher one by a split with as many edges on either side as possible. Refusals: wrong_valences, or those of the
// operation, if all of them are refused. (Figure 5)
Refusal part_vertex(Editor& editor, VertexId v);
// Parts until every unfixed vertex is of valence 3, 4 or 5; the number of operations made.
int part_all(Editor& editor);

}  // namespace requad::mesh
