// Exhaustive search: exactly once, against theory, against brute force, against published counts.
#include <iterator>
#include <mutex>
#include <set>

#include "enumerate/search.hpp"
#include "mesh/signature.hpp"
#include "mesh/validate.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"
#include "theory/configurations.hpp"

using namespace requad;
using namespace requad::enumerate;

namespace {

std::int64_t count(const std::vector<int>& sides, const std::vector<int>& irregular) {
  const CountedSearch found = count_fillings(search_problem(sides, irregular), {}, true);
  REQUIRE(found.outcome.complete());
  // Precisely once.
  CHECK(std::adjacent_find(found.signatures.begin(), found.signatures.end()) == found.signatures.end());
  CHECK(static_cast<std::int64_t>(found.signatures.size()) == found.outcome.count);
  return found.outcome.count;
}

}  // namespace

TEST_CASE("every filling has the boundary and the valences that were asked for", "[search]") {
  std::mutex mutex;
  for (const auto& [sides, irregular] : std::vector<std::pair<std::vector<int>, std::vector<int>>>{
           {{6, 6, 6}, {3, 3, 5}}, {{5, 5}, {3, 3}}, {{4, 4, 4, 4}, {3, 3, 5, 5}}, {{4, 4, 4, 4, 4}, {5}}, {{3, 4, 5}, {3}},
           {{5, 5, 5, 5}, {2, 6}}, {{6, 4}, {2}}, {{3, 3, 3, 3, 3, 3, 3}, {5, 5, 5}}}) {
    const SearchProblem problem = search_problem(sides, irregular);
    search(problem, {}, [&](const Filling& filling) {
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
  CHECK(count({7, 7}, {3, 3}) == 9);                       // Theorem 7.2
  CHECK(count({4, 4, 4, 4, 4, 4}, {5, 5}) == 6);           // Theorem 7.3
  CHECK(count({5, 4, 4, 7}, {5, 3}) == 6);                 // Theorem 7.4
  CHECK(count({4, 4, 4, 4, 4, 4, 4, 4}, {8}) == 9);        // (L-1)^2
  CHECK(count({4, 4, 4}, {3}) == 1);                       // Theorem 7.1
  CHECK(count({3, 3, 3}, {3}) == 0);                       // odd
  CHECK(count({5, 4, 5, 4}, {}) == 1);                     // a grid
  CHECK(count({5, 4, 6, 5}, {}) == 0);
}

TEST_CASE("other pairs: the one side-length law counts them too", "[search]") {
  // Law 1 for valences beyond the paper's: 3-6, 5-6 by parameter set, against search that knows no law.
  for (const theory::PairType type : {theory::PairType{6, 3}, theory::PairType{6, 5}}) {
    const int k = type.side_count();
    int regions = 0;
    for (int first = 2; first <= 4; ++first) {
      for (int second = 2; second <= 4; ++second) {
        theory::IntegerVector sides = theory::IntegerVector::Constant(k, 3);
        sides(0) = first, sides(2) = second;
        if (sides.sum() % 2 != 0) sides(1) = 4;
        REQUIRE(count({sides.begin(), sides.end()}, {type.l1, type.l2}) == static_cast<std::int64_t>(theory::parameter_set(type, sides).size()));
        ++regions;
      }
    }
    CHECK(regions == 9);
  }
}

TEST_CASE("search against flips and splits: small regions by brute force", "[search]") {
  // All quadrangulations of a boundary with a given number of faces are joined by flips (any valences). Collect what
  // flips reach from one filling, sort by valences, and compare with search for each budget that occurs.
  for (const auto& start : {tests::grid(3, 2), tests::grid(2, 2), tests::grid(4, 2)}) {
    std::map<std::string, mesh::Region> reached{{mesh::signature(start), start}};
    std::vector<std::string> queue{mesh::signature(start)};
    std::vector<int> boundary_quads;
    for (const mesh::HalfEdgeId h : mesh::boundary_loop(start.mesh, start.root)) boundary_quads.push_back(start.mesh.face_valence(start.mesh.origin(h)));
    while (!queue.empty() && reached.size() < 20000) {
      const mesh::Region here = reached.at(queue.back());
      queue.pop_back();
      for (const mesh::HalfEdgeId h : here.mesh.half_edges()) {
        for (const mesh::Turn turn : {mesh::Turn::clockwise, mesh::Turn::counter_clockwise}) {
          mesh::Region next = here;
          if (mesh::flip(next.mesh, h, turn) != mesh::Refusal::none) continue;
          next.root = next.mesh.out(here.mesh.origin(here.root));
          const std::string text = mesh::signature(next);
          if (reached.emplace(text, next).second) queue.push_back(text);
        }
      }
    }
    // Same boundary quads as the start, by budget.
    std::map<std::vector<int>, std::set<std::string>> by_budget;
    for (const auto& [text, region] : reached) {
      std::vector<int> quads, budget;
      for (const mesh::HalfEdgeId h : mesh::boundary_loop(region.mesh, region.root)) quads.push_back(region.mesh.face_valence(region.mesh.origin(h)));
      if (quads != boundary_quads) continue;
      for (const mesh::VertexId v : region.mesh.vertices()) {
        if (!region.mesh.is_boundary(v) && region.mesh.valence(v) != 4) budget.push_back(region.mesh.valence(v));
      }
      std::sort(budget.begin(), budget.end());
      by_budget[budget].insert(text);
    }
    REQUIRE(!by_budget.empty());
    for (const auto& [budget, texts] : by_budget) {
      SearchLimits limits;
      limits.faces = start.mesh.face_count();
      std::set<std::string> found;
      std::mutex mutex;
      search({boundary_quads, budget}, limits, [&](const Filling& filling) {
        const std::scoped_lock lock(mutex);
        if (static_cast<int>(filling.faces.size()) == start.mesh.face_count()) found.insert(mesh::signature(region_of(filling)));
      });
      CHECK(std::includes(found.begin(), found.end(), texts.begin(), texts.end()));
      CHECK(found == texts);
    }
  }
}

TEST_CASE("threads and limits do not change what is found", "[search]") {
  const SearchProblem problem = search_problem({6, 6, 6}, {3, 3, 5});
  SearchLimits one, two;
  one.threads = 1, two.threads = 2;
  const CountedSearch a = count_fillings(problem, one, true), b = count_fillings(problem, two, true);
  CHECK(a.signatures == b.signatures);
  CHECK(a.outcome.by_faces == b.outcome.by_faces);
  // Up to a face limit the numbers by faces are exact.
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

TEST_CASE("orbits", "[search]") {
  // Counted one by one: configurations of a regular hexagon of side 5 by their least rotated signature.
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

TEST_CASE("closed spheres", "[search]") {
  // Eight v3s: OEIS A111361; V = 8..26, those up to 20 as plantri counts them.
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

TEST_CASE("all quadrangulations of the sphere without valence 2", "[search]") {
  // OEIS A078666: 1, 0, 1, 1, 3, 3, 12 with V = 8..14 vertices, mirror images as one. Here as the sum over all budgets.
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
    add_budgets(add_budgets, v, 4 * (v - 2), 3);  // the valences sum to twice the edges
    CHECK(total == expected[static_cast<std::size_t>(v - 8)]);
  }
}
