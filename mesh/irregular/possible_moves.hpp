// The moves that a pair can make on a real mesh, with their effects.
//
// A pair of free vertices that spans a rectangle moves by the steps of section 6 (pair_moves.hpp). Any other pair moves
// by a transport (transport.hpp): an adjacent 3-5 pair leaves one vertex along an edge and is carried to the other, which
// absorbs it. No prediction says what a move does. Each move is made, looked at, and rolled back.
//
// Costs: those of all moves.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "mesh/irregular/pair_moves.hpp"
#include "mesh/irregular/transport.hpp"

namespace requad::mesh {

struct PossibleMove {
  std::string step;  // such as "open", or "from 12 to 13" (file_number()) for a transport
  std::string name;  // the step; "open.1", "open.2" where the pair has several moves of one step
  Refusal refusal = Refusal::none;
  Obstacles obstacles;  // of a transport
  // Of a move that is not refused:
  std::string effect;
  EditCounts counts;
  std::array<VertexId, 2> after;  // where the two vertices are now; none for one that is regular now
  std::optional<PairFrame> from;  // of a step: the rectangle before it
  std::optional<PairFrame> to;    // and after it

  int faces_gained() const { return counts.faces_made - counts.faces_deleted; }
  // Whether a user who writes TEXT means this move: its name, or its step alone.
  bool is_called(const std::string& text) const { return text == name || text == step; }
};

// "(d1,d2)", the extents of the pair's rectangle.
std::string extents_text(const PairFrame& frame);

// Makes each move of the pair in turn, calls visit(), and undoes the move. Stops when visit() returns true, and does
// not undo that move. Refusal: wrong_valences if no sector of one of the two vertices has one quad too few or too many.
// Precondition: the vertices are live.
Refusal for_each_move(Editor& editor, VertexId a, VertexId b, const std::function<bool(const PossibleMove&)>& visit);

}  // namespace requad::mesh
