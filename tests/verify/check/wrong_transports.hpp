// Scripts that look like slides and are none, since they transport no adjacent pair from one vertex to the other.
//
//   comes back   p moves by an edge, and the adjacent pair that it leaves goes round q and is absorbed by p again. Round q
//                the pair turns by a right angle, so p has moved by a diagonal. This leads where a slide leads.
//   apart        p moves by a diagonal and leaves a v3 and a v5 that have no edge in common. Flips transport them. (They
//                would move q by a diagonal, which is as far as two moves go. So this leads nowhere in the end.)
#pragma once

#include "tests/verify/check/proof.hpp"

namespace requad::tests {

enum class WrongTransport { comes_back, apart };

// Such a script for the edge, empty if there is none. The first kind leads to the edge's second mesh. Exhausts the
// transports, by operations on face lists.
Script wrong_transport(const ListedRegion& region, const ListedEdge& edge, WrongTransport kind);

}  // namespace requad::tests
