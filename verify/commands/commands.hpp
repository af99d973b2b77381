// The commands of requad-verify, each in a source of its own. main.cpp has the table of them.
#pragma once

#include "mesh/program/program.hpp"
#include "verify/claims/claims.hpp"
#include "verify/commands/processes.hpp"

namespace requad::verify {

// Checks claims; it has no command name. The processes must outlive the command. The report quotes the command line.
program::Command campaign_command(Processes& processes, std::string command_line);
// check: starts requad-verify-check, which is in the same folder as this program and shares no code with it. `self` is
// the name by which this program was called.
program::Command check_command(const Processes& processes, const char* self);

// --list, --proofs, --errata and --sentences: they print what is known without a campaign.
program::Command list_command();
program::Command proofs_command();
program::Command errata_command();
program::Command sentences_command();

// The claims that --claim names, each once and in their order on the command line; all if it names none. Throws
// UsageError for what is no claim.
std::vector<const Claim*> named_claims(const program::Options& options);

}  // namespace requad::verify
