// Drawings of all regions that theory/ lists, and of some that the search finds.
#include <optional>

#include "enumerate/generators.hpp"
#include "enumerate/search/search.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/enumerate/census.hpp"
#include "tests/support/mesh/drawings.hpp"

using namespace requad;
using requad::tests::check_drawing;

TEST_CASE("drawings of all regular regions up to side 12 (geometry-7)", "[drawing]") {
  int digons = 0, hexagons = 0;
  for (int length = 2; length <= 12; ++length) {
    for (const theory::PairType type : {theory::kDigon, theory::kHexagon}) {
      const auto sides = theory::IntegerVector::Constant(type.side_count(), length);
      std::vector<theory::Configuration> configurations = theory::merged_configurations({type, sides});
      const auto pairs = theory::parameter_set({type, sides});
      configurations.insert(configurations.end(), pairs.begin(), pairs.end());
      for (const theory::Configuration& c : configurations) {
        check_drawing(enumerate::glue_region(type, c), 0.6);
        ++(type == theory::kDigon ? digons : hexagons);
      }
    }
  }
  // Theorems 7.2 and 7.3: N (N - 1) or N^2 configurations, where N = floor(L / 2), and a merged vertex if L is even.
  CHECK(digons == 0 + 1 + 2 + 4 + 6 + 9 + 12 + 16 + 20 + 25 + 30 + 6);
  CHECK(hexagons == 3 * (0 + 1 + 2 + 4 + 6 + 9 + 12 + 16 + 20 + 25 + 30) + 6);
}

TEST_CASE("drawings of other regions", "[drawing]") {
  for (const tests::CensusEntry& entry : tests::census(18, true)) check_drawing(entry.region, 0.3);
  // A single vertex in a triangle, a pentagon and an octagon; three irregular vertices; a drop; a circle.
  const auto search_and_check = [](const enumerate::SearchProblem& problem, std::optional<int> faces, int at_least) {
    enumerate::SearchLimits limits;
    limits.threads = 1;
    limits.faces = faces;
    int count = 0;
    enumerate::search(problem, limits, [&](const enumerate::Filling& filling) {
      check_drawing(enumerate::region_of(filling), 0.05);
      ++count;
    });
    CHECK(count >= at_least);
  };
  search_and_check(enumerate::search_problem({4, 4, 4}, {3}), {}, 1);
  search_and_check(enumerate::search_problem({4, 4, 4, 4, 4}, {5}), {}, 1);
  search_and_check(enumerate::search_problem({3, 3, 3, 3, 3, 3, 3, 3}, {8}), {}, 4);
  search_and_check(enumerate::search_problem({4, 4, 4}, {3, 3, 5}), {}, 3);
  search_and_check(enumerate::search_problem({6}, {3, 3, 3}), {}, 1);
  search_and_check({{2, 2, 2, 2, 2, 2}, {3, 3, 3, 3}}, 14, 1);
}
