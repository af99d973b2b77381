// Help texts, laid out from the table of commands.

#include <algorithm>
#include <sstream>

#include "mesh/program/program.hpp"

namespace requad::program {

namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kWidestLeft = 24;  // what is longer has a line of its own

std::string blanks(std::size_t count) { return std::string(count, ' '); }

// The text in lines that end before kWidth, each after `indent` blanks. A line of the text that starts with blanks keeps
// them on every line that it is broken into.
std::vector<std::string> wrapped(const std::string& text, std::size_t indent) {
  std::vector<std::string> lines;
  std::istringstream paragraphs(text);
  for (std::string paragraph; std::getline(paragraphs, paragraph);) {
    const std::string margin = blanks(indent + std::min(paragraph.find_first_not_of(' '), paragraph.size()));
    std::istringstream words(paragraph);
    std::string line = margin;
    for (std::string word; words >> word;) {
      const bool is_first = line.size() == margin.size();
      if (!is_first && line.size() + 1 + word.size() > kWidth) {
        lines.push_back(line);
        line = margin + word;
      } else {
        line += (is_first ? "" : " ") + word;
      }
    }
    lines.push_back(line);
  }
  return lines;
}

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
    std::vector<std::string> lines = wrapped(option.meaning, indent);
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

// A paragraph, if there is one.
std::string paragraph(const std::string& text) { return text.empty() ? "" : "\n" + text; }

std::string own_text(const Command& command) {
  return paragraph(command.text) + (command.options.empty() ? "" : "\nOptions:\n" + options_text(command.options));
}

}  // namespace

std::string program_help(const Program& program) {
  std::string text = program.name + ": " + program.summary + "\n";
  std::string commands;
  std::vector<std::string> examples;
  for (const Command& command : program.commands) {
    if (command.name.empty()) {
      text += "\nUsage:\n" + usage_text(program, command) + own_text(command);
      examples.insert(examples.end(), command.examples.begin(), command.examples.end());
    } else {
      commands += usage_text(program, command);
      for (const std::string& line : wrapped(command.summary, 6)) commands += line + "\n";
      if (!command.examples.empty()) examples.push_back(command.examples.front());
    }
  }
  text += "\nCommands:\n" + commands + "Options stand anywhere; `" + program.name +
          " COMMAND --help` explains those of a command.\n";
  return text + paragraph(program.text) + "\nCommon options:\n" + options_text(common_options()) +
         "\nExit code: " + program.exit_codes + "\n" + examples_text(examples);
}

std::string command_help(const Program& program, const Command& command) {
  std::string common;
  for (const Option& option : common_options()) {
    const std::string argument = option.argument.empty() ? "" : " " + option.argument;
    common += (common.empty() ? "--" : "  --") + option.long_name() + argument;
  }
  return program.name + (command.name.empty() ? "" : " " + command.name) + ": " + command.summary + "\n\nUsage:\n" +
         usage_text(program, command) + own_text(command) + paragraph(program.text) + "\nCommon options: " + common +
         "\nExit code: " + program.exit_codes + "\n" + examples_text(command.examples);
}

}  // namespace requad::program
