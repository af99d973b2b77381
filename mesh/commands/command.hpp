// The commands of requad-edit: what each adds to the program, and what they share.
//
// A new command is one function that returns a Command, in a source of its own, and one entry in edit_main.cpp's table.
#pragma once

#include <string>
#include <vector>

#include "mesh/files/feature_edges.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/program/options.hpp"

namespace requad::edit {

struct Command {
  std::string name;
  std::string usage;                  // one line for each form, and indented lines of explanation
  std::vector<std::string> examples;  // whole command lines
  program::OptionTable options;       // beside the common ones; any other is refused
  int (*run)(const program::Options& options);
};

Command info_command();
Command smooth_command();
Command subdivide_command();
Command atomic_command();
Command moves_command();
Command move_command();
Command cancel_command();
Command merge_command();
Command align_command();
Command part_command();
Command reduce_command();
Command apply_command();

// The surface in the one file that the command line names, subdivided if --subdivide says so.
mesh::Surface read_input(const program::Options& options, const std::string& command);

// The features that --feature-angle or --features ask for; none if neither does. Both is an error.
bool wants_features(const program::Options& options);
mesh::FeatureEdges read_features(const program::Options& options, const mesh::Surface& surface);

// Where -o says the result is to go. Throws UsageError if it is missing or does not name an OBJ file.
std::string output_path(const program::Options& options, const std::string& command);

// "1 vertex", "2 vertices".
std::string counted(int count, const std::string& one, const std::string& many);

}  // namespace requad::edit
