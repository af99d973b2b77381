#include "tests/support/enumerate/census.hpp"

#include <functional>

#include "enumerate/generators.hpp"

namespace requad::tests {

namespace {

using theory::Integer;
using Sides = std::vector<Integer>;

bool is_least_rotation(const Sides& sides) {
  Sides rotated = sides;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
    if (rotated < sides) return false;
  }
  return true;
}

// All sequences of k positive integers with this sum, each only as the least of its rotations.
void for_each_sides(int k, Integer perimeter, const std::function<void(const Sides&)>& visit, const Sides& first = {}) {
  const int rest = k - static_cast<int>(first.size());
  if (rest == 0) {
    if (perimeter == 0 && is_least_rotation(first)) visit(first);
    return;
  }
  for (Integer next = first.empty() ? 1 : first.front(); next <= perimeter - (rest - 1); ++next) {
    Sides more = first;
    more.push_back(next);
    for_each_sides(k, perimeter - next, visit, more);
  }
}

}  // namespace

std::vector<CensusEntry> census(int perimeter, bool with_merged) {
  std::vector<CensusEntry> entries;
  for (const theory::PairType type : {theory::kDigon, theory::kHexagon, theory::kQuad}) {
    for (Integer sum = 4; sum <= perimeter; sum += 2) {
      for_each_sides(type.side_count(), sum, [&](const Sides& list) {
        const theory::RegionShape shape{type, theory::to_vector(list)};
        auto configurations = theory::parameter_set(shape);
        if (with_merged) {
          for (auto& merged : theory::merged_configurations(shape)) configurations.push_back(std::move(merged));
        }
        for (const auto& configuration : configurations) {
          entries.push_back({shape, configuration, enumerate::glue_region(type, configuration)});
        }
      });
    }
  }
  return entries;
}

}  // namespace requad::tests
