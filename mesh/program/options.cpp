#include "mesh/program/options.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

#include <boost/program_options.hpp>

#include "mesh/program/run/outputs.hpp"
#include "mesh/program/suggestion.hpp"

namespace requad::program {

namespace po = boost::program_options;

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool has_extension(const Format& format, const std::string& extension) {
  return std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end();
}

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
    throw UsageError("--" + name + ": '" + word + "' is not one of " + joined(known) + did_you_mean(word, known));
}

void require_within(const std::string& name, std::int64_t value, std::int64_t low, std::int64_t high) {
  if (value >= low && value <= high) return;
  throw UsageError("--" + name + ": " + std::to_string(value) + " is not in " + std::to_string(low) + ".." +
                   std::to_string(high));
}

// ".dot, .gv or .json": how the names of files of these formats end, each once.
std::string endings(const std::vector<Format>& formats) {
  std::vector<std::string> all;
  for (const Format& format : formats) {
    for (const std::string& extension : format.extensions) {
      if (std::find(all.begin(), all.end(), "." + extension) == all.end()) all.push_back("." + extension);
    }
  }
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) text += (i == 0 ? "" : i + 1 < all.size() ? ", " : " or ") + all[i];
  return text;
}

// A message of Boost's about a bad command line, with a suggestion for an option that is not known.
std::string explained(const po::error& error, const std::vector<std::string>& names) {
  const auto* const unknown = dynamic_cast<const po::unknown_option*>(&error);
  if (unknown == nullptr) return std::string(error.what()) + "; see --help";
  const std::string given = unknown->get_option_name();
  const std::string near = suggestion(given.substr(std::min(given.find_first_not_of('-'), given.size())), names);
  return error.what() + (near.empty() ? "; see --help" : "; did you mean --" + near + "?");
}

}  // namespace

Option only_if(Option option, std::function<std::string(const Options&)> no_effect) {
  option.no_effect = [before = std::move(option.no_effect), now = std::move(no_effect)](const Options& options) {
    const std::string why = before ? before(options) : "";
    return why.empty() ? now(options) : why;
  };
  return option;
}

Option only_with(Option option, std::vector<std::string> others) {
  const std::string name = option.long_name();
  return only_if(std::move(option), [name, others = std::move(others)](const Options& options) -> std::string {
    std::string missing;
    for (const std::string& other : others) {
      if (options.has(other)) return "";
      missing += (missing.empty() ? "" : " or ") + ("--" + other);
    }
    return "--" + name + " has no effect without " + missing;
  });
}

Option not_with(Option option, std::vector<std::string> others) {
  const std::string name = option.long_name();
  return only_if(std::move(option), [name, others = std::move(others)](const Options& options) -> std::string {
    for (const std::string& other : others) {
      if (options.has(other)) return "--" + name + " has no effect beside --" + other;
    }
    return "";
  });
}

const std::vector<Option>& common_options() {
  static const std::vector<Option> options{
      output("json", "FILE|-", "write the result as JSON, to a file or to standard output", {{"json", {"json"}}}),
      value("threads", "N", "use N threads (default: as many as there are cores)"),
      flag("quiet,q", "print no result as text and no progress"),
      flag("force", "let an output replace a file that is read"),
      flag("help,h", "print this help; after the name of a command, the help of that command"),
      flag("version", "print the version"),
  };
  return options;
}

Options::Options(int argc, char** argv, const std::vector<Option>& table) : table_(table) {
  po::options_description all;
  std::vector<std::string> names;
  for (const std::vector<Option>* part : {&common_options(), &table}) {
    for (const Option& option : *part) {
      names.push_back(option.long_name());
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
    throw UsageError(explained(error, names));
  }
  words_ = list(kWords);
  threads();  // a bad value is refused, whatever the command
}

void Options::for_each_given(const std::function<void(const Option&)>& visit) const {
  for (const std::vector<Option>* part : {&common_options(), &table_}) {
    for (const Option& option : *part) {
      if (has(option.long_name())) visit(option);
    }
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

// Precondition: there is such an option.
const Option& Options::entry(const std::string& name) const {
  for (const std::vector<Option>* part : {&common_options(), &table_}) {
    for (const Option& option : *part) {
      if (option.long_name() == name) return option;
    }
  }
  throw std::logic_error("no option is called --" + name);
}

const Format& Options::format(const std::string& output) const {
  // A command whose only output has several formats has --format, too.
  const bool has_choice = output == "output" && has("format") && entry("format").kind == Option::Kind::value;
  return format(output, has_choice ? text("format") : "");
}

const Format& Options::format(const std::string& output, const std::string& asked) const {
  const std::vector<Format>& formats = entry(output).formats;
  const std::string extension = extension_of(text(output));
  const auto fits = [&extension](const Format& format) {
    return extension.empty() || has_extension(format, extension);
  };
  const auto by_end = std::find_if(formats.begin(), formats.end(), fits);
  if (by_end == formats.end()) {
    throw UsageError(text(output) + ": there is no way to write '." + extension +
                     "' here; expected a name that ends in " + endings(formats));
  }
  if (asked.empty()) return *by_end;
  std::vector<std::string> names;
  for (const Format& format : formats) names.push_back(format.name);
  require_known("format", asked, names);
  const Format& chosen =
      *std::find_if(formats.begin(), formats.end(), [&](const Format& format) { return format.name == asked; });
  if (!fits(chosen))
    throw UsageError(text(output) + ": --format " + asked + " asks for a name that ends in " + endings({chosen}));
  return chosen;
}

void Options::require_effects(const std::string& what) const {
  for_each_given([&](const Option& option) {
    const std::string why = option.no_effect ? option.no_effect(*this) : "";
    if (!why.empty()) throw UsageError((what.empty() ? "" : what + ": ") + why + "; see --help");
    if (option.kind != Option::Kind::output || option.formats.empty()) return;
    format(option.long_name());
  });
}

void Options::set_files(const std::vector<std::size_t>& words) {
  std::vector<std::string> all;
  for (const std::size_t word : words) {
    if (word < words_.size()) all.push_back(words_[word]);
  }
  for_each_given([&](const Option& option) {
    if (option.kind != Option::Kind::input && option.kind != Option::Kind::journal) return;
    const std::string name = option.long_name();
    if (option.kind == Option::Kind::journal && text(name) == "-")
      throw UsageError("--" + name + ": a file is expected, for it is read and written again; not '-'");
    all.push_back(text(name));
  });
  if (std::count(all.begin(), all.end(), "-") > 1) throw UsageError("two files to read cannot both be standard input");
  files_.clear();
  std::copy_if(all.begin(), all.end(), std::back_inserter(files_), [](const std::string& file) { return file != "-"; });
}

void Options::require_outputs() const {
  std::set<std::string> used;
  for_each_given([&](const Option& option) {
    if (option.kind != Option::Kind::output) return;
    const std::string path = text(option.long_name());
    const std::string file = require_writable(path);
    if (!file.empty() && !used.insert(file).second)
      throw UsageError("two outputs cannot both go to " + (file == "-" ? "standard output" : path));
    if (has("force")) return;
    for (const std::string& input : files_) {
      if (is_same_file(path, input))
        throw UsageError(path + ": it is read, and would be replaced; expected another name, or --force");
    }
  });
}

}  // namespace requad::program
