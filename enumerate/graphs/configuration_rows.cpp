#include "enumerate/graphs/configuration_rows.hpp"

#include <algorithm>

#include <boost/algorithm/string/join.hpp>

namespace requad::enumerate {

void ConfigurationRows::add(const theory::Configuration& c, int faces, const std::string& signature) {
  rows_.push_back({c, faces, signature});
}

std::vector<std::string> ConfigurationRows::heading() const {
  std::vector<std::string> names{"d1", "d2", "p", "m", "n"};
  for (int i = 1; i <= type_.side_count(); ++i) names.push_back("e" + std::to_string(i));
  names.emplace_back("faces");
  return names;
}

std::vector<std::string> ConfigurationRows::numbers(const Row& row) const {
  const theory::Configuration& c = row.configuration;
  const theory::GridPoint at = theory::grid_point(type_, c);
  std::vector<std::string> numbers;
  for (const theory::Integer x : {c.d1(), c.d2(), theory::Integer{c.p}, at.m, at.n})
    numbers.push_back(std::to_string(x));
  for (const theory::Integer strips : c.parameters.e) numbers.push_back(std::to_string(strips));
  numbers.push_back(std::to_string(row.faces));
  return numbers;
}

std::string ConfigurationRows::csv() const {
  std::string text = boost::algorithm::join(heading(), ",") + ",signature\n";
  for (const Row& row : rows_) text += boost::algorithm::join(numbers(row), ",") + "," + row.signature + "\n";
  return text;
}

nlohmann::ordered_json ConfigurationRows::json() const {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows_) {
    const theory::Configuration& c = row.configuration;
    const theory::GridPoint at = theory::grid_point(type_, c);
    list.push_back({{"d1", c.d1()},
                    {"d2", c.d2()},
                    {"p", c.p},
                    {"m", at.m},
                    {"n", at.n},
                    {"e", std::vector<theory::Integer>(c.parameters.e.begin(), c.parameters.e.end())},
                    {"faces", row.faces},
                    {"label", theory::label(type_, c)},
                    {"signature", row.signature}});
  }
  return list;
}

std::string ConfigurationRows::text() const {
  std::vector<std::vector<std::string>> lines{heading()};
  for (const Row& row : rows_) lines.push_back(numbers(row));
  std::string text;
  for (const std::vector<std::string>& line : lines) {
    std::string joined;
    for (std::size_t i = 0; i < line.size(); ++i) {
      std::size_t width = 0;
      for (const auto& other : lines) width = std::max(width, other[i].size());
      joined += (i == 0 ? "" : "  ") + std::string(width - line[i].size(), ' ') + line[i];
    }
    text += joined + "\n";
  }
  return text;
}

}  // namespace requad::enumerate
