// requad-figures --explorer.
#pragma once

#include "mesh/program/options.hpp"

namespace requad::figures {

// Reads --sides, --pair, --output and --json, writes the page, and gives the program's exit code: a claim that fails in
// the region is a failed check. Throws UsageError.
int explorer_command(const program::Options& options);

}  // namespace requad::figures
