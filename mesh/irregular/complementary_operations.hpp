// The complementary operations of section 8: cancel, merge, align, and changes of type.
//
// A cancellation transports adjacent 3-5 pairs from one irregular vertex to another (transport.hpp). Merging and
// aligning make pair moves (pair_moves.hpp). An operation that cannot be finished leaves the mesh as it was and says
// why.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "mesh/irregular/pair_moves.hpp"
#include "mesh/irregular/transport.hpp"

namespace requad::mesh {

// What a cancellation did.
struct Cancellation {
  Refusal refusal = Refusal::none;
  Obstacles obstacles;  // that transports met, where the refusal is no_path
  int transports = 0;
  int steps = 0;                  // basic operations
  std::vector<VertexId> helpers;  // where the helpers are now that are still irregular
  std::vector<BasicOperation> operations;
  std::vector<std::size_t> ends;  // of each transport, the number of operations up to its last one
};

// How long a cancellation is looked for, in each of the orders that it tries.
struct CancellationEffort {
  int positions = std::numeric_limits<int>::max();  // that its transports may visit together; it ends soon after these
  int detours = 30;  // transports in a row that bring the v3 and the v5 no nearer to each other than they were
};

// Cancels a v3 and a v5, or brings a vertex of higher valence nearer to regular. The v3 moves to the v5 along a
// shortest path, edge by edge. For each edge it leaves an adjacent pair behind, which one of the helpers absorbs. That
// helper moves by an edge, too. The last adjacent pair is made of the v3 and the v5 themselves. The helpers, at least
// one, are the third vertices of section 8. A helper that becomes regular drops out (a 3-3-5-5 removal).
//
// A fixed vertex counts as a v3 or v5 by the excess of one of its sectors (sectors.hpp).
//
// Refusals: wrong_valences; index if both irregularities have one sign, which cannot cancel each other; lone_pair
// without helpers; no_path if the v3 cannot reach the v5 or no helper can be reached with this effort. Costs as many
// transports as the distance of the pair.
// `after_transport(mark)` is called after each transport, which did what the editor did since the mark. It may move
// vertices.
Cancellation cancel_pair(Editor& editor, PairTransport& transport, VertexId three, VertexId five,
                         const std::vector<VertexId>& helpers,
                         const std::function<void(std::size_t mark)>& after_transport = {},
                         const CancellationEffort& effort = {});

// Makes a cancellation again that was rolled back, as long as goes_on(mark) says so after a transport, which did what the
// editor did since the mark. Returns whether all of it was made. Precondition: the mesh has the ids that it had before it.
bool repeat(Editor& editor, const Cancellation& made, const std::function<bool(std::size_t mark)>& goes_on);

// The vertices for which wanted(v) holds that are nearest to `from`, nearest first, at most `most` of them. Looks only
// at vertices that may change, no further than it must, and not beyond fixed ones.
template <class Wanted>
std::vector<VertexId> nearest(const Editor& editor, BreadthFirstDistances& distances, VertexId from, int most,
                              Wanted&& wanted) {
  std::vector<VertexId> found;
  distances.measure(
      editor.mesh(), std::array{from}, [&](VertexId v) { return editor.sectors().may_change(v); },
      [&](VertexId v) { return !editor.is_fixed(v); },
      [&](VertexId v, int) {
        if (v != from && wanted(v)) found.push_back(v);
        return static_cast<int>(found.size()) >= most;
      });
  return found;
}

// The helpers that cancel_pair() takes if a user names none: the irregular vertices nearest to the v3, at most this many.
inline constexpr int kUsualHelpers = 8;
std::vector<VertexId> usual_helpers(const Editor& editor, BreadthFirstDistances& distances, VertexId three,
                                    VertexId five);

// What a sequence of pair moves made of a pair.
struct PairResult {
  Refusal refusal = Refusal::none;
  int moves = 0;
  PairFrame frame;  // of the pair afterwards; d1 = d2 = 0 if it is merged
};
// Merges a 3-3 pair into a v2, or a 5-5 pair into a v6, by pair moves. Refusals: wrong_valences, odd_distance,
// no_rectangle if the pair spans no rectangle, or that of the move that was refused.
PairResult merge_pair(Editor& editor, VertexId v1, VertexId v2);
// Moves a 3-3 or 5-5 pair until d1 or d2 is 0. Takes the way that needs the fewest moves, and of those that need
// equally many first the one that changes the fewest faces.
PairResult align_pair(Editor& editor, VertexId v1, VertexId v2);

// Parts a vertex of valence 2, or of more than 5, by one operation into vertices nearer to regular (Figure 5): a v2 by
// a collapse, a higher one by a split that leaves edges on both sides as evenly as it can. Refusals: wrong_valences, or
// those of the operation if all of them are refused.
Refusal part_vertex(Editor& editor, VertexId v);
// Parts until every free vertex has valence 3, 4 or 5. Returns the number of operations that were performed.
int part_all(Editor& editor);

}  // namespace requad::mesh
