// Command lines: the options and the numbers in them. The input holds the arguments as /proc/PID/cmdline does, each
// with a zero byte after it.
//
// No command runs, since that would take files and time. This target tests what decides whether arguments are right:
// the parser of options, numbers, lists and ranges, and the conditions on sides, strips and searches.
#include "enumerate/search/search.hpp"
#include "mesh/program/options.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "theory/counts.hpp"
#include "theory/joined.hpp"

using namespace requad;
using program::Options;

// The text of a boundary may be short, although the boundary has ten thousand vertices.
const fuzz::Memory fuzz::kMemory{256 << 10, 400};

namespace {

// Whether a condition is met. It returns "", or a message of one line.
bool fulfils(const std::string& problem) {
  if (!problem.empty()) fuzz::require_one_line(problem);
  return problem.empty();
}

std::vector<std::int64_t> numbers(const Options& options, const char* name) {
  const auto values = program::parse_integers(options.text(name), name);
  fuzz::require(program::parse_integers(theory::joined(values, ","), name) == values,
                "what was written reads differently");
  return values;
}

// Reads integers like `requad-enumerate search`.
std::vector<int> ints(const Options& options, const char* name) {
  const auto values = options.integers(name, 0, 100'000);
  fuzz::require(values == numbers(options, name), "an option is read in two ways");
  return {values.begin(), values.end()};
}

void try_sides(const Options& options, theory::PairType type) {
  const theory::IntegerVector sides = theory::to_vector(numbers(options, "sides"));
  if (!fulfils(theory::RegionShape::problem(type, sides))) return;
  const bool quick = type != theory::kHexagon || sides.maxCoeff() < 100;
  fuzz::require(!quick || theory::exact_count({type, sides}) >= 0, "a negative count");
}

void try_strips(const Options& options, theory::PairType type) {
  const auto& words = options.words();
  if (words.size() != 3) return;
  theory::Configuration c;
  c.parameters = {program::parse_integer(words[0], "D1"), program::parse_integer(words[1], "D2"),
                  theory::to_vector(program::parse_integers(words[2], "strips"))};
  if (!fulfils(theory::parameters_problem(type, c.parameters))) return;
  fuzz::require(theory::region_sides(type, c).minCoeff() > 0, "a side without length");
}

void try_search(const Options& options) {
  std::vector<int> irregular;
  if (!options.text("irregular").empty()) irregular = ints(options, "irregular");
  const auto problem = enumerate::search_problem(ints(options, "sides"), std::move(irregular));
  if (fulfils(enumerate::problem_with(problem))) enumerate::may_be_infinite(problem);
}

}  // namespace

void fuzz::try_input(std::string_view text) {
  std::vector<std::string> arguments{"program"};
  for (; !text.empty(); text.remove_prefix(std::min(text.size(), arguments.back().size() + 1)))
    arguments.emplace_back(text.substr(0, text.find('\0')));
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  accepts([&] {
    const std::vector<program::Option> table{
        program::flag("list", ""),       program::flag("undo", ""),           program::output("output,o", "", ""),
        program::value("sides", "", ""), program::value("irregular", "", ""), program::value("digon", "", ""),
        program::value("limit", "", ""), program::value("angle", "", ""),     program::list("claim", "", ""),
    };
    const Options options(static_cast<int>(arguments.size()), pointers.data(), table);
    // If one of these refuses its argument, the others are tried nevertheless.
    accepts([&] { options.allow_only("command", {"output", "sides", "digon", "limit"}); });
    accepts([&] { options.require_outputs(); });
    accepts([&] { options.choices("claim", {"T2", "T3"}, {}); });
    accepts([&] { options.integer("limit", 0, -5, 1000); });
    accepts([&] {
      const double angle = options.number("angle", 0, 0, 180);
      require(angle >= 0 && angle <= 180, "a number out of range");
    });
    accepts([&] {
      const program::Range range = options.range("digon", {3, 24}, 3, 100);
      require(3 <= range.first && range.first <= range.last && range.last <= 100, "a range out of bounds");
    });
    for (const theory::PairType type : {theory::kDigon, theory::kHexagon, theory::kQuad}) {
      accepts([&] { try_sides(options, type); });
      accepts([&] { try_strips(options, type); });
    }
    accepts([&] { try_search(options); });
  });
}
