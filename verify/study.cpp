#include "verify/study.hpp"

#include <algorithm>

#include "enumerate/generators.hpp"

namespace requad::verify {

const char* name(Family family) {
  switch (family) {
    case Family::regular_digon: return "regular digons";
    case Family::regular_hexagon: return "regular hexagons";
    case Family::quad: return "3-5 regions";
    case Family::other_digon: return "non-regular digons";
    case Family::other_hexagon: return "non-regular hexagons";
  }
  return "";
}

std::string describe(const RegionCase& region) {
  std::string text = region.type.name() + " region with sides";
  for (const auto side : region.sides) text += " " + std::to_string(side);
  return text;
}

int Study::pairs_predicted() const {
  return static_cast<int>(std::count_if(map.nodes.begin(), map.nodes.end(),
                                        [](const theory::MapNode& node) { return !node.configuration.merged(); }));
}

int Study::pairs_found() const {
  int count = 0;
  for (std::size_t i = 0; i < found.nodes.size(); ++i) count += found.holds_pair(static_cast<int>(i)) ? 1 : 0;
  return count;
}

Study study(const RegionCase& region) {
  Study s{region, theory::exact_count(region.type, region.sides),
          theory::configuration_map(region.type, region.sides, theory::Apex::with), {region.type, {}, {}}, {}};
  // The pair's first configuration; where there is none there is nothing to explore.
  const auto start = std::find_if(s.map.nodes.begin(), s.map.nodes.end(),
                                  [](const theory::MapNode& node) { return !node.configuration.merged(); });
  if (start == s.map.nodes.end()) return s;
  s.found = enumerate::explore(region.type, {enumerate::glue_region(region.type, start->configuration)});
  for (const auto& node : s.found.nodes) {
    s.predicted_of.push_back(node.reading.problem.empty() ? s.map.find(node.reading.configuration) : -1);
  }
  return s;
}

}  // namespace requad::verify
