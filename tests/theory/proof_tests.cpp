// The proofs for all sizes. Exact arithmetic is tested by examples, counting polynomials are compared with counts, and
// every proof must fail if its premises are false.
#include "tests/support/catch.hpp"
#include "tests/support/theory/integer_vector.hpp"
#include "theory/configurations.hpp"
#include "theory/counts.hpp"
#include "theory/proofs/polytope.hpp"
#include "theory/proofs/proofs.hpp"

using namespace requad;
using namespace requad::theory;
using requad::tests::sides;

namespace {

const Polynomial kX = Polynomial::variable(0);
const Polynomial kY = Polynomial::variable(1);

Rational value(const Polynomial& p, Integer at) {
  Rational sum = 0, power = 1;
  for (int degree = 0; degree <= 4; ++degree, power *= at) sum += p.coefficient({degree}) * power;
  return sum;
}

// The polygon of a regular region, as in regular_regions.cpp.
Polytope regular_polygon(PairType type) {
  const SideLaw law = side_law(type);
  const int k = type.side_count();
  Polytope p{IntegerMatrix(k, k + 2), IntegerVector::Ones(k), std::vector<bool>(static_cast<std::size_t>(k) + 2, true)};
  p.a << law.first, law.last, law.strips;
  p.strict[1] = false;
  return p;
}

void check_fails(const Proof& proof) {
  INFO(proof.claim);
  CHECK_FALSE(proof.proved());
  CHECK_FALSE(proof.failure().empty());
}

}  // namespace

TEST_CASE("rationals are exact, or report an overflow", "[proofs]") {
  CHECK(Rational(1, 3) + Rational(1, 6) == Rational(1, 2));
  CHECK(Rational(2, -4) == Rational(-1, 2));
  CHECK(Rational(-1, 2) < Rational(-1, 3));
  CHECK(Rational(-3, 2).floor() == -2);
  CHECK(Rational(3, 2).floor() == 1);
  CHECK(Rational(1, 2) / Rational(-3, 4) == Rational(-2, 3));
  CHECK(Rational(-3, 2).text() == "-3/2");
  CHECK_THROWS_AS(Rational(Integer{1} << 62) * Rational(4), std::overflow_error);
  CHECK_THROWS_AS(Rational(Integer{1} << 62) + Rational(Integer{1} << 62), std::overflow_error);
}

TEST_CASE("polynomials multiply, compare and print in the usual notation", "[proofs]") {
  CHECK((kX + kY) * (kX - kY) == kX * kX - kY * kY);
  CHECK((kX - kX) == Polynomial(0));
  CHECK((Polynomial(Rational(1, 2)) * kX * kX - kX * kY + 3).text({"L", "d"}) == "1/2 L^2 - L d + 3");
  CHECK(interpolate({1, 2, 4}, {0, 1, 9}) == (kX - 1) * (kX - 1));
  // (x - 1)(x + 2) and (x - 1)(x - 3).
  CHECK(greatest_common_divisor({-2, 1, 1}, {3, -4, 1}) == Coefficients{-1, 1});
  CHECK(remainder({-1, 0, 0, 0, 1}, {1, 0, 1}).empty());
  CHECK(text(Coefficients{-1, 0, 1}, "x") == "x^2 - 1");
}

TEST_CASE("linear systems: rank and inverse", "[proofs]") {
  CHECK(rank({{1, 2}, {2, 4}}) == 1);
  CHECK(inverse({{0, 2}, {2, 0}}) == RationalMatrix{{0, Rational(1, 2)}, {Rational(1, 2), 0}});
  CHECK_THROWS_AS(inverse({{1, 2}, {2, 4}}), std::domain_error);
}

TEST_CASE("vertices and lattice points of small polytopes", "[proofs]") {
  // x + y + z = 1 is the standard triangle. It has (L+1)(L+2)/2 points, and (L-1)(L-2)/2 of them are interior.
  const Polytope closed{IntegerMatrix::Ones(1, 3), IntegerVector::Ones(1), {false, false, false}};
  CHECK(vertices(closed) == std::vector<RationalVector>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
  const Polynomial half(Rational(1, 2));
  CHECK(counting_quasi_polynomial(closed, 1).by_residue.front() == half * (kX + 1) * (kX + 2));
  Polytope open = closed;
  open.strict.assign(3, true);
  CHECK(counting_quasi_polynomial(open, 1).by_residue.front() == half * (kX - 1) * (kX - 2));
  // 2 x + y = 1 has floor(L/2) + 1 points. So the period is 2, as the vertex (1/2, 0) shows.
  const Polytope segment{(IntegerMatrix(1, 2) << 2, 1).finished(), IntegerVector::Ones(1), {false, false}};
  CHECK(common_denominator(vertices(segment)) == 2);
  const QuasiPolynomial count = counting_quasi_polynomial(segment, 2);
  CHECK(count.by_residue[0] == half * kX + 1);
  CHECK(count.by_residue[1] == half * kX + half);
  // A system with a redundant row, and one with a contradictory row.
  const Polytope twice{
      (IntegerMatrix(2, 2) << 1, 1, 2, 2).finished(), (IntegerVector(2) << 1, 2).finished(), {true, true}};
  CHECK(count_lattice_points(twice, 5) == 4);
  const Polytope never{
      (IntegerMatrix(2, 2) << 1, 1, 2, 2).finished(), (IntegerVector(2) << 1, 3).finished(), {true, true}};
  CHECK(vertices(never).empty());
  CHECK(count_lattice_points(never, 5) == 0);
  // x - y = 1 is a ray.
  const Polytope ray{(IntegerMatrix(1, 2) << 1, -1).finished(), IntegerVector::Ones(1), {true, true}};
  CHECK_FALSE(surely_bounded(ray));
  CHECK_THROWS_AS(count_lattice_points(ray, 3), std::domain_error);
}

TEST_CASE("counting polynomials against brute force up to L = 60", "[proofs]") {
  for (const PairType type : {kDigon, kHexagon}) {
    const Polytope polygon = regular_polygon(type);
    const QuasiPolynomial counted = counting_quasi_polynomial(polygon, common_denominator(vertices(polygon)));
    for (Integer length = 1; length <= 60; ++length) {
      // Brute force: pairs d1 >= 1, d2 >= 0 for which other code finds only positive strip counts.
      Integer brute = 0;
      const PairSystem system(type);
      for (Integer d1 = 1; d1 <= length; ++d1) {
        for (Integer d2 = 0; d2 <= length; ++d2) {
          brute += static_cast<Integer>(
              system.solve_strips(IntegerVector::Constant(type.side_count(), length), d1, d2).size());
        }
      }
      REQUIRE(value(counted.at_residue(length), length) == brute);
      REQUIRE(type.rotation_count() * brute == (type == kDigon ? tau_digon(length) : tau_hexagon(length)));
    }
  }
  // Theorem 7.1 for a v8: pairs (a, b) with 1 <= a, b <= L - 1, from the circulant of order 8.
  for (Integer length = 1; length <= 60; ++length) {
    REQUIRE(static_cast<Integer>(solve_circulant(IntegerVector::Constant(8, length)).size()) ==
            value(single_vertex_premises().sharp_count, length));
  }
}

// Law proofs-2: a proof fails if its premises are false.
TEST_CASE("every proof fails on false premises", "[proofs]") {
  SECTION("T1") {
    SingleVertexPremises p = single_vertex_premises();
    p.symbol = {1, 1};  // E_i = e_{i-1} + e_i
    check_fails(prove_single_vertex(p));
    p = single_vertex_premises();
    p.symbol = {1, 1, 1};  // a third neighbour: period 3
    check_fails(prove_single_vertex(p));
    p = single_vertex_premises();
    p.sharp_count = kX * kX;
    check_fails(prove_single_vertex(p));
    p = single_vertex_premises();
    p.matrix = [](int l) { return (2 * PairSystem({l + 1, 3}).strip_matrix()).eval(); };
    check_fails(prove_single_vertex(p));
    p = single_vertex_premises();
    p.matrix = [matrix = p.matrix](int l) { return l == 4 ? (IntegerMatrix(-matrix(l))) : matrix(l); };
    check_fails(prove_single_vertex(p));
  }
  SECTION("T2 and T3") {
    for (const PairType type : {kDigon, kHexagon}) {
      const auto fails = [type](auto falsify) {
        RegularPremises p = regular_premises(type);
        falsify(p);
        check_fails(prove_regular_count(p));
      };
      const int factor = type.rotation_count();
      fails([&](RegularPremises& p) {
        p.tau = [=](const Polynomial& n, bool) { return factor * n * n; };
      });  // wrong for even L
      fails([&](RegularPremises& p) {
        p.tau = [=](const Polynomial& n, bool) { return factor * n * (n - 1); };
      });  // wrong for odd L
      fails([&](RegularPremises& p) {
        p.tau = [=](const Polynomial& n, bool even) { return factor * tau_from_half(n, even) + 1; };
      });
      fails([&](RegularPremises& p) {
        p.tau = [=](const Polynomial& n, bool even) { return (factor + 1) * tau_from_half(n, even); };
      });
      fails([](RegularPremises& p) { p.d1_positive = false; });  // (x,0) and (0,x) counted both, and the merged vertex
      fails([](RegularPremises& p) { p.d2_positive = true; });   // no aligned pair
      fails([](RegularPremises& p) { p.law.first(0) += 1; });    // another polygon
      fails([](RegularPremises& p) { p.law.last *= 2; });
      fails([](RegularPremises& p) { p.law.strips *= 2; });  // another lattice
      fails([](RegularPremises& p) { p.law.strips.row(0) = p.law.strips.row(1); });
      fails([](RegularPremises& p) { p.law.first = -p.law.first; });  // unbounded
    }
    RegularPremises mixed = regular_premises(kDigon);
    mixed.tau = regular_premises(kHexagon).tau;
    check_fails(prove_regular_count(mixed));
  }
  SECTION("T4") {
    const auto fails = [](auto falsify) {
      QuadPremises p = quad_premises();
      falsify(p);
      check_fails(prove_quad_count(p));
    };
    fails([](QuadPremises& p) { p.m = p.m + 1; });
    fails([](QuadPremises& p) { p.n = p.n + Polynomial::variable(4); });                          // E1 - 1
    fails([](QuadPremises& p) { p.n = Polynomial::variable(2) - Polynomial::variable(4) - 1; });  // E3 for E1
    fails([](QuadPremises& p) { std::swap(p.law.first, p.law.last); });
    fails([](QuadPremises& p) { p.law.first(0) = 0; });
    fails([](QuadPremises& p) { p.law.last = p.law.first; });
    fails([](QuadPremises& p) { p.law.strips(0, 1) = 2; });
  }
  SECTION("T11") {
    CrossingLaw of = crossing_law(kHexagon);
    of.law.strips.row(0) = of.law.strips.row(2);
    check_fails(prove_strips_determined({of}));
    of = crossing_law(kQuad);
    of.law.last = of.law.first;
    check_fails(prove_strips_determined({of}));
    of = crossing_law(kQuad);
    of.law.strips.row(1) = of.law.strips.row(3) = of.law.strips.row(0);
    check_fails(prove_strips_determined({of}));
    // The positions say nothing, or nothing of d1, or only the sum of d1 and d2.
    for (const PairType type : {kDigon, kHexagon, kQuad}) {
      of = crossing_law(type);
      of.positions.setZero();
      of.law.first.setZero();
      check_fails(prove_strips_determined({of}));
    }
    of = crossing_law(kDigon);
    of.positions.setZero();
    check_fails(prove_strips_determined({of}));
    of = crossing_law(kDigon);
    of.positions.col(1) = of.positions.col(0);
    check_fails(prove_strips_determined({of}));
  }
  SECTION("theory-5 as the proof of T11 takes it") {
    // By hand, for a digon with strips e1, e2: the first leg of v1 meets side 2 at e1, the second at E2 - e1 = d1 + d2 +
    // e1, the outward one meets side 1 at e2 + d1.
    const IntegerMatrix positions = crossing_law(kDigon).positions;
    REQUIRE(positions.rows() == 6);
    CHECK(positions.row(0) == sides({0, 0, 1, 0}).transpose());
    CHECK(positions.row(1) == sides({1, 1, 1, 0}).transpose());
    CHECK(positions.row(2) == sides({1, 0, 0, 1}).transpose());
  }
  SECTION("P3") {
    for (const PairType type : {kDigon, kHexagon, kQuad}) {
      FacePremises p = face_premises(type);
      p.stated = [stated = p.stated](const Polynomial& d1, const Polynomial& d2, Integer m, Integer n) {
        return stated(d1, d2, m, n) + 1;
      };
      check_fails(prove_face_change({p}));
      p = face_premises(type);
      p.stated = [stated = p.stated](const Polynomial& d1, const Polynomial& d2, Integer m, Integer n) {
        return stated(d1, d2, n, m);
      };
      check_fails(prove_face_change({p}));
      p = face_premises(type);
      p.faces = [faces = p.faces](const Polynomial& d1, const Polynomial& d2, const std::vector<Polynomial>& e) {
        return faces(d1, d2, e) + d1 * e[0];
      };
      check_fails(prove_face_change({p}));
    }
  }
  SECTION("N1 and N2") {
    SideLaw law = side_law(kQuad);
    law.last = law.first;
    check_fails(prove_no_cancelling(law));
    law = side_law(kQuad);
    law.strips(0, 0) = 1;
    check_fails(prove_no_cancelling(law));
    law = side_law(kDigon);
    law.first *= 2;
    check_fails(prove_merging_parity({law}));
    law = side_law(kHexagon);
    law.strips.row(0) *= 2;
    check_fails(prove_merging_parity({law}));
  }
}
