#include "mesh/program/options.hpp"

#include <algorithm>
#include <limits>
#include <locale>
#include <sstream>

#include <boost/program_options.hpp>

#include "mesh/program/outputs.hpp"

namespace requad::program {

namespace po = boost::program_options;

namespace {

constexpr const char* kWords = " words";  // the name that Boost's map has for words; no option can be called so

std::string number_text(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void require_known(const std::string& name, const std::string& word, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), word) == known.end())
    throw UsageError("--" + name + ": '" + word + "' is not one of " + joined(known));
}

void require_within(const std::string& name, std::int64_t value, std::int64_t low, std::int64_t high) {
  if (value >= low && value <= high) return;
  throw UsageError("--" + name + ": " + std::to_string(value) + " is not in " + std::to_string(low) + ".." +
                   std::to_string(high));
}

}  // namespace

const std::vector<Option>& common_options() {
  static const std::vector<Option> options{
      output("json", "FILE|-", "write the result as JSON, to a file or to standard output"),
      value("threads", "N", "use N threads (default: as many as there are cores)"),
      flag("quiet,q", "print no result as text and no progress"),
      flag("help,h", "print this help; after the name of a command, the help of that command"),
      flag("version", "print the version"),
  };
  return options;
}

Options::Options(int argc, char** argv, const std::vector<Option>& table) {
  po::options_description all;
  for (const std::vector<Option>* part : {&common_options(), &table}) {
    for (const Option& option : *part) {
      const char* const name = option.name.c_str();
      if (option.kind == Option::Kind::flag) {
        all.add_options()(name, "");
      } else if (option.kind == Option::Kind::list) {
        all.add_options()(name, po::value<std::vector<std::string>>(), "");
      } else {
        all.add_options()(name, po::value<std::string>(), "");
      }
    }
  }
  all.add_options()(kWords, po::value<std::vector<std::string>>(), "");
  po::positional_options_description positional;
  positional.add(kWords, -1);
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
  words_ = list(kWords);
  threads();  // a bad value is refused, whatever the command
  for (const Option& option : table) {
    if (option.kind == Option::Kind::output) outputs_.push_back(option.long_name());
  }
}

std::string Options::text(const std::string& name, const std::string& fallback) const {
  return has(name) ? map_[name].as<std::string>() : fallback;
}

std::vector<std::string> Options::list(const std::string& name) const {
  return has(name) ? map_[name].as<std::vector<std::string>>() : std::vector<std::string>{};
}

int Options::threads() const { return static_cast<int>(integer("threads", 0, 1, 1024)); }

std::string Options::required(const std::string& name, const std::string& expected) const {
  if (!has(name)) throw UsageError("--" + name + " is missing; expected " + expected);
  return text(name);
}

std::string Options::choice(const std::string& name, const std::vector<std::string>& known,
                            const std::string& fallback) const {
  if (!has(name)) return fallback;
  require_known(name, text(name), known);
  return text(name);
}

std::vector<std::string> Options::choices(const std::string& name, const std::vector<std::string>& known,
                                          const std::vector<std::string>& fallback) const {
  if (!has(name)) return fallback;
  std::vector<std::string> chosen;
  for (const std::string& word : list(name)) {
    require_known(name, word, known);
    if (std::find(chosen.begin(), chosen.end(), word) == chosen.end()) chosen.push_back(word);
  }
  return chosen;
}

std::int64_t Options::integer(const std::string& name, std::int64_t fallback, std::int64_t low,
                              std::int64_t high) const {
  if (!has(name)) return fallback;
  const std::int64_t value = parse_integer(text(name), "--" + name);
  require_within(name, value, low, high);
  return value;
}

std::vector<std::int64_t> Options::integers(const std::string& name, std::int64_t low, std::int64_t high) const {
  std::vector<std::int64_t> values = parse_integers(text(name), "--" + name);
  for (const std::int64_t value : values) require_within(name, value, low, high);
  return values;
}

double Options::number(const std::string& name, double fallback, double low, double high) const {
  if (!has(name)) return fallback;
  const double value = parse_number(text(name), "--" + name);
  if (value < low || value > high) {
    const bool bounded = high < std::numeric_limits<double>::max();
    throw UsageError("--" + name + ": " + text(name) + " is not " +
                     (bounded ? "in " + number_text(low) + ".." + number_text(high) : number_text(low) + " or more"));
  }
  return value;
}

Range Options::range(const std::string& name, Range fallback, std::int64_t low, std::int64_t high) const {
  if (!has(name)) return fallback;
  const Range range = parse_range(text(name), "--" + name);
  if (range.first < low || range.last > high) {
    throw UsageError("--" + name + ": " + text(name) + " is not within " + std::to_string(low) + ".." +
                     std::to_string(high));
  }
  return range;
}

void Options::allow_only(const std::string& what, const std::set<std::string>& names) const {
  for (const auto& [name, value] : map_) {
    const auto is_this = [&name = name](const Option& option) { return option.long_name() == name; };
    const std::vector<Option>& common = common_options();
    if (name == kWords || names.count(name) > 0 || std::any_of(common.begin(), common.end(), is_this)) continue;
    throw UsageError((what.empty() ? "there is no use for --" : what + ": has no use for --") + name + "; see --help");
  }
}

void Options::require_outputs() const {
  std::set<std::string> used;
  for (const std::string& name : outputs_) {
    if (!has(name)) continue;
    const std::string file = require_writable(text(name));
    if (!file.empty() && !used.insert(file).second)
      throw UsageError("two outputs cannot both go to " + (file == "-" ? "standard output" : text(name)));
  }
}

}  // namespace requad::program
