// What the commands on pairs share: the pair's vertices, its extents as text, and a command that edits one pair.
#pragma once

#include <array>
#include <string>

#include "mesh/commands/session.hpp"

namespace requad::edit {

// The session's pair: its second and third word. Throws UsageError.
std::array<mesh::VertexId, 2> pair_of(const Session& session);

// "(d1,d2)", the extents of the pair's rectangle.
std::string extents_text(const mesh::PairFrame& frame);

// A command that applies `operation` to a pair and reports what became of the pair. Returns the exit code.
using PairOperation = mesh::PairResult (*)(mesh::Editor&, mesh::VertexId, mesh::VertexId);
int edit_pair(const program::Options& options, const std::string& command, PairOperation operation);

}  // namespace requad::edit
