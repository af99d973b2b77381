// requad-edit: looks at quad meshes in space and edits them.

#include <algorithm>
#include <iostream>

#include "mesh/commands/command.hpp"

namespace {

using namespace requad;
using edit::Command;
using program::Options;
using program::UsageError;

std::vector<Command> commands() {
  return {edit::info_command(), edit::smooth_command(), edit::subdivide_command(), edit::moves_command(),
          edit::move_command(), edit::cancel_command(), edit::merge_command(),     edit::align_command(),
          edit::part_command(), edit::reduce_command(), edit::atomic_command(),    edit::apply_command()};
}

constexpr const char* kCommon = R"(
IN is an OBJ or OFF file. --subdivide cuts its polygons into quads first, each n-gon into n.
Common options: --json FILE|-   --quiet   --threads N   --help   --version
Exit code: 0 done, 1 a check failed, 2 bad arguments or input, 3 a limit was reached.

Examples:
)";

// Of these commands, all or one.
std::string help(const std::vector<Command>& some) {
  std::string text = "requad-edit: looks at quad meshes in space and edits them\n\n";
  for (const Command& command : some) text += command.usage;
  text += kCommon;
  for (const Command& command : some) {
    for (const std::string& example : command.examples) text += "  " + example + "\n";
  }
  return text;
}

int main_body(int argc, char** argv) {
  const std::vector<Command> all = commands();
  std::string names;
  for (const Command& command : all) names += (names.empty() ? "" : ", ") + command.name;

  // The command is the first argument that names one, so that common options may stand before it. It decides which
  // options there are; without one there are only those.
  std::vector<char*> arguments(argv, argv + argc);
  for (auto argument = arguments.begin(); argument != arguments.end(); ++argument) {
    const auto command = std::find_if(all.begin(), all.end(), [&](const Command& c) { return c.name == *argument; });
    if (argument == arguments.begin() || command == all.end()) continue;
    arguments.erase(argument);
    const Options options(static_cast<int>(arguments.size()), arguments.data(), command->options);
    if (program::answered(options, "requad-edit", REQUAD_VERSION, help({*command}).c_str())) return program::kDone;
    options.require_outputs();
    return command->run(options);
  }
  const Options options(argc, argv, {});
  if (program::answered(options, "requad-edit", REQUAD_VERSION, help(all).c_str())) return program::kDone;
  if (options.words().empty()) throw UsageError("expected one of " + names + "; see --help");
  throw UsageError("'" + options.words().front() + "' is not one of " + names + "; see --help");
}

}  // namespace

int main(int argc, char** argv) {
  return program::run("requad-edit", [argc, argv] { return main_body(argc, argv); });
}
