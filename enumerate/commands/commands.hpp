// The commands of requad-enumerate. Each is in the source that has its name. main.cpp has the table of all.
#pragma once

#include "mesh/program/program.hpp"

namespace requad::enumerate {

program::Command region_command();
program::Command configurations_command();
program::Command graph_command();
program::Command path_command();
program::Command search_command();
program::Command sphere_command();
program::Command signature_command();
program::Command tau_command();

}  // namespace requad::enumerate
