// Common parts of the commands on pairs: the pair's vertices, its extents as text, and a command that edits one pair.
#pragma once

#include <array>
#include <string>

#include "mesh/commands/session.hpp"

namespace requad::edit {

// The pair of vertices that the second and the third word name. Throws UsageError.
std::array<mesh::VertexId, 2> pair_of(const Session& session);

// "(d1,d2)", the extents of the pair's rectangle.
std::string extents_text(const mesh::PairFrame& frame);

// Runs a command that applies `operation` to a pair and reports the result. Returns the exit code.
using PairOperation = mesh::PairResult (*)(mesh::Editor&, mesh::VertexId, mesh::VertexId);
int edit_pair(const program::Options& options, const std::string& command, PairOperation operation);

}  // namespace requad::edit
