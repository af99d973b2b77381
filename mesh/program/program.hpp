// A program as a table of commands. The table decides what the command line may hold and what the help texts say.
//
// The command line of a program is PROGRAM COMMAND ARGUMENT..., with options anywhere. The first argument that is
// neither an option nor the value of one names the command. To add a command, write a function that returns a Command,
// in a source of its own in the program's commands/ folder. Declare the function in commands.hpp, list the source in
// CMakeLists.txt, and enter the function in the table of main.cpp; all three are in that folder.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "mesh/program/options.hpp"
#include "mesh/program/run/outputs.hpp"
#include "mesh/program/run/run.hpp"

namespace requad::program {

struct Command {
  // Three kinds of names: a word; "--word" for a command that is chosen by this flag; "" for the command that runs if
  // no other is named.
  std::string name;
  std::vector<std::string> usage;     // for each form what follows the name, as "IN A B -o OUT"
  std::string summary;                // one line: what the command does
  std::string text = "";              // prose for the command's help, at most 80 columns wide
  std::vector<std::string> examples;  // whole command lines
  std::vector<Option> options;        // beside the common ones; all others are refused
  // How many words may follow the name.
  struct WordCount {
    std::size_t least, most;
  };
  WordCount words = {0, 0};
  std::string exit_codes = "";          // their meaning, in one sentence, if it is not that of the program's
  std::vector<std::size_t> files = {};  // which of these words name files to read, or "-" for standard input
  // Whether run_program() calls Options::require_outputs(). If not, run() does when it can.
  bool outputs_are_known = true;
  std::function<int(const Options&)> run;  // returns an exit code, or throws UsageError
};

struct Program {
  std::string name;  // "requad-edit"
  std::string version;
  std::string summary;     // one line: what the program does
  std::string exit_codes;  // their meaning, in one sentence
  std::string text;        // prose for the help of the program and of each command, at most 80 columns wide
  std::vector<Command> commands;
};

// The main function of a program: answers --help and --version, or chooses the command and runs it, inside run(). Exits
// with kBadInput and one line on standard error if the command line is not one of the table.
int run_program(int argc, char** argv, const Program& program);

// The help of the program: every command in a line or two, and an example of each.
std::string program_help(const Program& program);
// The help of one command: its options and all its examples.
std::string command_help(const Program& program, const Command& command);

// The end of a command: commits the outputs, with the JSON where --json asks for it. Then prints the text, fitted to
// the width of the terminal (layout.hpp), unless standard output is taken or --quiet is given. Throws UsageError.
void finish(const Options& options, const std::string& json, const std::string& text, Outputs outputs = {});

}  // namespace requad::program
