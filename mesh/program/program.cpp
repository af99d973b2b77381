#include "mesh/program/program.hpp"

#include <algorithm>
#include <iostream>

#include "mesh/program/documentation.hpp"
#include "mesh/program/layout.hpp"
#include "mesh/program/suggestion.hpp"

namespace requad::program {

namespace {

bool is_flag(const Command& command) { return command.name.starts_with("--"); }

// The command that the arguments name, or the one that runs if none is named; nullptr if there is none.
const Command* find_command(const Program& program, const Options& options) {
  const std::string word = options.words().empty() ? "" : options.words().front();
  const Command* found = nullptr;
  for (const Command& command : program.commands) {
    if (command.name.empty()) found = &command;
  }
  for (const Command& command : program.commands) {
    if (!command.name.empty() && command.name == word) return &command;
    if (is_flag(command) && options.has(command.name.substr(2))) found = &command;
  }
  return found;
}

const Command& required_command(const Program& program, const Options& options) {
  if (const Command* const command = find_command(program, options); command != nullptr) return *command;
  std::string all;
  std::vector<std::string> names;
  for (const Command& command : program.commands) {
    names.push_back(command.name);
    all += (all.empty() ? "" : ", ") + command.name;
  }
  if (options.words().empty()) throw UsageError("expected one of " + all + "; see --help");
  const std::string& word = options.words().front();
  if (const std::string near = suggestion(word, names); !near.empty())
    throw UsageError("'" + word + "' is no command; did you mean '" + near + "'?");
  throw UsageError("'" + word + "' is not one of " + all + "; see --help");
}

void require_words(const Command& command, const std::vector<std::string>& words) {
  const std::string prefix = command.name.empty() ? "" : command.name + ": ";
  if (words.size() > command.words.most)
    throw UsageError(prefix + "unexpected argument '" + words[command.words.most] + "'; see --help");
  if (words.size() < command.words.least)
    throw UsageError(prefix + "expected " + command.usage.front() + "; see --help");
}

int choose_and_run(int argc, char** argv, const Program& program) {
  const Options all(argc, argv, table_of(program));
  if (all.has("help")) {
    const Command* const command = find_command(program, all);
    std::cout << (command == nullptr || command->name.empty() ? program_help(program)
                                                              : command_help(program, *command));
    return kDone;
  }
  if (all.has("version")) {
    std::cout << program.name << ' ' << program.version << '\n';
    return kDone;
  }
  const Command& command = required_command(program, all);
  const std::vector<Option> table = table_of(command);
  std::set<std::string> names;
  for (const Option& option : table) names.insert(option.long_name());
  all.allow_only(command.name, names);
  Options options(argc, argv, table);
  if (!command.name.empty() && !is_flag(command)) options.drop_first_word();
  require_words(command, options.words());
  options.set_files(command.files);
  options.require_effects(command.name);
  if (command.outputs_are_known) options.require_outputs();
  return command.run(options);
}

}  // namespace

std::vector<Option> table_of(const Command& command) {
  std::vector<Option> table = command.options;
  if (is_flag(command)) table.push_back(flag(command.name.substr(2), command.summary));
  return table;
}

std::vector<Option> table_of(const Program& program) {
  std::vector<Option> table;
  for (const Command& command : program.commands) {
    for (const Option& option : table_of(command)) {
      const auto is_known = [&](const Option& other) { return other.long_name() == option.long_name(); };
      if (std::none_of(table.begin(), table.end(), is_known)) table.push_back(option);
    }
  }
  return table;
}

int run_program(int argc, char** argv, const Program& program) {
  return run(program.name, [&] {
    if (argc != 3 || std::string(argv[1]) != "--documentation") return choose_and_run(argc, argv, program);
    std::cout << documentation(program, argv[2]);
    return static_cast<int>(kDone);
  });
}

void finish(const Options& options, const std::string& json, const std::string& text, Outputs outputs) {
  if (options.has("json")) outputs.add(options.text("json"), json + "\n");
  outputs.commit();
  if (!options.on_stdout("json") && !options.on_stdout("output") && !options.quiet()) std::cout << fitted(text);
}

}  // namespace requad::program
