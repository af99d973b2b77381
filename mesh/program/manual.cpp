// Manual pages, laid out from the table of commands.

#include <sstream>

#include "mesh/program/documentation.hpp"

namespace requad::program {

namespace {

// The text as roff prints it.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) {
      result += std::string("\\&") + c;  // it would be a request
    } else {
      result += c;
    }
  }
  return result;
}

// Prose: lines that start with blanks keep their layout, the others are filled.
std::string prose(const std::string& text) {
  std::string result;
  bool kept = false;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const bool keep = line.starts_with(' ');
    if (keep != kept) result += keep ? ".nf\n" : ".fi\n";
    kept = keep;
    result += line.empty() ? ".PP\n" : roff(line) + "\n";
  }
  return result + (kept ? ".fi\n" : "");
}

std::string options_in_roff(const std::vector<Option>& options) {
  std::string text;
  for (const Option& option : options) {
    const std::string name = option.long_name();
    const std::string letter = name == option.name ? "" : "\\fB\\-" + option.name.substr(name.size() + 1) + "\\fR, ";
    text += ".TP\n" + letter + "\\fB\\-\\-" + roff(name) + "\\fR" +
            (option.argument.empty() ? "" : " \\fI" + roff(option.argument) + "\\fR") + "\n" + prose(option.meaning);
  }
  return text;
}

std::string usage_in_roff(const Program& program, const Command& command) {
  std::string text;
  for (const std::string& form : command.usage) {
    text += ".br\n\\fB" + roff(program.name + (command.name.empty() ? "" : " " + command.name)) + "\\fR " + roff(form) +
            "\n";
  }
  return text;
}

}  // namespace

std::string manual_page(const Program& program) {
  std::string title = program.name;
  for (char& c : title) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  std::string page = ".TH " + roff(title) + " 1 \"\" \"requad " + program.version + "\" \"User Commands\"\n.SH NAME\n" +
                     roff(program.name) + " \\- " + roff(program.summary) + "\n.SH SYNOPSIS\n";
  std::string examples;
  for (const Command& command : program.commands) {
    page += usage_in_roff(program, command);
    for (const std::string& example : command.examples) examples += roff(example) + "\n";
  }
  page += ".SH DESCRIPTION\n" + (program.text.empty() ? roff(program.summary) + "\n" : prose(program.text));
  for (const Command& command : program.commands) {
    if (command.name.empty()) {
      page += ".PP\n" + prose(command.text) + ".SH OPTIONS\n" + options_in_roff(command.options);
      continue;
    }
  }
  page += ".SH COMMANDS\n";
  for (const Command& command : program.commands) {
    if (command.name.empty()) continue;
    page += ".SS " + roff(command.name) + "\n" + roff(command.summary) + ".\n" +
            (command.text.empty() ? "" : ".PP\n" + prose(command.text)) + options_in_roff(command.options) +
            (command.exit_codes.empty() ? "" : ".PP\nExit status: " + roff(command.exit_codes) + ".\n");
  }
  page += ".SH COMMON OPTIONS\n" + options_in_roff(common_options()) + ".SH EXIT STATUS\n" + roff(program.exit_codes) +
          "\n.SH EXAMPLES\n.nf\n" + examples + ".fi\n.SH SEE ALSO\n";
  std::string others;
  for (const char* const other : {"requad-edit", "requad-enumerate", "requad-figures", "requad-verify"}) {
    if (other != program.name) others += (others.empty() ? "" : ", ") + ("\\fB" + roff(other) + "\\fR(1)");
  }
  return page + others + "\n";
}

}  // namespace requad::program
