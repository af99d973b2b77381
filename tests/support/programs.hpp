// Calls the programs from outside, in a folder of their own; and real meshes, where there are some.
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

// requad-PROGRAM with these arguments, as a shell would take them, in the folder scratch().
Outcome call(const std::string& program, const std::string& arguments);

// Starts it likewise, and kills it (SIGKILL) as soon as this file in scratch() has so many lines. Whether that is how
// it ended: false if it was done before.
bool killed_at_line(const std::string& program, const std::string& arguments, const std::string& file,
                    std::size_t lines);

// A new folder for this run of the tests.
std::filesystem::path scratch();
std::string slurp(const std::filesystem::path& path);
std::size_t line_count(const std::string& text);
void spill(const std::filesystem::path& path, const std::string& text);

// A mesh of the collection in the folder REQUAD_MESH_DIR, or ../shared/meshes from the project's root; nothing, and a
// warning that the test was skipped, if there is none. The collection's README has the numbers that tests expect.
std::optional<std::string> real_mesh(const std::string& name);

}  // namespace requad::tests
