// Help texts, laid out from the table of commands.

#include <algorithm>

#include "mesh/program/layout.hpp"
#include "mesh/program/program.hpp"

namespace requad::program {

namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kWidestLeft = 24;  // what is longer has a line of its own

// "-o, --output FILE".
std::string left_column(const Option& option) {
  const std::string name = option.long_name();
  const std::string letter = name == option.name ? "" : "-" + option.name.substr(name.size() + 1) + ", ";
  return letter + "--" + name + (option.argument.empty() ? "" : " " + option.argument);
}

std::string options_text(const std::vector<Option>& options) {
  std::size_t width = 0;
  for (const Option& option : options) {
    const std::size_t size = left_column(option).size();
    if (size <= kWidestLeft) width = std::max(width, size);
  }
  const std::size_t indent = width + 4;
  std::string text;
  for (const Option& option : options) {
    const std::string left = "  " + left_column(option);
    std::vector<std::string> lines = wrapped(option.meaning, indent, kWidth);
    if (left.size() + 2 <= indent && !lines.empty()) {
      lines.front().replace(0, left.size(), left);
    } else {
      lines.insert(lines.begin(), left);
    }
    for (const std::string& line : lines) text += line + "\n";
  }
  return text;
}

// "  requad-edit info IN", one line for each form.
std::string usage_text(const Program& program, const Command& command) {
  std::string text;
  for (const std::string& form : command.usage) {
    text += "  " + program.name;
    for (const std::string& part : {command.name, form}) text += (part.empty() ? "" : " ") + part;
    text += "\n";
  }
  return text;
}

std::string examples_text(const std::vector<std::string>& examples) {
  std::string text = "\nExamples:\n";
  for (const std::string& example : examples) text += "  " + example + "\n";
  return text;
}

// A sentence, broken into lines.
std::string sentence(const std::string& text) {
  std::string broken;
  for (const std::string& line : wrapped(text, 0, kWidth)) broken += line + "\n";
  return broken;
}

std::string exit_codes_text(const std::string& codes) { return sentence("Exit code: " + codes); }

// A paragraph, if there is one.
std::string paragraph(const std::string& text) { return text.empty() ? "" : "\n" + text; }

std::string own_text(const Command& command) {
  return paragraph(command.text) + (command.options.empty() ? "" : "\nOptions:\n" + options_text(command.options));
}

}  // namespace

std::string program_help(const Program& program) {
  std::string text = sentence(program.name + ": " + program.summary);
  std::string commands;
  std::vector<std::string> examples;
  for (const Command& command : program.commands) {
    if (command.name.empty()) {
      text += "\nUsage:\n" + usage_text(program, command) + own_text(command);
      examples.insert(examples.end(), command.examples.begin(), command.examples.end());
    } else {
      commands += usage_text(program, command);
      for (const std::string& line : wrapped(command.summary, 6, kWidth)) commands += line + "\n";
      if (!command.examples.empty()) examples.push_back(command.examples.front());
    }
  }
  text += "\nCommands:\n" + commands + "`" + program.name + " COMMAND --help` explains a command and its options.\n";
  return text + paragraph(program.text) + "\nCommon options:\n" + options_text(common_options()) + "\n" +
         exit_codes_text(program.exit_codes) + examples_text(examples);
}

std::string command_help(const Program& program, const Command& command) {
  std::string common;
  for (const Option& option : common_options()) {
    const std::string argument = option.argument.empty() ? "" : " " + option.argument;
    common += (common.empty() ? "--" : "  --") + option.long_name() + argument;
  }
  const std::string title = program.name + (command.name.empty() ? "" : " " + command.name);
  return sentence(title + ": " + command.summary) + "\nUsage:\n" + usage_text(program, command) + own_text(command) +
         paragraph(program.text) + "\nCommon options: " + common + "\n" +
         exit_codes_text(command.exit_codes.empty() ? program.exit_codes : command.exit_codes) +
         examples_text(command.examples);
}

}  // namespace requad::program
