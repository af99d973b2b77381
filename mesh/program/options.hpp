// The options of a command line: tables that describe them, and the values that were given.
//
// A table is a list of Option. It decides what a command line may hold: which files are read and written and in which
// formats, and which options have an effect beside which. Help texts, manual pages and completions are made from it too
// (program.hpp). Every command has the common options --help, --version, --quiet, --json, --threads and --force besides.
#pragma once

#include <functional>
#include <initializer_list>
#include <set>
#include <string>
#include <vector>

#include <boost/program_options/variables_map.hpp>

#include "mesh/program/run/errors.hpp"
#include "mesh/program/run/numbers.hpp"

namespace requad::program {

class Options;

// A format of files: its name, and how the names of such files end, without the dot.
struct Format {
  std::string name;
  std::vector<std::string> extensions;
};
// "dot" of "graphs/g.DOT"; "" where the name has no such end.
std::string extension_of(const std::string& path);
bool has_extension(const Format& format, const std::string& extension);

struct Option {
  enum class Kind {
    flag,     // takes no value
    value,    // takes a value, may be given once
    list,     // takes a value, may be repeated
    input,    // takes the name of a file to read, or "-" for standard input
    output,   // takes the name of a file to write, or "-" for standard output
    journal,  // takes the name of a file to read and go on writing
    folder,   // takes the name of a folder
  };
  Kind kind;
  std::string name;      // without dashes; "output,o" can also be written -o
  std::string argument;  // what stands for the value in help texts, as FILE; "" for a flag
  std::string meaning;   // for help texts, which break it into lines; a line of its own stays one
  // Of an output: its formats, the usual one first; none if any name will do. See Options::format().
  std::vector<Format> formats = {};
  // Why the option has no effect beside the others that are given; "" if it has one. An option without effect is
  // refused. Not called for options that are not given.
  std::function<std::string(const Options&)> no_effect = {};

  std::string long_name() const { return name.substr(0, name.find(',')); }
};

// The entries of a table. See Option::Kind.
inline Option flag(std::string name, std::string meaning) {
  return {Option::Kind::flag, std::move(name), "", std::move(meaning)};
}
inline Option value(std::string name, std::string argument, std::string meaning) {
  return {Option::Kind::value, std::move(name), std::move(argument), std::move(meaning)};
}
inline Option list(std::string name, std::string argument, std::string meaning) {
  return {Option::Kind::list, std::move(name), std::move(argument), std::move(meaning)};
}
inline Option input(std::string name, std::string argument, std::string meaning) {
  return {Option::Kind::input, std::move(name), std::move(argument), std::move(meaning)};
}
inline Option output(std::string name, std::string argument, std::string meaning, std::vector<Format> formats = {}) {
  return {Option::Kind::output, std::move(name), std::move(argument), std::move(meaning), std::move(formats)};
}
inline Option journal(std::string meaning) { return {Option::Kind::journal, "journal", "FILE", std::move(meaning)}; }
inline Option folder(std::string name, std::string argument, std::string meaning) {
  return {Option::Kind::folder, std::move(name), std::move(argument), std::move(meaning)};
}

// The option, with a condition for its effect (Option::no_effect). The others are long names.
Option only_with(Option option, std::vector<std::string> others);  // beside one of these
Option not_with(Option option, std::vector<std::string> others);   // beside none of these
Option only_if(Option option, std::function<std::string(const Options&)> no_effect);

const std::vector<Option>& common_options();

// What a command line holds. Names of options are long names, without dashes.
class Options {
 public:
  // Throws UsageError for an option that is neither in the table nor a common one, for a value that is missing, and for
  // a bad --threads. Abbreviations are not accepted.
  Options(int argc, char** argv, const std::vector<Option>& table);

  bool has(const std::string& name) const { return map_.count(name) != 0; }
  // The value of an option, or the fallback.
  std::string text(const std::string& name, const std::string& fallback = "") const;
  // The values of an option that may be repeated.
  std::vector<std::string> list(const std::string& name) const;
  // The arguments that are no options and no values of options.
  const std::vector<std::string>& words() const { return words_; }
  bool quiet() const { return has("quiet"); }
  // 0 if --threads is not given: all cores.
  int threads() const;
  bool on_stdout(const std::string& name) const { return text(name) == "-"; }

  // Values that are checked. Each throws a UsageError that names the option and what was expected.

  // The value of an option that must be given.
  std::string required(const std::string& name, const std::string& expected) const;
  // One of the known words, or the fallback.
  std::string choice(const std::string& name, const std::vector<std::string>& known, const std::string& fallback) const;
  // The values of an option that may be repeated, each once; all must be known. If it is not given: the fallback.
  std::vector<std::string> choices(const std::string& name, const std::vector<std::string>& known,
                                   const std::vector<std::string>& fallback) const;
  // An integer in low..high, or the fallback.
  std::int64_t integer(const std::string& name, std::int64_t fallback, std::int64_t low, std::int64_t high) const;
  // Integers in low..high with commas between them. The option must be given.
  std::vector<std::int64_t> integers(const std::string& name, std::int64_t low, std::int64_t high) const;
  // A number in low..high, or the fallback.
  double number(const std::string& name, double fallback, double low, double high) const;
  // A range within low..high, or the fallback.
  Range range(const std::string& name, Range fallback, std::int64_t low, std::int64_t high) const;

  // The format in which the output is to be written. The end of the file's name decides; where it has none, as in "-",
  // --format does if the command has it, and else the first of the output's formats is taken.
  const Format& format(const std::string& output = "output") const;
  // The same for a format that was asked for by its name, "" if none was.
  const Format& format(const std::string& output, const std::string& asked) const;

  // Throws UsageError if an option is given that is neither a common one nor one of these. `what` names the command
  // that has no use for it; it may be "".
  void allow_only(const std::string& what, const std::set<std::string>& names) const;
  // Throws UsageError if an option is given that has no effect beside the others, or if an output has a format that is
  // not one of its own. `what` as above.
  void require_effects(const std::string& what) const;
  // Says that the words with these indices name files to read, as options of the kind `input` do. Throws UsageError if
  // two files to read are standard input.
  void set_files(const std::vector<std::size_t>& words);
  // To be called before any work. Throws UsageError if an output cannot be written, if two of them go to one file or
  // both to standard output, or if one would replace a file that is read and --force is not given. Outputs are --json
  // and those of the table.
  void require_outputs() const;

  // Takes the first word away: it named the command.
  void drop_first_word() { words_.erase(words_.begin()); }

 private:
  const Option& entry(const std::string& name) const;
  // Calls visit for each option of the table that is given, and for the common ones.
  void for_each_given(const std::function<void(const Option&)>& visit) const;

  boost::program_options::variables_map map_;
  std::vector<Option> table_;
  std::vector<std::string> words_;
  std::vector<std::string> files_;  // to be read, without standard input
};

}  // namespace requad::program
