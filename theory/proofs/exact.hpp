// Exact arithmetic for proofs: rational numbers, polynomials with such coefficients, linear systems.
//
// Law 6   nothing here rounds, and what does not fit 64 bits throws std::overflow_error: an equality that it finds is
// one. The systems are the paper's (a dozen unknowns, coefficients 0, 1 and 2), whose numbers stay tiny; nothing is
// tuned for more.
#pragma once

#include <compare>
#include <map>
#include <string>
#include <vector>

#include "theory/pair_system.hpp"

namespace requad::theory {

// A fraction in lowest terms, its denominator positive.
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
  // Half an odd integer.
  bool is_odd_half() const { return denominator_ == 2; }
  // The greatest integer that is not above it.
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

// A polynomial in x_0, x_1, ..., kept without zero terms: equal polynomials are equal objects.
class Polynomial {
 public:
  Polynomial() = default;
  Polynomial(Rational constant);  // NOLINT(google-explicit-constructor): a number is a polynomial
  Polynomial(Integer constant) : Polynomial(Rational(constant)) {}  // NOLINT(google-explicit-constructor)
  Polynomial(int constant) : Polynomial(Rational(constant)) {}      // NOLINT(google-explicit-constructor)
  static Polynomial variable(std::size_t index);

  // Of one term, by its exponents (trailing zeros may be left out).
  Rational coefficient(std::vector<int> exponents) const;
  bool is_constant() const;

  Polynomial& operator+=(const Polynomial& other);
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
  friend Polynomial operator-(const Polynomial& a) { return Polynomial(-1) * a; }
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + -b; }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend bool operator==(const Polynomial&, const Polynomial&) = default;

  // "1/2 L^2 - L", highest terms first; names[i] is how x_i is written.
  std::string text(const std::vector<std::string>& names) const;

 private:
  std::map<std::vector<int>, Rational> terms_;  // exponents without trailing zeros -> coefficient, never 0
};

// The polynomial in x_0 of least degree through these points. Precondition: the arguments are distinct.
Polynomial interpolate(const std::vector<Integer>& at, const std::vector<Integer>& values);

// Polynomials in one variable as coefficient lists, constant first, leading coefficient not 0; {} is 0.
using Coefficients = std::vector<Rational>;
// Remainder of a by b. Precondition: b is not 0.
Coefficients remainder(Coefficients a, const Coefficients& b);
// Monic greatest common divisor, by Euclid. Precondition: not both 0.
Coefficients greatest_common_divisor(Coefficients a, Coefficients b);
std::string text(const Coefficients& p, const std::string& variable);

RationalMatrix to_rational(const IntegerMatrix& matrix);
int rank(RationalMatrix matrix);
// The inverse. Throws std::domain_error if there is none. Precondition: square.
RationalMatrix inverse(const RationalMatrix& matrix);
RationalVector operator*(const RationalMatrix& matrix, const RationalVector& v);

}  // namespace requad::theory
