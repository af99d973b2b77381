// requad-enumerate tau: a table of the counts of Theorems 7.2 and 7.3.

#include "enumerate/commands/arguments.hpp"
#include "enumerate/commands/commands.hpp"
#include "theory/counts.hpp"

namespace requad::enumerate {

namespace {

int tau(const program::Options& options) {
  const program::Range lengths = options.range("side", {1, 24}, 1, theory::kMaxLength);
  constexpr std::int64_t kMostRows = 100'000;
  if (lengths.last - lengths.first >= kMostRows)
    throw program::UsageError("--side: more than " + std::to_string(kMostRows) + " lengths");
  std::string csv = "side,3-3,5-5\n", text = "side       3-3 in a digon    5-5 in a hexagon\n";
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  const auto right = [](const std::string& number, std::size_t width) {
    return std::string(width - std::min(width, number.size()), ' ') + number;
  };
  for (std::int64_t side = lengths.first; side <= lengths.last; ++side) {
    const theory::Integer digon = theory::tau_digon(side), hexagon = theory::tau_hexagon(side);
    csv += std::to_string(side) + "," + std::to_string(digon) + "," + std::to_string(hexagon) + "\n";
    text +=
        right(std::to_string(side), 4) + right(std::to_string(digon), 21) + right(std::to_string(hexagon), 20) + "\n";
    rows.push_back({{"side", side}, {"3-3", digon}, {"5-5", hexagon}});
  }
  program::Outputs outputs;
  if (options.has("output")) outputs.add(options.text("output"), csv);
  program::finish(options, nlohmann::ordered_json{{"tau", rows}}.dump(), text, std::move(outputs));
  return program::kDone;
}

}  // namespace

program::Command tau_command() {
  return {
      .name = "tau",
      .usage = {"[--side A..B]"},
      .summary = "prints tau(L), the number of configurations of a regular digon or hexagon of side L",
      .text = "The columns are Theorem 7.2 and Theorem 7.3, three times the first.\n",
      .examples = {"requad-enumerate tau --side 1..40", "requad-enumerate tau -o tau.csv"},
      .options = {program::value("side", "A..B", "the side lengths (default 1..24)"),
                  program::output("output,o", "FILE", "write the table as CSV, or - for standard output",
                                  {{"csv", {"csv"}}})},
      .run = tau,
  };
}

}  // namespace requad::enumerate
