// The commands of requad-edit. Each is in the source that has its name. main.cpp has the table of all.
#pragma once

#include "mesh/program/program.hpp"

namespace requad::edit {

program::Command info_command();
program::Command draw_command();
program::Command smooth_command();
program::Command subdivide_command();
program::Command moves_command();
program::Command move_command();
program::Command cancel_command();
program::Command merge_command();
program::Command align_command();
program::Command part_command();
program::Command reduce_command();
program::Command atomic_command();
program::Command apply_command();

}  // namespace requad::edit
