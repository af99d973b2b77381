// theory/: the equations of the paper, its closed forms, parameter sets and predicted graphs.
#include <set>

#include <boost/graph/connected_components.hpp>

#include "tests/support/catch.hpp"
#include "tests/support/theory/integer_vector.hpp"
#include "theory/configuration_graph.hpp"
#include "theory/counts.hpp"

using namespace requad;
using namespace requad::theory;
using requad::tests::sides;

namespace {

StripParameters parameters(Integer d1, Integer d2, std::initializer_list<Integer> e) { return {d1, d2, sides(e)}; }

// The number of edges between configurations (d1, d2) and (d1', d2') of a digon.
std::size_t edges_between(const ConfigurationGraph& graph, std::array<Integer, 2> a, std::array<Integer, 2> b) {
  std::size_t count = 0;
  for (const auto e : boost::make_iterator_range(edges(graph))) {
    const auto& s = graph[source(e, graph)].configuration;
    const auto& t = graph[target(e, graph)].configuration;
    const std::array<Integer, 2> from{s.d1(), s.d2()};
    const std::array<Integer, 2> to{t.d1(), t.d2()};
    if ((from == a && to == b) || (from == b && to == a)) ++count;
  }
  return count;
}

std::size_t degree_total(const ConfigurationGraph& graph, bool merged) {
  std::size_t total = 0;
  for (const auto v : boost::make_iterator_range(vertices(graph))) {
    if (graph[v].configuration.merged() == merged) total += out_degree(v, graph);
  }
  return total;
}

}  // namespace

TEST_CASE("theory-1 is the paper's three systems", "[theory]") {
  // Proof of Theorem 7.2: E1 = d1+d2+2 e2, E2 = d1+d2+2 e1. All values are different primes, so every coefficient
  // counts.
  const PairSystem digon(kDigon);
  CHECK(digon.side_lengths(parameters(2, 3, {5, 7})) == sides({2 + 3 + 14, 2 + 3 + 10}));
  // Equation 2.
  const PairSystem hexagon(kHexagon);
  const Integer d1 = 2, d2 = 3, e1 = 5, e2 = 7, e3 = 11, e4 = 13, e5 = 17, e6 = 19;
  CHECK(hexagon.side_lengths(parameters(d1, d2, {e1, e2, e3, e4, e5, e6})) ==
        sides({d1 + e2 + e6, e1 + e3, d2 + e2 + e4, d1 + e3 + e5, e4 + e6, d2 + e1 + e5}));
  // Equation 3.
  const PairSystem quad(kQuad);
  CHECK(quad.side_lengths(parameters(d1, d2, {e1, e2, e3, e4})) ==
        sides({d1 + e2 + e4, e1 + e3, d2 + e2 + e4, d1 + d2 + e1 + e3}));
}

TEST_CASE("theory-2: the strip matrix is singular exactly when 4 divides k", "[theory]") {
  for (int l1 = 3; l1 <= 9; ++l1) {
    for (int l2 = 3; l2 <= l1; ++l2) {
      const PairSystem system({l1, l2});
      const int k = l1 + l2 - 4;
      INFO("k = " << k);
      if (k == 2) {
        CHECK(determinant(system.strip_matrix()) == -4);  // the other side of a digon is both neighbours of a side
      } else if (k % 4 == 0) {
        CHECK(determinant(system.strip_matrix()) == 0);
      } else {
        CHECK(std::abs(determinant(system.strip_matrix())) == (k % 2 == 0 ? 4 : 2));
      }
    }
  }
  // Equation 2 consists of two 3 x 3 systems of determinant +-2, for sides 1 3 5 and 2 4 6.
  const IntegerMatrix whole = PairSystem(kHexagon).strip_matrix();
  for (int odd = 0; odd < 2; ++odd) {
    IntegerMatrix part(3, 3);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) part(i, j) = whole(2 * i + odd, 2 * j + 1 - odd);
    }
    CHECK(std::abs(determinant(part)) == 2);
  }
}

TEST_CASE("Bareiss elimination agrees with cofactors", "[theory]") {
  IntegerMatrix m(3, 3);
  m << 0, 2, 3, 4, 5, 6, 7, 8, 10;
  CHECK(determinant(m) == 0 * (50 - 48) - 2 * (40 - 42) + 3 * (32 - 35));
  CHECK(determinant(IntegerMatrix::Identity(5, 5)) == 1);
  CHECK(determinant(IntegerMatrix::Zero(2, 2)) == 0);
}

TEST_CASE("solve_circulant finds exactly the positive solutions", "[theory]") {
  // Brute force tries all e with entries 1..5.
  for (int k = 1; k <= 6; ++k) {
    std::map<std::vector<Integer>, std::vector<std::vector<Integer>>> by_sides;
    std::vector<Integer> e(static_cast<std::size_t>(k), 1);
    for (;;) {
      std::vector<Integer> c(e.size());
      for (std::size_t i = 0; i < e.size(); ++i) c[i] = e[(i + e.size() - 1) % e.size()] + e[(i + 1) % e.size()];
      by_sides[c].push_back(e);
      std::size_t i = e.size();
      while (i > 0 && e[i - 1] == 5) e[--i] = 1;
      if (i == 0) break;
      ++e[i - 1];
    }
    for (const auto& [c, expected] : by_sides) {
      // If sums are at most 6, every solution has entries 1..5. So brute force found all of them.
      if (*std::max_element(c.begin(), c.end()) > 6) continue;
      IntegerVector v(k);
      std::copy(c.begin(), c.end(), v.begin());
      std::vector<std::vector<Integer>> found;
      for (const IntegerVector& s : solve_circulant(v)) found.emplace_back(s.begin(), s.end());
      REQUIRE(found == expected);
    }
  }
  CHECK(solve_circulant(sides({3, 4})).empty());        // parity
  CHECK(solve_circulant(sides({2, 2, 9, 2})).empty());  // 2 = e2 + e4 = 9
}

TEST_CASE("tau is that of Theorems 7.2 and 7.3", "[theory]") {
  // N(N-1) for even L and N^2 for odd L, where N = floor(L/2), written out by hand.
  const std::vector<Integer> expected{0, 1, 2, 4, 6, 9, 12, 16, 20, 25};  // L = 2..11
  for (Integer length = 2; length <= 11; ++length) {
    CHECK(tau_digon(length) == expected[static_cast<std::size_t>(length - 2)]);
    CHECK(tau_hexagon(length) == 3 * expected[static_cast<std::size_t>(length - 2)]);
  }
}

TEST_CASE("parameter sets have the range, the parity and the identification of the theorems", "[theory]") {
  for (Integer length = 3; length <= 15; ++length) {
    // {(m,n) : 0 < m+n <= L-2}, with m+n = L mod 2 and (x,0) ~ (0,x).
    std::set<std::pair<Integer, Integer>> expected;
    for (Integer m = 1; m <= length; ++m) {
      for (Integer n = 0; m + n <= length - 2; ++n) {
        if ((m + n - length) % 2 == 0) expected.emplace(m, n);
      }
    }
    std::set<std::pair<Integer, Integer>> found;
    for (const Configuration& c : parameter_set(RegionShape::regular(kDigon, length))) found.emplace(c.d1(), c.d2());
    CHECK(found == expected);
    CHECK(static_cast<Integer>(found.size()) == tau_digon(length));

    std::set<std::tuple<Integer, Integer, int>> hexagon;
    for (const Configuration& c : parameter_set(RegionShape::regular(kHexagon, length)))
      hexagon.emplace(c.d1(), c.d2(), c.p);
    std::set<std::tuple<Integer, Integer, int>> hexagon_expected;
    for (const auto& [m, n] : expected) {
      for (int p = 1; p <= 3; ++p) hexagon_expected.emplace(m, n, p);
    }
    CHECK(hexagon == hexagon_expected);
  }
}

TEST_CASE("brute force over all strip counts gives the same parameter sets", "[theory]") {
  // Every (p, d1, d2, e) with entries up to a bound is mapped to its region. This is an independent count. Degenerate
  // configurations have two labellings, so each labelling counts one half.
  const auto brute = [](PairType type, Integer longest) {
    const int k = type.side_count();
    std::map<std::vector<Integer>, Integer> twice;  // by sides
    for (int p = 1; p <= type.rotation_count(); ++p) {
      for (Integer d1 = 0; d1 <= longest; ++d1) {
        for (Integer d2 = 0; d2 <= longest; ++d2) {
          if (d1 + d2 == 0) continue;
          std::vector<Integer> e(static_cast<std::size_t>(k), 1);
          for (;;) {
            Configuration c;
            c.p = p;
            c.parameters = {d1, d2, IntegerVector(k)};
            std::copy(e.begin(), e.end(), c.parameters.e.begin());
            const IntegerVector s = region_sides(type, c);
            twice[std::vector<Integer>(s.begin(), s.end())] += d1 == 0 || d2 == 0 ? 1 : 2;
            std::size_t i = e.size();
            while (i > 0 && e[i - 1] == longest) e[--i] = 1;
            if (i == 0) break;
            ++e[i - 1];
          }
        }
      }
    }
    return twice;
  };
  for (const auto& [type, longest] :
       {std::pair{kDigon, Integer{6}}, std::pair{kQuad, Integer{4}}, std::pair{kHexagon, Integer{3}}}) {
    int compared = 0;
    for (const auto& [s, twice] : brute(type, longest)) {
      // If a side is at most the bound + 1, no parameter exceeds the bound.
      if (*std::max_element(s.begin(), s.end()) > longest + 1) continue;
      IntegerVector v(static_cast<Eigen::Index>(s.size()));
      std::copy(s.begin(), s.end(), v.begin());
      REQUIRE(2 * static_cast<Integer>(parameter_set({type, v}).size()) == twice);
      REQUIRE(2 * exact_count({type, v}) == twice);
      ++compared;
    }
    CHECK(compared > 10);
  }
}

TEST_CASE("3-5 regions have K = M N configurations, with the labelling of Equation 3", "[theory]") {
  // d1 = 2, d2 = 1, e = (1,2,3,1): E = (5, 4, 4, 7), M = E2 - 1 = 3, N = E1 - d1 - 1 = 2 by Theorem 7.4.
  const QuadCount q = quad_count({kQuad, sides({5, 4, 4, 7})});
  CHECK(q.p == 1);
  CHECK(q.d1 == 2);
  CHECK(q.d2 == 1);
  CHECK(q.m == 3);
  CHECK(q.n == 2);
  std::set<std::pair<Integer, Integer>> points;
  for (const Configuration& c : parameter_set({kQuad, sides({5, 4, 4, 7})})) {
    const GridPoint at = grid_point(kQuad, c);
    points.emplace(at.m, at.n);
    CHECK(c.d1() == 2);
    CHECK(c.d2() == 1);
  }
  CHECK(points == std::set<std::pair<Integer, Integer>>{{1, 1}, {1, 2}, {2, 1}, {2, 2}, {3, 1}, {3, 2}});
  // The same region is counted from each of its sides. The labelling changes accordingly, and the count stays.
  CHECK(quad_count({kQuad, sides({4, 4, 7, 5})}).k() == 6);
  CHECK(quad_count({kQuad, sides({4, 4, 7, 5})}).p == 4);
  // A rectangle holds no 3-5 pair.
  CHECK(exact_count({kQuad, sides({5, 4, 5, 4})}) == 0);
  CHECK(parameter_set({kQuad, sides({5, 4, 5, 4})}).empty());
}

TEST_CASE("the labels of a region's configurations differ", "[theory]") {
  for (const auto& [l1, l2] : {std::pair(3, 3), {5, 3}, {5, 5}, {6, 3}, {6, 5}, {7, 3}, {9, 3}, {6, 6}}) {
    const PairType type{l1, l2};
    std::vector<Integer> s(static_cast<std::size_t>(type.side_count()), 5);
    int regions = 0;
    for (int change = 0; change < 64; ++change) {
      for (std::size_t i = 0; i < s.size(); ++i) s[i] = 5 + (i < 6 && (change >> i & 1) != 0 ? 1 : 0);
      if (to_vector(s).sum() % 2 != 0) continue;
      std::set<std::string> labels;
      const std::vector<Configuration> all = parameter_set({type, to_vector(s)});
      for (const Configuration& c : all) labels.insert(label(type, c));
      CAPTURE(type.name(), to_vector(s).transpose());
      CHECK(labels.size() == all.size());
      regions += all.empty() ? 0 : 1;
    }
    CHECK(regions > 0);
  }
}

TEST_CASE("non-regular digons have tau of the shorter side, and none if the difference is odd", "[theory]") {
  CHECK(exact_count({kDigon, sides({5, 9})}) == 4);
  CHECK(exact_count({kDigon, sides({9, 5})}) == 4);
  CHECK_THROWS_AS(exact_count({kDigon, sides({5, 8})}), std::invalid_argument);  // odd boundary
  CHECK(smallest_regular({kDigon, sides({5, 9})}) == 9);
  CHECK(smallest_regular({kHexagon, sides({4, 4, 4, 4, 4, 4})}) == 4);
  // Regions like (3,3,3,4,2,4) grow from regular ones. This is checked for every L and every vector of strip counts.
  for (const auto& s : {sides({3, 3, 4, 4, 2, 4}), sides({5, 4, 5, 6, 3, 7}), sides({2, 3, 3, 3, 2, 3})}) {
    Integer least = 0;
    for (Integer length = s.maxCoeff(); least == 0; ++length) {
      // s_{i-1} + s_{i+1} = L - E_i with s >= 0 is the positive system for s + 1.
      if (!solve_circulant(IntegerVector::Constant(6, length + 2) - s).empty()) least = length;
    }
    CHECK(smallest_regular({kHexagon, s}) == least);
  }
}

TEST_CASE("impossible sides and parameters are refused with the reason", "[theory]") {
  CHECK(RegionShape::problem(kDigon, sides({3, 3})).empty());
  CHECK(RegionShape::problem(kDigon, sides({3, 4})).find("odd") != std::string::npos);
  CHECK(RegionShape::problem(kDigon, sides({3, 3, 3})).find("2 sides") != std::string::npos);
  CHECK(RegionShape::problem(kDigon, sides({0, 4})).find("side 0") != std::string::npos);
  CHECK(RegionShape::problem(kDigon, sides({2, kMaxLength + 2})).find("not in 1..") != std::string::npos);
  CHECK(parameters_problem(kDigon, parameters(1, 0, {1, 1})).empty());
  CHECK_FALSE(parameters_problem(kDigon, parameters(0, 0, {1, 1})).empty());
  CHECK_FALSE(parameters_problem(kDigon, parameters(-1, 2, {1, 1})).empty());
  CHECK_FALSE(parameters_problem(kDigon, parameters(1, 2, {1, 0})).empty());
  CHECK_FALSE(parameters_problem(kDigon, parameters(1, 2, {1})).empty());
}

TEST_CASE("theory-3: both labellings of a segment give the same region", "[theory]") {
  for (const PairType type : {kDigon, kHexagon, kQuad}) {
    for (int p = 1; p <= type.rotation_count(); ++p) {
      Configuration c;
      c.p = p;
      c.parameters = {3, 0, IntegerVector(type.side_count())};
      for (int i = 0; i < type.side_count(); ++i) c.parameters.e(i) = 1 + (i * i) % 5;
      const Configuration other = other_labelling(type, c);
      CHECK(other.d1() == 0);
      CHECK(other.d2() == 3);
      CHECK(region_sides(type, other) == region_sides(type, c));
      CHECK(other_labelling(type, other) == c);
      CHECK(canonical(type, other) == c);
      if (type == kHexagon) CHECK(other.p == p % 3 + 1);
    }
  }
}

TEST_CASE("theory-4: the graph has levels, a self-loop, a double edge and an apex", "[theory]") {
  const auto even = configuration_graph(configuration_map({kDigon, sides({8, 8})}, Apex::with));
  const auto odd = configuration_graph(configuration_map({kDigon, sides({7, 7})}, Apex::with));
  CHECK(edges_between(odd, {1, 0}, {1, 0}) == 1);
  CHECK(edges_between(even, {2, 0}, {1, 1}) == 2);
  CHECK(edges_between(even, {1, 1}, {0, 0}) == 1);
  CHECK(edges_between(even, {2, 0}, {2, 0}) == 0);
  for (const auto& [graph, levels, factor] :
       {std::tuple{even, std::vector<Integer>{2, 4, 6}, Integer{1}},
        std::tuple{odd, std::vector<Integer>{1, 3, 5}, Integer{1}},
        std::tuple{configuration_graph(configuration_map(RegionShape::regular(kHexagon, 8), Apex::with)),
                   std::vector<Integer>{2, 4, 6}, Integer{3}}}) {
    for (const Integer s : levels) {
      Integer within = 0, up = 0, nodes = 0;
      for (const auto v : boost::make_iterator_range(vertices(graph))) {
        nodes += graph[v].configuration.d1() + graph[v].configuration.d2() == s ? 1 : 0;
      }
      for (const auto e : boost::make_iterator_range(edges(graph))) {
        const auto& a = graph[source(e, graph)].configuration;
        const auto& b = graph[target(e, graph)].configuration;
        const auto [low, high] = std::minmax({a.d1() + a.d2(), b.d1() + b.d2()});
        within += low == s && high == s ? 1 : 0;
        up += low == s && high == s + 2 ? 1 : 0;
      }
      CHECK(nodes == factor * s);
      CHECK(within == factor * s);
      CHECK(up == (s == levels.back() ? 0 : factor * (s + 1)));
    }
  }
  CHECK(degree_total(configuration_graph(configuration_map(RegionShape::regular(kHexagon, 6), Apex::with)), true) == 3);
  // For a 3-5 pair, an M x N grid has 2 M N - M - N edges.
  const auto grid = configuration_graph(configuration_map({kQuad, sides({5, 4, 4, 7})}, Apex::with));
  CHECK(num_vertices(grid) == 6);
  CHECK(num_edges(grid) == 2 * 6 - 3 - 2);
}

TEST_CASE("moves of the predicted map come in pairs", "[theory]") {
  for (const auto& map : {configuration_map({kDigon, sides({10, 10})}, Apex::with),
                          configuration_map({kDigon, sides({9, 9})}, Apex::with),
                          configuration_map(RegionShape::regular(kHexagon, 7), Apex::with),
                          configuration_map(RegionShape::regular(kHexagon, 6), Apex::with),
                          configuration_map({kHexagon, sides({5, 4, 5, 6, 3, 7})}, Apex::with),
                          configuration_map({kQuad, sides({5, 4, 4, 7})}, Apex::with)}) {
    for (std::size_t i = 0; i < map.nodes.size(); ++i) {
      for (std::size_t slot = 0; slot < map.nodes[i].moves.size(); ++slot) {
        const Dart& dart = map.nodes[i].moves[slot];
        if (dart.target < 0) continue;
        const Dart& back = map.nodes[static_cast<std::size_t>(dart.target)].moves[static_cast<std::size_t>(dart.slot)];
        CHECK(back.target == static_cast<int>(i));
        CHECK(back.slot == static_cast<int>(slot));
      }
    }
  }
}

TEST_CASE("the dual of a grid is the next smaller grid", "[theory]") {
  // Captions of Figures 10 and 11. This test compares counts; claim F1 of requad-verify compares labels.
  for (const PairType type : {kDigon, kHexagon}) {
    for (Integer length = 3; length <= 12; ++length) {
      const auto map = configuration_map(RegionShape::regular(type, length), Apex::with);
      const auto smaller = configuration_map(RegionShape::regular(type, length - 1), Apex::with);
      const DualGrid dual = dual_grid(map);
      CHECK(dual.faces.size() == smaller.nodes.size());
      CHECK(dual.edges.size() == num_edges(configuration_graph(smaller)));
    }
  }
}
