// The commands of requad-enumerate, each in a source of its own name. main.cpp has the table of them.
#pragma once

#include "mesh/program/program.hpp"

namespace requad::enumerate {

program::Command region_command();
program::Command graph_command();
program::Command path_command();
program::Command search_command();
program::Command sphere_command();
program::Command signature_command();

}  // namespace requad::enumerate
