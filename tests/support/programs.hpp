// Calls the programs from outside, in a folder for this test run. Also finds real meshes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace requad::tests {

struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

// Runs requad-PROGRAM in the folder scratch(). A shell splits the arguments.
Outcome call(const std::string& program, const std::string& arguments);

// Runs a bash script in scratch() that finds the programs by their names. Its exit code is that of its last command. The
// script is in scratch()/script.
Outcome shell(const std::string& script);

// Starts the program likewise, and kills it (SIGKILL) as soon as this file in scratch() has this many lines. Returns
// whether the program was killed: false if it ended earlier.
bool killed_at_line(const std::string& program, const std::string& arguments, const std::string& file,
                    std::size_t lines);

// A new folder for this run of the tests.
std::filesystem::path scratch();
std::string slurp(const std::filesystem::path& path);
std::size_t line_count(const std::string& text);
void spill(const std::filesystem::path& path, const std::string& text);

// The path of a mesh in the folder REQUAD_MESH_DIR, or ../shared/meshes from the project's root. If there is none,
// warns that the test is skipped. The README of that folder has the numbers that tests expect.
std::optional<std::string> real_mesh(const std::string& name);
// The path of a mesh in mesh/examples.
std::string example_mesh(const std::string& name);

}  // namespace requad::tests
