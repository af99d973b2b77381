// requad-verify check: checks certificates again, by a program that shares no code with the one that made them.

#include <filesystem>

#include <unistd.h>

#include "verify/commands/commands.hpp"

namespace requad::verify {

namespace {

// Replaces this program by requad-verify-check. Does not return. Throws UsageError if that program cannot be started.
int check(const std::string& folder, const char* self) {
  std::error_code error;
  const std::filesystem::path running = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string checker =
      ((error ? std::filesystem::path(self) : running).parent_path() / "requad-verify-check").string();
  program::restore_signals();
  execlp(checker.c_str(), checker.c_str(), folder.c_str(), static_cast<char*>(nullptr));
  throw program::UsageError("check: " + checker + " cannot be started");
}

}  // namespace

program::Command check_command(const Processes& processes, const char* self) {
  return {
      .name = "check",
      .usage = {"DIR"},
      .summary = "checks certificates again, by a program that shares no code with what made them",
      .text = R"(DIR is a folder that --certificate wrote. verify/README.md says what it shows.
)",
      .examples = {"requad-verify --claim T2 --certificate proof && requad-verify check proof"},
      .options = {},
      .words = {1, 1},
      .exit_codes = "0 all certificates hold, 1 one does not, 2 one cannot be read, 3 undecided: a limit was reached",
      .run =
          [&processes, self](const program::Options& options) {
            if (!processes.leads()) return static_cast<int>(program::kDone);  // one process checks
            return check(options.words().front(), self);
          },
  };
}

}  // namespace requad::verify
