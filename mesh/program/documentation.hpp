// Documentation for other programs to show, made from the table of commands: manual pages, and completions for shells.
//
// `PROGRAM --documentation FORMAT` prints it; the build and the installation use that (CMakeLists.txt).
#pragma once

#include <string>

#include "mesh/program/program.hpp"

namespace requad::program {

// The options of a command, its own and the flag that chooses it if one does; and those of all commands, each name once.
std::vector<Option> table_of(const Command& command);
std::vector<Option> table_of(const Program& program);

// A page for man(1), section 1: what the help texts of the program and of all its commands say.
std::string manual_page(const Program& program);

// Completions of commands, options, and of the values of options: words where there is a choice, names of files and
// folders. Each is a script that the shell reads from its usual place.
std::string bash_completion(const Program& program);
std::string zsh_completion(const Program& program);
std::string fish_completion(const Program& program);

// One of the above: "man", "bash", "zsh" or "fish". Throws UsageError for anything else.
std::string documentation(const Program& program, const std::string& format);

}  // namespace requad::program
