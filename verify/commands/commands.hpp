// The commands of requad-verify, each in a source of its own. main.cpp has the table of them.
#pragma once

#include "mesh/program/program.hpp"
#include "verify/commands/processes.hpp"

namespace requad::verify {

// Without the name of a command: checks claims. The processes must outlive the command.
program::Command campaign_command(Processes& processes);
// check: starts requad-verify-check, which lies beside this program and shares no code with it. `self` is how this
// program was called.
program::Command check_command(const Processes& processes, const char* self);

}  // namespace requad::verify
