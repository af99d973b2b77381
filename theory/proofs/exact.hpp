// Exact arithmetic for proofs: rational numbers, polynomials with rational coefficients, linear systems.
//
// proofs-1   Nothing here rounds. A result that does not fit 64 bits throws std::overflow_error, so an equality that is
//            found is true.
//
// The systems are the paper's: a dozen unknowns, coefficients 0, 1 and 2. Their numbers stay tiny, and nothing here is
// tuned for larger ones.
#pragma once

#include <compare>
#include <map>
#include <string>
#include <vector>

#include "theory/pair_system.hpp"

namespace requad::theory {

// A fraction in lowest terms, with a positive denominator.
class Rational {
 public:
  Rational() = default;
  Rational(Integer value) : numerator_(value) {}  // NOLINT(google-explicit-constructor): an integer is a fraction
  Rational(int value) : numerator_(value) {}      // NOLINT(google-explicit-constructor)
  // Precondition: denominator is not 0.
  Rational(Integer numerator, Integer denominator);

  Integer numerator() const { return numerator_; }
  Integer denominator() const { return denominator_; }
  bool is_integer() const { return denominator_ == 1; }
  // True for half an odd integer.
  bool is_odd_half() const { return denominator_ == 2; }
  // The greatest integer that is not greater than the fraction.
  Integer floor() const;
  // "-3/2".
  std::string text() const;

  Rational operator-() const { return Rational(0) - *this; }
  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  // Precondition: b is not 0.
  friend Rational operator/(const Rational& a, const Rational& b);
  Rational& operator+=(const Rational& b) { return *this = *this + b; }
  Rational& operator-=(const Rational& b) { return *this = *this - b; }
  Rational& operator*=(const Rational& b) { return *this = *this * b; }
  Rational& operator/=(const Rational& b) { return *this = *this / b; }
  friend bool operator==(const Rational&, const Rational&) = default;
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) { return (a - b).numerator_ <=> 0; }

 private:
  Integer numerator_ = 0;
  Integer denominator_ = 1;
};

using RationalVector = std::vector<Rational>;
using RationalMatrix = std::vector<RationalVector>;  // rows

// A polynomial in x_0, x_1, ... No zero term is stored, so equal polynomials are equal objects.
class Polynomial {
 public:
  Polynomial() = default;
  Polynomial(Rational constant);  // NOLINT(google-explicit-constructor): a number is a polynomial
  Polynomial(Integer constant) : Polynomial(Rational(constant)) {}  // NOLINT(google-explicit-constructor)
  Polynomial(int constant) : Polynomial(Rational(constant)) {}      // NOLINT(google-explicit-constructor)
  static Polynomial variable(std::size_t index);

  // The coefficient of the term with these exponents. Trailing zeros may be left out.
  Rational coefficient(std::vector<int> exponents) const;
  bool is_constant() const;

  Polynomial& operator+=(const Polynomial& other);
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
  friend Polynomial operator-(const Polynomial& a) { return Polynomial(-1) * a; }
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + -b; }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend bool operator==(const Polynomial&, const Polynomial&) = default;

  // "1/2 L^2 - L": terms of highest degree first, with names[i] for x_i.
  std::string text(const std::vector<std::string>& names) const;

 private:
  std::map<std::vector<int>, Rational> terms_;  // exponents without trailing zeros -> coefficient, never 0
};

// The polynomial f in x_0 of least degree with f(at[i]) = values[i]. Precondition: the entries of `at` are distinct.
Polynomial interpolate(const std::vector<Integer>& at, const std::vector<Integer>& values);

// A polynomial in one variable as its coefficients, the constant first. The last one is not 0; {} is the polynomial 0.
using Coefficients = std::vector<Rational>;
// The remainder of a divided by b. Precondition: b is not 0.
Coefficients remainder(Coefficients a, const Coefficients& b);
// The monic greatest common divisor, by Euclid. Precondition: a and b are not both 0.
Coefficients greatest_common_divisor(Coefficients a, Coefficients b);
std::string text(const Coefficients& p, const std::string& variable);

RationalMatrix to_rational(const IntegerMatrix& matrix);
int rank(RationalMatrix matrix);
// The inverse. Throws std::domain_error if there is none. Precondition: square.
RationalMatrix inverse(const RationalMatrix& matrix);
RationalVector operator*(const RationalMatrix& matrix, const RationalVector& v);

}  // namespace requad::theory
