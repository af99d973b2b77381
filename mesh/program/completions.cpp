// Completions for bash, zsh and fish, laid out from the table of commands.

#include <algorithm>

#include "mesh/program/documentation.hpp"

namespace requad::program {

namespace {

bool takes_value(const Option& option) { return option.kind != Option::Kind::flag; }
bool takes_file(const Option& option) {
  return option.kind == Option::Kind::input || option.kind == Option::Kind::output ||
         option.kind == Option::Kind::journal;
}

// The words that an option's value is one of: those of "glue|grow|moves"; none if its argument names something else.
std::vector<std::string> choices_of(const Option& option) {
  std::vector<std::string> choices;
  if ((option.kind != Option::Kind::value && option.kind != Option::Kind::list) ||
      option.argument.find('|') == std::string::npos)
    return choices;
  for (std::size_t start = 0; start <= option.argument.size();) {
    const std::size_t end = std::min(option.argument.find('|', start), option.argument.size());
    choices.push_back(option.argument.substr(start, end - start));
    start = end + 1;
  }
  return choices;
}

std::string words_joined(const std::vector<std::string>& words, const std::string& between = " ") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

// "--output" and, if there is one, "-o".
std::vector<std::string> names_of(const Option& option) {
  const std::string name = option.long_name();
  std::vector<std::string> names{"--" + name};
  if (name != option.name) names.push_back("-" + option.name.substr(name.size() + 1));
  return names;
}

std::vector<Option> with_common(std::vector<Option> options) {
  options.insert(options.end(), common_options().begin(), common_options().end());
  return options;
}

std::vector<std::string> names_of(const std::vector<Option>& options) {
  std::vector<std::string> names;
  for (const Option& option : options) names.push_back(names_of(option).front());
  return names;
}

bool is_word(const Command& command) { return !command.name.empty() && !command.name.starts_with("--"); }

// The name as that of a shell function.
std::string function_name(const Program& program) {
  std::string name = "_" + program.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

// The first sentence or line of a text.
std::string gist(const std::string& text) {
  const std::size_t end = std::min(text.find('\n'), text.find("; "));
  return text.substr(0, std::min(end, text.size()));
}

// The text between single quotes; what zsh reads in brackets must have none.
std::string shell_quoted(std::string text, const char* escaped_quote) {
  for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += std::string(escaped_quote).size())
    text.replace(at, 1, escaped_quote);
  return "'" + text + "'";
}

}  // namespace

std::string bash_completion(const Program& program) {
  std::string values, options, commands;
  std::vector<std::string> with_value;
  for (const Option& option : with_common(table_of(program))) {
    if (!takes_value(option)) continue;
    const std::vector<std::string> names = names_of(option), choices = choices_of(option);
    with_value.insert(with_value.end(), names.begin(), names.end());
    const std::string reply = takes_file(option) ? "compgen -f -- \"$cur\""
                              : option.kind == Option::Kind::folder
                                  ? "compgen -d -- \"$cur\""
                                  : "compgen -W '" + words_joined(choices) + "' -- \"$cur\"";
    values += "    " + words_joined(names, "|") + ") mapfile -t COMPREPLY < <(" + reply + "); return ;;\n";
  }
  for (const Command& command : program.commands) {
    if (is_word(command)) commands += (commands.empty() ? "" : " ") + command.name;
    options += "    " +
               (is_word(command)       ? command.name
                : command.name.empty() ? "''"
                                       : "'" + command.name + "'") +
               ") options='" + words_joined(names_of(with_common(table_of(command)))) + "' ;;\n";
  }
  // Options of commands that flags choose can stand beside those of the command that runs if none is named.
  std::string all;
  for (const Command& command : program.commands) {
    if (!is_word(command)) all += " " + words_joined(names_of(table_of(command)));
  }
  return "# bash completion for " + program.name + "\n" + function_name(program) + "() {\n" +
         "  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} command='' options i\n"
         "  COMPREPLY=()\n"
         "  case $prev in\n" +
         values +
         "  esac\n"
         "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
         "    case ${COMP_WORDS[i]} in\n"
         "    " +
         words_joined(with_value, "|") +
         ") ((++i)) ;;\n"
         "    -*) ;;\n"
         "    *) command=${COMP_WORDS[i]}; break ;;\n"
         "    esac\n"
         "  done\n"
         "  case $command in\n" +
         options + "    *) options='" + words_joined(names_of(common_options())) +
         "' ;;\n"
         "  esac\n"
         "  if [[ $cur == -* ]]; then\n"
         "    [[ -n $command ]] || options+='" +
         all +
         "'\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$cur\")\n"
         "  elif [[ -z $command ]]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W '" +
         commands +
         "' -- \"$cur\")\n"
         "  else\n"
         "    mapfile -t COMPREPLY < <(compgen -f -- \"$cur\")\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -F " +
         function_name(program) + " " + program.name + "\n";
}

namespace {

// One argument of zsh's _arguments for each name of the option.
std::string zsh_specifications(const std::vector<Option>& options) {
  std::string text;
  for (const Option& option : options) {
    std::string meaning = gist(option.meaning);
    for (char& c : meaning) c = c == '[' ? '(' : c == ']' ? ')' : c == ':' ? ',' : c;
    for (const std::string& name : names_of(option)) {
      const bool is_long = name.starts_with("--");
      std::string spec = (option.kind == Option::Kind::list ? "*" : "") + name +
                         (takes_value(option) ? is_long ? "=" : "+" : "") + "[" + meaning + "]";
      if (takes_value(option)) {
        spec += ":" + option.long_name() + ":";
        if (takes_file(option)) spec += "_files";
        if (option.kind == Option::Kind::folder) spec += "_files -/";
        if (const auto choices = choices_of(option); !choices.empty()) spec += "(" + words_joined(choices) + ")";
      }
      text += " \\\n      " + shell_quoted(spec, "'\\''");
    }
  }
  return text;
}

}  // namespace

std::string zsh_completion(const Program& program) {
  std::string commands, cases;
  std::vector<Option> own;
  for (const Command& command : program.commands) {
    if (!is_word(command)) {
      for (const Option& option : table_of(command)) {
        const auto is_known = [&](const Option& other) { return other.long_name() == option.long_name(); };
        if (std::none_of(own.begin(), own.end(), is_known)) own.push_back(option);
      }
      continue;
    }
    commands += "    " + shell_quoted(command.name + ":" + command.summary, "'\\''") + "\n";
    cases += "  " + command.name + ")\n    _arguments" + zsh_specifications(with_common(table_of(command))) +
             " \\\n      '*:file:_files'\n    ;;\n";
  }
  return "#compdef " + program.name + "\n" + function_name(program) + "() {\n" +
         "  local curcontext=$curcontext state line\n"
         "  local -a commands=(\n" +
         commands +
         "  )\n"
         "  _arguments -C" +
         zsh_specifications(with_common(own)) +
         " \\\n      '1:command:->command' '*::argument:->argument'\n"
         "  case $state in\n"
         "  command) _describe command commands; return ;;\n"
         "  argument) ;;\n"
         "  *) return ;;\n"
         "  esac\n"
         "  case $line[1] in\n" +
         cases + "  esac\n}\n" + function_name(program) + " \"$@\"\n";
}

std::string fish_completion(const Program& program) {
  std::vector<std::string> words;
  for (const Command& command : program.commands) {
    if (is_word(command)) words.push_back(command.name);
  }
  const std::string none = "'not __fish_seen_subcommand_from " + words_joined(words) + "'";
  const std::string start = "complete -c " + program.name;
  std::string text = "# fish completion for " + program.name + "\n";
  const auto add = [&](const std::string& condition, const Option& option) {
    const std::string name = option.long_name();
    text += start + condition + " -l " + name;
    if (name != option.name) text += " -s " + option.name.substr(name.size() + 1);
    if (takes_value(option)) text += takes_file(option) ? " -r -F" : " -x";
    if (option.kind == Option::Kind::folder) text += " -a '(__fish_complete_directories)'";
    if (const auto choices = choices_of(option); !choices.empty()) text += " -a '" + words_joined(choices) + "'";
    text += " -d " + shell_quoted(gist(option.meaning), "\\'") + "\n";
  };
  for (const Option& option : common_options()) add("", option);
  for (const Command& command : program.commands) {
    if (is_word(command)) {
      text += start + " -n " + none + " -f -a " + command.name + " -d " + shell_quoted(command.summary, "\\'") + "\n";
    }
    const std::string condition =
        is_word(command) ? " -n '__fish_seen_subcommand_from " + command.name + "'" : " -n " + none;
    for (const Option& option : table_of(command)) add(condition, option);
  }
  return text;
}

std::string documentation(const Program& program, const std::string& format) {
  if (format == "man") return manual_page(program);
  if (format == "bash") return bash_completion(program);
  if (format == "zsh") return zsh_completion(program);
  if (format == "fish") return fish_completion(program);
  throw UsageError("--documentation: '" + format + "' is not one of man, bash, zsh, fish");
}

}  // namespace requad::program
