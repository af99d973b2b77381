#include "mesh/program/options.hpp"

#include <algorithm>
#include <iostream>
#include <limits>
#include <locale>
#include <set>
#include <sstream>

#include <boost/program_options.hpp>

namespace requad::program {

namespace po = boost::program_options;

namespace {

constexpr std::initializer_list<const char*> kCommon{"help", "version", "quiet", "json", "threads"};

std::string shown(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

}  // namespace

Options::Options(int argc, char** argv, const OptionTable& table) {
  po::options_description all;
  const auto value = [&all](const std::string& name) { all.add_options()(name.c_str(), po::value<std::string>(), ""); };
  for (const char* flag : {"help,h", "version", "quiet,q"}) all.add_options()(flag, "");
  for (const std::string& flag : table.flags) all.add_options()(flag.c_str(), "");
  value("json"), value("threads");
  for (const std::string& name : table.values) value(name);
  for (const std::string& name : table.outputs) value(name);
  for (const std::string& name : table.lists)
    all.add_options()(name.c_str(), po::value<std::vector<std::string>>(), "");
  all.add_options()(" words", po::value<std::vector<std::string>>(), "");
  po::positional_options_description positional;
  positional.add(" words", -1);
  try {
    using Style = po::command_line_style::style_t;
    po::store(po::command_line_parser(argc, argv)
                  .options(all)
                  .positional(positional)
                  .style(Style::unix_style & ~Style::allow_guessing)
                  .run(),
              map_);
  } catch (const po::error& error) {
    throw UsageError(std::string(error.what()) + "; see --help");
  }
  words_ = list(" words");
  threads();  // so that a bad one is refused whatever the command
  for (const std::string& name : table.outputs) outputs_.push_back(name.substr(0, name.find(',')));
}

std::string Options::text(const std::string& name, const std::string& fallback) const {
  return has(name) ? map_[name].as<std::string>() : fallback;
}

std::vector<std::string> Options::list(const std::string& name) const {
  return has(name) ? map_[name].as<std::vector<std::string>>() : std::vector<std::string>{};
}

int Options::threads() const { return static_cast<int>(integer("threads", 0, 1, 1024)); }

std::int64_t Options::integer(const std::string& name, std::int64_t fallback, std::int64_t low,
                              std::int64_t high) const {
  if (!has(name)) return fallback;
  const std::int64_t value = parse_integer(text(name), "--" + name);
  if (value < low || value > high) {
    throw UsageError("--" + name + ": " + std::to_string(value) + " is not in " + std::to_string(low) + ".." +
                     std::to_string(high));
  }
  return value;
}

double Options::number(const std::string& name, double fallback, double low, double high) const {
  if (!has(name)) return fallback;
  const double value = parse_number(text(name), "--" + name);
  if (value < low || value > high) {
    const bool bounded = high < std::numeric_limits<double>::max();
    throw UsageError("--" + name + ": " + text(name) + " is not " +
                     (bounded ? "in " + shown(low) + ".." + shown(high) : shown(low) + " or more"));
  }
  return value;
}

void Options::allow_only(const std::string& command, std::initializer_list<const char*> names) const {
  for (const auto& [name, value] : map_) {
    const auto is = [&name = name](const char* other) { return name == other; };
    if (name == " words" || std::any_of(kCommon.begin(), kCommon.end(), is) ||
        std::any_of(names.begin(), names.end(), is))
      continue;
    throw UsageError(command + ": has no use for --" + name + "; see --help");
  }
}

void Options::require_outputs(const std::vector<std::string>& names) const {
  std::set<std::string> places;
  for (const std::string& name : names) {
    if (!has(name)) continue;
    const std::string place = require_writable(text(name));
    if (!place.empty() && !places.insert(place).second)
      throw UsageError("two outputs can not both go to " + (place == "-" ? "standard output" : text(name)));
  }
}

void finish(const Options& options, const std::string& json, const std::string& text, Outputs outputs) {
  if (options.has("json")) outputs.add(options.text("json"), json + "\n");
  outputs.commit();
  if (!options.on_stdout("json") && !options.on_stdout("output") && !options.quiet()) std::cout << text;
}

bool answered(const Options& options, const char* name, const char* version, const char* help) {
  if (options.has("help")) {
    std::cout << help;
  } else if (options.has("version")) {
    std::cout << name << ' ' << version << '\n';
  } else {
    return false;
  }
  return true;
}

}  // namespace requad::program
