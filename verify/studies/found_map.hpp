// The found moves as a configuration map: which configuration each move leads to, and in which order the moves lie
// round a configuration. Both are read off meshes, so that the predicted map can be compared with it.
//
// How the order is read. A move displaces the pair by one step, which the labels before and after it show.
//   equal valences   v2, as v1 sees it, lies d2 edges along v1's first leg and d1 edges along its second leg. The first
//                    leg is turned counter-clockwise to the second one, so (d2, d1) are coordinates on the mesh, and the
//                    moves lie in the order of the angles of their steps (Delta d2, Delta d1). A segment has two frames;
//                    turning one by a right angle lays its segment on that of the other.
//   3-5              A move brings the pair nearer to one side, the strips of which become fewer. The moves lie in the
//                    order of these sides round the boundary.
//   merged vertex    A move parts the vertex along an edge. The moves lie in the order of these edges round the vertex.
// The coordinates (m,n) = (d1,d2) of equal valences are those of the mesh mirrored. There the map has the moves
// clockwise on the mesh, which is counter-clockwise in (m,n), as in the predicted map.
#pragma once

#include <string>

#include "verify/studies/study.hpp"

namespace requad::verify {

// Its nodes are those of the predicted map. A pair has four places for moves, a merged v2 one, a merged v6 three. The place of a move that was refused, or
// that nothing found, has no target, and its labelling and step mean nothing. Throws std::logic_error if the moves are
// no map: if a move changes the labels by none of the four steps, if two moves of a configuration make one step, or if
// no move leads back; the message names it.
theory::ConfigurationMap found_map(const PairStudy& study);

// What differs between a node of the predicted map and the same node of the found one, or "": the configurations that
// its moves lead to, the labelling and the step of a move, the cyclic order of the moves. O(1).
std::string node_difference(const theory::ConfigurationMap& predicted, const theory::ConfigurationMap& found,
                            std::size_t node);

}  // namespace requad::verify
