#include "tests/support/programs.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/catch.hpp"

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

Outcome shell(const std::string& script) {
  spill(scratch() / "script", "export PATH='" REQUAD_PROGRAM_DIR "':\"$PATH\"; " + script + "\n");
  return call("edit", "--version >/dev/null; timeout 100 bash script");
}

bool killed_at_line(const std::string& program, const std::string& arguments, const std::string& file,
                    std::size_t lines) {
  const std::string command =
      "cd '" + scratch().string() + "' && exec '" REQUAD_PROGRAM_DIR "/requad-" + program + "' " + arguments;
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  REQUIRE(child > 0);
  int status = 0;
  while (line_count(slurp(scratch() / file)) < lines) {
    if (waitpid(child, &status, WNOHANG) == child) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  REQUIRE(kill(child, SIGKILL) == 0);
  REQUIRE(waitpid(child, &status, 0) == child);
  return WIFSIGNALED(status);
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

std::size_t line_count(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

void spill(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string example_mesh(const std::string& name) { return REQUAD_SOURCE_DIR "/mesh/examples/" + name + ".obj"; }

std::optional<std::string> real_mesh(const std::string& name) {
  const char* given = std::getenv("REQUAD_MESH_DIR");
  const fs::path path = fs::path(given ? given : REQUAD_SOURCE_DIR "/../shared/meshes") / (name + ".obj");
  if (fs::exists(path)) return path.string();
  WARN("skipped: " << path.string() << " is missing");
  return std::nullopt;
}

}  // namespace requad::tests
