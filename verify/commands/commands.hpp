// The commands of requad-verify, each in a source of its own. main.cpp has the table of them.
#pragma once

#include "mesh/program/program.hpp"
#include "verify/commands/processes.hpp"

namespace requad::verify {

// Checks claims; it has no command name. The processes must outlive the command.
program::Command campaign_command(Processes& processes);
// check: starts requad-verify-check, which is in the same folder as this program and shares no code with it. `self` is
// the name by which this program was called.
program::Command check_command(const Processes& processes, const char* self);

}  // namespace requad::verify
