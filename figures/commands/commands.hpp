// The commands of requad-figures, each in a source of its own. main.cpp has the table of them.
#pragma once

#include "mesh/program/program.hpp"

namespace requad::figures {

// Without the name of a command: pictures and grids.
program::Command pictures_command();
// --explorer. Exit code: kCheckFailed if a claim fails in the region.
program::Command explorer_command();

}  // namespace requad::figures
