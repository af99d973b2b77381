// The commands of requad-figures. Each has a source of its own. The table of commands is in main.cpp.
#pragma once

#include "mesh/program/program.hpp"

namespace requad::figures {

// The command that runs if none is named: pictures and grids.
program::Command pictures_command();
// --explorer. Exit code: kCheckFailed if a claim fails in the region.
program::Command explorer_command();

}  // namespace requad::figures
