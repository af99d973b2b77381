// Common parts of the commands on pairs: the pair's vertices, and a command that edits one pair.
#pragma once

#include <array>
#include <string>

#include "mesh/commands/session.hpp"
#include "mesh/irregular/possible_moves.hpp"

namespace requad::edit {

// The pair of vertices that the second and the third word name. Throws UsageError.
std::array<mesh::VertexId, 2> pair_of(const Session& session);

// A command line may name only one vertex, which cannot move (Theorem 7.1). refuse_one_vertex() reports that and
// returns the exit code.
bool names_one_vertex(const Session& session);
int refuse_one_vertex(Session& session);

// Runs a command that applies `operation` to a pair and reports the result. Returns the exit code.
using PairOperation = mesh::PairResult (*)(mesh::Editor&, mesh::VertexId, mesh::VertexId);
int edit_pair(const program::Options& options, const std::string& command, PairOperation operation);

}  // namespace requad::edit
