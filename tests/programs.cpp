#include "tests/programs.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <sys/wait.h>

#include "tests/catch.hpp"

namespace requad::tests {

namespace fs = std::filesystem;

Outcome call(const std::string& program, const std::string& arguments) {
  const fs::path err = scratch() / "stderr";
  const std::string command = "cd '" + scratch().string() + "' && '" REQUAD_PROGRAM_DIR "/requad-" + program + "' " +
                              arguments + " 2>'" + err.string() + "'";
  std::FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  Outcome outcome;
  char buffer[4096];
  for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) outcome.out.append(buffer, n);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  outcome.err = slurp(err);
  return outcome;
}

fs::path scratch() {
  static const fs::path folder = [] {
    std::string name = (fs::temp_directory_path() / "requad-tests-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    return fs::path(name);
  }();
  return folder;
}

std::string slurp(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void spill(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::optional<std::string> real_mesh(const std::string& name) {
  const char* given = std::getenv("REQUAD_MESH_DIR");
  const fs::path path = fs::path(given ? given : REQUAD_SOURCE_DIR "/../shared/meshes") / (name + ".obj");
  if (fs::exists(path)) return path.string();
  WARN("skipped: " << path.string() << " is missing");
  return std::nullopt;
}

}  // namespace requad::tests
