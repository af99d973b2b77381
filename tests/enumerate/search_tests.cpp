// Exhaustive search: it finds each filling exactly once. It is compared with theory/, with brute force, and with
// published counts.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>

#include "enumerate/search/search.hpp"
#include "enumerate/search/spheres.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/theory/integer_vector.hpp"
#include "theory/configurations.hpp"

using namespace requad;
using namespace requad::enumerate;

namespace {

std::int64_t count(const std::vector<int>& sides, const std::vector<int>& irregular) {
  const CountedSearch found = count_fillings(search_problem(sides, irregular), {}, true);
  REQUIRE(found.outcome.complete());
  // Each filling is found precisely once.
  CHECK(std::adjacent_find(found.signatures.begin(), found.signatures.end()) == found.signatures.end());
  CHECK(static_cast<std::int64_t>(found.signatures.size()) == found.outcome.count);
  return found.outcome.count;
}

}  // namespace

TEST_CASE("every filling has the boundary and the valences of the problem", "[search]") {
  std::mutex mutex;
  for (const auto& [sides, irregular] :
       std::vector<std::pair<std::vector<int>, std::vector<int>>>{{{6, 6, 6}, {3, 3, 5}},
                                                                  {{5, 5}, {3, 3}},
                                                                  {{4, 4, 4, 4}, {3, 3, 5, 5}},
                                                                  {{4, 4, 4, 4, 4}, {5}},
                                                                  {{3, 4, 5}, {3}},
                                                                  {{5, 5, 5, 5}, {2, 6}},
                                                                  {{6, 4}, {2}},
                                                                  {{3, 3, 3, 3, 3, 3, 3}, {5, 5, 5}}}) {
    const SearchProblem problem = search_problem(sides, irregular);
    search(problem, {}, [&, &sides = sides, &irregular = irregular](const Filling& filling) {
      const mesh::Region region = region_of(filling);
      const std::scoped_lock lock(mutex);
      REQUIRE(mesh::validate(region.mesh).empty());
      REQUIRE(mesh::region_problem(region).empty());
      REQUIRE(mesh::side_lengths(region) == sides);
      std::multiset<int> valences;
      for (const mesh::VertexId v : region.mesh.vertices()) {
        if (!region.mesh.is_boundary(v) && region.mesh.valence(v) != 4) valences.insert(region.mesh.valence(v));
      }
      REQUIRE(valences == std::multiset<int>(irregular.begin(), irregular.end()));
    });
  }
}

TEST_CASE("counts of the theorems and of Theorem 7.1's sharpness", "[search]") {
  CHECK(count({7, 7}, {3, 3}) == 9);                 // Theorem 7.2
  CHECK(count({4, 4, 4, 4, 4, 4}, {5, 5}) == 6);     // Theorem 7.3
  CHECK(count({5, 4, 4, 7}, {5, 3}) == 6);           // Theorem 7.4
  CHECK(count({4, 4, 4, 4, 4, 4, 4, 4}, {8}) == 9);  // (L-1)^2
  CHECK(count({4, 4, 4}, {3}) == 1);                 // Theorem 7.1
  CHECK(count({3, 3, 3}, {3}) == 0);                 // odd
  CHECK(count({5, 4, 5, 4}, {}) == 1);               // a grid
  CHECK(count({5, 4, 6, 5}, {}) == 0);
  CHECK(count({60, 50, 60, 50}, {}) == 1);  // 3000 quads, one on the other
  CHECK_FALSE(problem_with({{1, 1, 1, 101}, {}}).empty());
  CHECK_FALSE(problem_with({std::vector<int>(10001, 2), {}}).empty());
}

TEST_CASE("the side-length law counts configurations of other pairs, too", "[search]") {
  // Law theory-1 for valences beyond the paper's. The parameter sets of 3-6 and 5-6 pairs are compared with the search.
  for (const theory::PairType type : {theory::PairType{6, 3}, theory::PairType{6, 5}}) {
    const int k = type.side_count();
    int regions = 0;
    for (int first = 2; first <= 4; ++first) {
      for (int second = 2; second <= 4; ++second) {
        theory::IntegerVector sides = theory::IntegerVector::Constant(k, 3);
        sides(0) = first, sides(2) = second;
        if (sides.sum() % 2 != 0) sides(1) = 4;
        REQUIRE(count({sides.begin(), sides.end()}, {type.l1, type.l2}) ==
                static_cast<std::int64_t>(theory::parameter_set({type, sides}).size()));
        ++regions;
      }
    }
    CHECK(regions == 9);
  }
}

namespace {

// The number of simple quadrangulations of a polygon of 2m + 4 labelled vertices, with n interior vertices (W. G.
// Brown, Enumeration of quadrangular dissections of the disk, Canad. J. Math. 17, 1965, 302-317). For n = 0 these are
// the Fuss-Catalan numbers, for m = 0 OEIS A000139.
std::int64_t brown(int m, int n) {
  const auto factorial = [](int k) { return std::tgamma(static_cast<double>(k) + 1); };
  return std::llround((3 * m + 4) * (3 * m + 3) * factorial(3 * m + 3) / factorial(m + 1) / factorial(2 * m + 3) *
                      factorial(3 * n + 3 * m + 2) / factorial(n) / factorial(2 * n + 3 * m + 4));
}

// The problem of which the region is a filling.
SearchProblem problem_of(const mesh::Region& region) {
  SearchProblem problem;
  for (const mesh::HalfEdgeId h : mesh::boundary_loop(region.mesh, region.root)) {
    problem.interior_quads.push_back(region.mesh.face_valence(region.mesh.origin(h)));
  }
  for (const mesh::VertexId v : region.mesh.vertices()) {
    if (!region.mesh.is_boundary(v) && region.mesh.valence(v) != 4) problem.irregular.push_back(region.mesh.valence(v));
  }
  std::sort(problem.irregular.begin(), problem.irregular.end());
  return problem;
}

using Regions = std::map<std::string, mesh::Region>;  // by signature

// Adds the region, and all those that sequences of flips make of it.
void add_flipped(Regions& regions, const mesh::Region& start) {
  std::vector<std::string> queue{mesh::signature(start)};
  if (!regions.emplace(queue.back(), start).second) return;
  while (!queue.empty()) {
    const mesh::Region here = regions.at(queue.back());
    queue.pop_back();
    for (const mesh::HalfEdgeId h : here.mesh.half_edges()) {
      for (const mesh::Rotation rotation : {mesh::Rotation::clockwise, mesh::Rotation::counter_clockwise}) {
        mesh::Region next = here;
        if (mesh::flip(next.mesh, h, rotation) != mesh::Refusal::none) continue;
        next.root = next.mesh.out(here.mesh.origin(here.root));
        std::string text = mesh::signature(next);
        if (regions.emplace(text, next).second) queue.push_back(std::move(text));
      }
    }
  }
}

// The regions that a split and then flips make of these regions. They have one interior vertex more.
Regions with_one_more_vertex(const Regions& regions) {
  Regions result;
  for (const auto& [text, region] : regions) {
    for (const mesh::HalfEdgeId first : region.mesh.half_edges()) {
      for (const mesh::HalfEdgeId last : region.mesh.half_edges()) {
        mesh::Region next = region;
        if (mesh::split(next.mesh, first, last).refusal != mesh::Refusal::none) continue;
        next.root = next.mesh.out(region.mesh.origin(region.root));
        add_flipped(result, next);
      }
    }
  }
  return result;
}

}  // namespace

TEST_CASE("search finds all quadrangulations of a polygon, summed over all boundaries and budgets", "[search]") {
  SearchLimits limits;
  limits.threads = 1;
  for (const auto& [m, n] : std::vector<std::pair<int, int>>{
           {0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 0}, {1, 1}, {1, 2}, {1, 3}, {2, 1}, {2, 2}, {3, 1}}) {
    const int length = 2 * m + 4;
    limits.faces = m + 1 + n;
    std::int64_t total = 0;
    SearchProblem problem;
    // First come the interior valences in ascending order, then the numbers of quads at the boundary vertices. Their
    // sum is the number of corners of quads.
    const auto choose_boundary = [&](auto&& self, int corners) -> void {
      const int left = length - static_cast<int>(problem.interior_quads.size());
      if (left == 0) {
        SearchProblem asked = problem;
        std::erase(asked.irregular, 4);
        const SearchOutcome found = search(asked, limits, {});
        const auto it = found.by_faces.find(*limits.faces);
        total += it == found.by_faces.end() ? 0 : it->second;
        return;
      }
      for (int quads = left == 1 ? corners : 1; quads <= corners - (left - 1); ++quads) {
        problem.interior_quads.push_back(quads);
        self(self, corners - quads);
        problem.interior_quads.pop_back();
      }
    };
    const auto choose_inside = [&, n = n](auto&& self, int corners) -> void {
      if (static_cast<int>(problem.irregular.size()) == n) return choose_boundary(choose_boundary, corners);
      for (int l = problem.irregular.empty() ? 2 : problem.irregular.back(); l <= corners - length; ++l) {
        problem.irregular.push_back(l);
        self(self, corners - l);
        problem.irregular.pop_back();
      }
    };
    choose_inside(choose_inside, 4 * *limits.faces);
    CAPTURE(m, n);
    CHECK(total == brown(m, n));
  }
}

TEST_CASE("enumerate-4: search finds the small regions that flips and splits make", "[search]") {
  // Splits and flips make all quadrangulations of a polygon; Brown's number shows that none is missing. They are sorted
  // by boundary and interior valences. For each of these problems the search finds the same regions.
  std::set<std::vector<int>> budgets;
  for (const auto& [m, most] : std::vector<std::pair<int, int>>{{0, 5}, {1, 4}, {2, 3}, {3, 2}}) {
    Regions regions;
    add_flipped(regions, tests::grid(m + 1, 1));
    for (int n = 0; n <= most; ++n) {
      if (n > 0) regions = with_one_more_vertex(regions);
      REQUIRE(static_cast<std::int64_t>(regions.size()) == brown(m, n));
      std::map<std::pair<std::vector<int>, std::vector<int>>, std::vector<std::string>> by_problem;
      for (const auto& [text, region] : regions) {
        const SearchProblem problem = problem_of(region);
        by_problem[{problem.interior_quads, problem.irregular}].push_back(text);
        budgets.insert(problem.irregular);
      }
      for (const auto& [problem, texts] : by_problem) {
        SearchLimits limits;
        limits.threads = 1;
        limits.faces = m + 1 + n;
        std::vector<std::string> found;
        search({problem.first, problem.second}, limits, [&](const Filling& filling) {
          if (static_cast<int>(filling.faces.size()) == *limits.faces)
            found.push_back(mesh::signature(region_of(filling)));
        });
        std::sort(found.begin(), found.end());
        REQUIRE(found == texts);
      }
    }
  }
  for (const std::vector<int>& budget :
       {std::vector<int>{3, 3, 3}, {2, 3, 5}, {2, 2, 6}, {2, 3, 3, 5}, {3, 3, 3, 3}, {2, 5}, {}}) {
    CAPTURE(budget);
    CHECK(budgets.count(budget) == 1);
  }
}

TEST_CASE("without a pruning rule, search finds the same with more states", "[search]") {
  const std::vector<std::pair<SearchProblem, int>> problems{
      {search_problem({5, 5}, {3, 3}), 16},         {search_problem({4, 4, 4}, {3, 3, 5}), 12},
      {search_problem({5, 5, 5, 5}, {2, 6}), 25},   {search_problem({6, 6}, {3, 3, 3, 5}), 18},
      {{std::vector<int>(8, 2), {3, 3, 3, 3}}, 18}, {{std::vector<int>(4, 2), {2, 2, 3}}, 10},
      {{{3, 3, 1, 3, 3, 1}, {2, 3, 3, 3, 3}}, 12}};
  for (bool SearchPruning::*rule : {&SearchPruning::gauss_bonnet, &SearchPruning::parity, &SearchPruning::face_bound}) {
    std::int64_t states_with = 0, states_without = 0, count = 0;
    for (const auto& [problem, faces] : problems) {
      SearchLimits limits;
      limits.faces = faces;
      const CountedSearch with = count_fillings(problem, limits, true);
      limits.pruning.*rule = false;
      const CountedSearch without = count_fillings(problem, limits, true);
      CHECK(without.signatures == with.signatures);
      CHECK(without.outcome.by_faces == with.outcome.by_faces);
      states_with += with.outcome.states;
      states_without += without.outcome.states;
      count += with.outcome.count;
    }
    CHECK(count > 100);
    CHECK(states_without > states_with);
  }
}

TEST_CASE("no edge is doubled", "[search]") {
  // These problems were found by random trials. In the first one, only the test of the edge w-x prevents a doubled
  // edge; in the second one, only the test of the edge v-y. A doubled edge has four faces, and region_of() refuses it.
  for (const SearchProblem& problem : {SearchProblem{{4, 4, 3, 3}, {3, 2, 3, 2, 2, 3, 2, 5}},
                                       SearchProblem{{4, 3, 2, 4, 2, 4}, {3, 3, 2, 3, 3, 3, 2, 2}}}) {
    SearchLimits limits;
    limits.faces = 12;
    limits.threads = 1;
    std::set<std::string> signatures;
    const SearchOutcome found = search(
        problem, limits, [&](const Filling& filling) { signatures.insert(mesh::signature(region_of(filling))); });
    CHECK(found.count > 0);
    CHECK(static_cast<std::int64_t>(signatures.size()) == found.count);
  }
}

TEST_CASE("threads and limits do not change the result", "[search]") {
  const SearchProblem problem = search_problem({6, 6, 6}, {3, 3, 5});
  SearchLimits one, two;
  one.threads = 1, two.threads = 2;
  const CountedSearch a = count_fillings(problem, one, true), b = count_fillings(problem, two, true);
  CHECK(a.signatures == b.signatures);
  CHECK(a.outcome.by_faces == b.outcome.by_faces);
  // The search is long, so that threads share work many times. Eight threads are more than the work needs.
  for (const int threads : {2, 3, 8}) {
    SearchLimits many;
    many.threads = threads;
    const SearchProblem larger = search_problem({10, 10, 10}, {3, 3, 5});
    const SearchOutcome by_one = search(larger, one, {}), by_many = search(larger, many, {});
    REQUIRE(by_one.states > 100'000);
    CHECK(by_many.by_faces == by_one.by_faces);
    CHECK(by_many.states == by_one.states);
  }
  // An exception in a visit ends all threads, and reaches the caller.
  SearchLimits four;
  four.threads = 4;
  CHECK_THROWS_AS(search(problem, four, [](const Filling&) { throw std::domain_error("enough"); }), std::domain_error);
  // Up to the face limit, the numbers by faces are exact.
  SearchLimits limited = one;
  limited.faces = 20;
  const CountedSearch c = count_fillings(problem, limited, false);
  CHECK_FALSE(c.outcome.complete());
  for (const auto& [faces, number] : a.outcome.by_faces) {
    const auto it = c.outcome.by_faces.find(faces);
    CHECK((it == c.outcome.by_faces.end() ? 0 : it->second) == (faces <= 20 ? number : 0));
  }
  SearchLimits hurried;
  hurried.seconds = 0.05;
  const SearchOutcome cut = search({std::vector<int>(20, 2), {3, 3, 3, 3}}, hurried, {});
  CHECK(cut.out_of_time);
  CHECK_FALSE(cut.complete());
}

TEST_CASE("orbits of fillings under the symmetries of the boundary", "[search]") {
  // The configurations of a regular hexagon of side 5 are counted by their least rotated signatures.
  std::set<std::string> rotations, all;
  std::mutex mutex;
  const SearchProblem problem = search_problem({5, 5, 5, 5, 5, 5}, {5, 5});
  search(problem, {}, [&](const Filling& filling) {
    const mesh::Region region = region_of(filling);
    auto rotated = mesh::rotated_signatures(region);
    auto reflected = mesh::reflected_signatures(region);
    const std::scoped_lock lock(mutex);
    rotations.insert(*std::min_element(rotated.begin(), rotated.end()));
    rotated.insert(rotated.end(), reflected.begin(), reflected.end());
    all.insert(*std::min_element(rotated.begin(), rotated.end()));
  });
  const CountedSearch counted = count_fillings(problem, {}, false);
  CHECK(counted.orbits.rotations == static_cast<std::int64_t>(rotations.size()));
  CHECK(counted.orbits.reflections == static_cast<std::int64_t>(all.size()));
}

TEST_CASE("the closed spheres with eight v3s", "[search]") {
  // OEIS A111361 has V = 8..26. plantri gives the same counts up to 20.
  const SphereOutcome octahedrites = search_spheres(std::vector<int>(8, 3), 20, {});
  const std::vector<std::int64_t> expected{1, 0, 1, 1, 2, 1, 5, 2, 8, 5, 12, 8, 25};
  for (int v = 8; v <= 20; ++v) {
    const auto it = octahedrites.counts.find(v);
    CHECK((it == octahedrites.counts.end() ? 0 : it->second) == expected[static_cast<std::size_t>(v - 8)]);
  }
  for (const std::string& text : octahedrites.signatures) {
    const mesh::Region sphere = mesh::from_signature(text);
    CHECK(mesh::validate(sphere.mesh).empty());
    CHECK(mesh::euler_characteristic(sphere.mesh) == 2);
  }
  CHECK_THROWS_AS(search_spheres({3, 3, 3}, 10, {}), std::invalid_argument);
}

TEST_CASE("enumerate-5: all quadrangulations of the sphere without valence 2", "[search]") {
  // OEIS A078666: 1, 0, 1, 1, 3, 3, 12 spheres with V = 8..14 vertices, where mirror images count as one. Here they are
  // the sum over all budgets.
  const std::vector<std::int64_t> expected{1, 0, 1, 1, 3, 3, 12};
  for (int v = 8; v <= 14; ++v) {
    std::int64_t total = 0;
    std::vector<int> valences;
    const auto add_budgets = [&](auto&& self, int left, int sum, int least) -> void {
      if (left == 0) {
        std::vector<int> irregular;
        std::copy_if(valences.begin(), valences.end(), std::back_inserter(irregular), [](int l) { return l != 4; });
        const SphereOutcome found = search_spheres(irregular, v, {});
        const auto it = found.counts.find(v);
        total += it == found.counts.end() ? 0 : it->second;
        return;
      }
      for (int l = least; l * left <= sum; ++l) {
        if (left == 1 && l != sum) continue;
        valences.push_back(l);
        self(self, left - 1, sum - l, l);
        valences.pop_back();
      }
    };
    add_budgets(add_budgets, v, 4 * (v - 2), 3);  // the sum of the valences is twice the number of edges
    CHECK(total == expected[static_cast<std::size_t>(v - 8)]);
  }
}
