// Command lines of the programs: options by name, the common ones once, one-line errors.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include <boost/program_options/variables_map.hpp>

#include "mesh/program/program.hpp"

namespace requad::program {

// What a program's command line may hold. Names are as for Boost.Program_options ("output,o"). Every program has
// --help, --version, --quiet, --json and --threads besides.
struct OptionTable {
  std::vector<std::string> flags = {};
  std::vector<std::string> values = {};   // take a value, given once
  std::vector<std::string> lists = {};    // take a value, may be repeated
  std::vector<std::string> outputs = {};  // take the name of a file to write, or "-" for standard output; --json is one
};

class Options {
 public:
  // Throws UsageError for anything the table does not know; abbreviations are not guessed.
  Options(int argc, char** argv, const OptionTable& table);

  bool has(const std::string& name) const { return map_.count(name) != 0; }
  std::string text(const std::string& name, const std::string& fallback = "") const;
  std::vector<std::string> list(const std::string& name) const;
  const std::vector<std::string>& words() const { return words_; }
  bool quiet() const { return has("quiet"); }
  // 0 if --threads is not given: all cores.
  int threads() const;
  // The value as an integer in low..high, or the fallback. The error names the option and the range.
  std::int64_t integer(const std::string& name, std::int64_t fallback, std::int64_t low, std::int64_t high) const;
  double number(const std::string& name, double fallback, double low, double high) const;

  // Throws UsageError if an option other than these and the common ones is given: `command` has no use for it.
  void allow_only(const std::string& command, std::initializer_list<const char*> names) const;
  // Before any work: throws UsageError if an output can not be written, or two of them would be one file or both go to
  // standard output.
  void require_outputs() const { require_outputs(outputs_); }
  // These only.
  void require_outputs(const std::vector<std::string>& names) const;
  bool on_stdout(const std::string& name) const { return text(name) == "-"; }

 private:
  boost::program_options::variables_map map_;
  std::vector<std::string> words_;
  std::vector<std::string> outputs_{"json"};
};

// How a command ends: its outputs, with the JSON where --json asks for it, are committed; then the text, on standard output
// unless that is taken or --quiet.
void finish(const Options& options, const std::string& json, const std::string& text, Outputs outputs = {});

// Prints the help or the version if asked for; true if that was all there was to do.
bool answered(const Options& options, const char* name, const char* version, const char* help);

}  // namespace requad::program
