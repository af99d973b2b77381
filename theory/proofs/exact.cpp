#include "theory/proofs/exact.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <stdexcept>

namespace requad::theory {

namespace {

Integer sum(Integer a, Integer b) {
  Integer result = 0;
  if (__builtin_add_overflow(a, b, &result)) throw std::overflow_error("a sum beyond 64 bits");
  return result;
}

Integer product(Integer a, Integer b) {
  Integer result = 0;
  if (__builtin_mul_overflow(a, b, &result)) throw std::overflow_error("a product beyond 64 bits");
  return result;
}

}  // namespace

Rational::Rational(Integer numerator, Integer denominator) {
  assert(denominator != 0);
  const Integer common = std::gcd(numerator, denominator) * (denominator < 0 ? -1 : 1);
  numerator_ = numerator / common;
  denominator_ = denominator / common;
}

Rational operator+(const Rational& a, const Rational& b) {
  return {sum(product(a.numerator_, b.denominator_), product(b.numerator_, a.denominator_)),
          product(a.denominator_, b.denominator_)};
}

Rational operator-(const Rational& a, const Rational& b) {
  return a + Rational(product(b.numerator_, -1), b.denominator_);
}

Rational operator*(const Rational& a, const Rational& b) {
  return {product(a.numerator_, b.numerator_), product(a.denominator_, b.denominator_)};
}

Rational operator/(const Rational& a, const Rational& b) {
  return {product(a.numerator_, b.denominator_), product(a.denominator_, b.numerator_)};
}

Integer Rational::floor() const {
  const Integer quotient = numerator_ / denominator_;
  return numerator_ % denominator_ < 0 ? quotient - 1 : quotient;
}

std::string Rational::text() const {
  return std::to_string(numerator_) + (is_integer() ? "" : "/" + std::to_string(denominator_));
}

Polynomial::Polynomial(Rational constant) {
  if (constant != 0) terms_.emplace(std::vector<int>{}, constant);
}

Polynomial Polynomial::variable(std::size_t index) {
  Polynomial p;
  std::vector<int> exponents(index + 1, 0);
  exponents[index] = 1;
  p.terms_.emplace(std::move(exponents), 1);
  return p;
}

Rational Polynomial::coefficient(std::vector<int> exponents) const {
  while (!exponents.empty() && exponents.back() == 0) exponents.pop_back();
  const auto it = terms_.find(exponents);
  return it == terms_.end() ? Rational(0) : it->second;
}

bool Polynomial::is_constant() const { return terms_.empty() || (terms_.size() == 1 && terms_.begin()->first.empty()); }

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  for (const auto& [exponents, c] : other.terms_) {
    const auto it = terms_.emplace(exponents, 0).first;
    it->second += c;
    if (it->second == 0) terms_.erase(it);
  }
  return *this;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [x, c] : a.terms_) {
    for (const auto& [y, d] : b.terms_) {
      std::vector<int> exponents(std::max(x.size(), y.size()), 0);
      for (std::size_t i = 0; i < x.size(); ++i) exponents[i] += x[i];
      for (std::size_t i = 0; i < y.size(); ++i) exponents[i] += y[i];
      Polynomial term;
      term.terms_.emplace(std::move(exponents), c * d);
      result += term;
    }
  }
  return result;
}

namespace {

// Appends "+ c factors". The sign stands between the terms, and a coefficient 1 is left out.
void append_term(std::string& out, const Rational& c, const std::string& factors) {
  out += out.empty() ? (c < 0 ? "-" : "") : (c < 0 ? " - " : " + ");
  const Rational size = c < 0 ? -c : c;
  if (factors.empty()) {
    out += size.text();
  } else {
    out += (size == 1 ? "" : size.text() + " ") + factors;
  }
}

std::string power(const std::string& name, int exponent) {
  return exponent == 1 ? name : name + "^" + std::to_string(exponent);
}

}  // namespace

std::string Polynomial::text(const std::vector<std::string>& names) const {
  std::vector<const std::pair<const std::vector<int>, Rational>*> order;
  for (const auto& term : terms_) order.push_back(&term);
  const auto degree = [](const std::vector<int>& exponents) {
    return std::accumulate(exponents.begin(), exponents.end(), 0);
  };
  std::sort(order.begin(), order.end(), [&](const auto* a, const auto* b) {
    const int da = degree(a->first);
    const int db = degree(b->first);
    return da != db ? da > db : a->first > b->first;
  });
  std::string out;
  for (const auto* term : order) {
    std::string factors;
    for (std::size_t i = 0; i < term->first.size(); ++i) {
      if (term->first[i] > 0) factors += (factors.empty() ? "" : " ") + power(names.at(i), term->first[i]);
    }
    append_term(out, term->second, factors);
  }
  return out.empty() ? "0" : out;
}

Polynomial interpolate(const std::vector<Integer>& at, const std::vector<Integer>& values) {
  assert(at.size() == values.size());
  const Polynomial x = Polynomial::variable(0);
  Polynomial through;
  for (std::size_t i = 0; i < at.size(); ++i) {
    Polynomial basis = values[i];
    for (std::size_t j = 0; j < at.size(); ++j) {
      if (j != i) basis = basis * (x - at[j]) * Polynomial(Rational(1, at[i] - at[j]));
    }
    through += basis;
  }
  return through;
}

Coefficients remainder(Coefficients a, const Coefficients& b) {
  assert(!b.empty());
  while (a.size() >= b.size()) {
    const Rational factor = a.back() / b.back();
    const std::size_t shift = a.size() - b.size();
    for (std::size_t i = 0; i < b.size(); ++i) a[shift + i] -= factor * b[i];
    while (!a.empty() && a.back() == 0) a.pop_back();
  }
  return a;
}

Coefficients greatest_common_divisor(Coefficients a, Coefficients b) {
  while (!b.empty()) {
    Coefficients r = remainder(std::move(a), b);
    a = std::move(b);
    b = std::move(r);
  }
  const Rational leading = a.back();
  for (Rational& c : a) c /= leading;
  return a;
}

std::string text(const Coefficients& p, const std::string& variable) {
  std::string out;
  for (std::size_t i = p.size(); i-- > 0;) {
    if (p[i] != 0) append_term(out, p[i], i == 0 ? "" : power(variable, static_cast<int>(i)));
  }
  return out.empty() ? "0" : out;
}

RationalMatrix to_rational(const IntegerMatrix& matrix) {
  RationalMatrix result(static_cast<std::size_t>(matrix.rows()));
  for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
    for (Eigen::Index c = 0; c < matrix.cols(); ++c) result[static_cast<std::size_t>(r)].emplace_back(matrix(r, c));
  }
  return result;
}

namespace {

// Gauss-Jordan elimination on the first `columns` columns, in place. Returns the number of pivots.
int reduce(RationalMatrix& m, std::size_t columns) {
  std::size_t pivots = 0;
  for (std::size_t c = 0; c < columns && pivots < m.size(); ++c) {
    std::size_t row = pivots;
    while (row < m.size() && m[row][c] == 0) ++row;
    if (row == m.size()) continue;
    std::swap(m[row], m[pivots]);
    const Rational leading = m[pivots][c];
    for (Rational& x : m[pivots]) x /= leading;
    for (std::size_t r = 0; r < m.size(); ++r) {
      if (r == pivots || m[r][c] == 0) continue;
      const Rational factor = m[r][c];
      for (std::size_t k = 0; k < m[r].size(); ++k) m[r][k] -= factor * m[pivots][k];
    }
    ++pivots;
  }
  return static_cast<int>(pivots);
}

}  // namespace

int rank(RationalMatrix matrix) {
  const std::size_t columns = matrix.empty() ? 0 : matrix.front().size();
  return reduce(matrix, columns);
}

RationalMatrix inverse(const RationalMatrix& matrix) {
  const std::size_t n = matrix.size();
  RationalMatrix work = matrix;
  for (std::size_t i = 0; i < n; ++i) {
    work[i].resize(2 * n, 0);
    work[i][n + i] = 1;
  }
  if (reduce(work, n) < static_cast<int>(n)) throw std::domain_error("a singular matrix has no inverse");
  for (RationalVector& row : work) row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(n));
  return work;
}

RationalVector operator*(const RationalMatrix& matrix, const RationalVector& v) {
  RationalVector result;
  for (const RationalVector& row : matrix) {
    Rational value = 0;
    for (std::size_t i = 0; i < v.size(); ++i) value += row[i] * v[i];
    result.push_back(value);
  }
  return result;
}

}  // namespace requad::theory
