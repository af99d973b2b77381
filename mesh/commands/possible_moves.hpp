// The moves that a pair can make, for the commands that list them and that make one of them.
//
// A pair of free vertices that spans a rectangle moves by the steps of section 6. Any other pair moves by a transport:
// an adjacent 3-5 pair leaves one vertex along an edge and is carried to the other, which absorbs it.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "mesh/commands/session.hpp"

namespace requad::edit {

struct PossibleMove {
  std::string step;  // such as "open", or "from 12 to 13" for a transport
  std::string name;  // the step; "open.1", "open.2" where the pair has several moves of one step
  mesh::Refusal refusal = mesh::Refusal::none;
  // Of a move that is not refused:
  std::string effect;
  int operations = 0;
  int faces_made = 0;
  int faces_deleted = 0;
  std::array<mesh::VertexId, 2> after;  // where the two vertices are now; none for one that is regular now
  std::optional<mesh::PairFrame> from;  // of a step: the rectangle before it
  std::optional<mesh::PairFrame> to;    // and after it

  int faces_gained() const { return faces_made - faces_deleted; }
  // Whether --step TEXT means this move: its name, or its step alone.
  bool is_called(const std::string& text) const { return text == name || text == step; }
};

// Makes each move of the pair in turn, calls visit(), and undoes the move. Stops when visit() returns true, and does
// not undo that move. Refusal: wrong_valences if no vertex of the pair has a sector with one quad too few or too many.
mesh::Refusal for_each_move(Session& session, mesh::VertexId a, mesh::VertexId b,
                            const std::function<bool(const PossibleMove&)>& visit);

// A command line may name only one vertex, which cannot move (Theorem 7.1). refuse_one_vertex() reports that and
// returns the exit code.
bool names_one_vertex(const Session& session);
int refuse_one_vertex(Session& session);

}  // namespace requad::edit
