#include "theory/pair_system.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <limits>
#include <numeric>
#include <system_error>

namespace requad::theory {

std::string PairType::name() const { return std::to_string(l2) + "-" + std::to_string(l1); }

std::optional<PairType> pair_type(std::string_view name) {
  const std::size_t dash = std::min(name.find('-'), name.size());
  std::array<int, 2> valences{};
  const std::array texts{name.substr(0, dash), name.substr(std::min(dash + 1, name.size()))};
  for (std::size_t i = 0; i < 2; ++i) {
    const char* const last = texts[i].data() + texts[i].size();
    const auto [end, error] = std::from_chars(texts[i].data(), last, valences[i]);
    if (error != std::errc() || end != last || valences[i] < 3 || valences[i] > 100 || valences[i] == 4)
      return std::nullopt;
  }
  return PairType{std::max(valences[0], valences[1]), std::min(valences[0], valences[1])};
}

IntegerVector rotated(const IntegerVector& v, Eigen::Index by) {
  const Eigen::Index k = v.size();
  IntegerVector result(k);
  for (Eigen::Index i = 0; i < k; ++i) result(i) = v((i + by % k + k) % k);
  return result;
}

PairSystem::PairSystem(PairType type) : type_(type) {
  assert(type.l1 >= type.l2 && type.l2 >= 3);
  const int k = type.side_count();
  strips_ = IntegerMatrix::Zero(k, k);
  for (int i = 0; i < k; ++i) {
    strips_(i, (i + k - 1) % k) += 1;
    strips_(i, (i + 1) % k) += 1;
  }
  first_ = IntegerVector::Zero(k);
  last_ = IntegerVector::Zero(k);
  const int outward1 = type.l1 - 2;
  first_(0) += 1;
  last_(outward1 - 1) += 1;
  first_(outward1) += 1;
  last_(k - 1) += 1;
}

IntegerVector PairSystem::side_lengths(const StripParameters& p) const {
  assert(p.e.size() == type_.side_count());
  return strips_ * p.e + p.d1 * first_ + p.d2 * last_;
}

std::vector<IntegerVector> PairSystem::solve_strips(const IntegerVector& sides, Integer d1, Integer d2) const {
  return solve_circulant(sides - d1 * first_ - d2 * last_);
}

Integer PairSystem::face_count(const StripParameters& p) const {
  return face_formula<Integer>(p.d1, p.d2, {p.e.begin(), p.e.end()});
}

namespace {

// Along one cycle i0, i0+2, i0+4, ... of the indices, every e is value + sign * t for one unknown t = e(i0).
struct Chain {
  std::vector<Eigen::Index> index;
  std::vector<Integer> value;
  std::vector<Integer> candidates;  // the t that make all e of the cycle >= 1
};

Chain solve_chain(const IntegerVector& c, Eigen::Index start) {
  const Eigen::Index k = c.size();
  Chain chain;
  Integer value = 0;
  Integer sign = 1;
  Integer low = 1;
  Integer high = std::numeric_limits<Integer>::max();
  Eigen::Index i = start;
  do {
    chain.index.push_back(i);
    chain.value.push_back(value);
    if (sign > 0) {
      low = std::max(low, 1 - value);
    } else {
      high = std::min(high, value - 1);
    }
    value = c((i + 1) % k) - value;  // e_{i+2} = c_{i+1} - e_i
    sign = -sign;
    i = (i + 2) % k;
  } while (i != start);
  // Back at the start: t = value + sign * t.
  if (sign < 0) {
    if (value % 2 == 0 && low <= value / 2 && value / 2 <= high) chain.candidates.push_back(value / 2);
  } else if (value == 0) {
    for (Integer t = low; t <= high; ++t) chain.candidates.push_back(t);
  }
  return chain;
}

}  // namespace

std::vector<IntegerVector> solve_circulant(const IntegerVector& c) {
  const Eigen::Index k = c.size();
  assert(k >= 1);
  std::vector<IntegerVector> solutions{IntegerVector::Zero(k)};
  const Eigen::Index cycles = std::gcd(k, Eigen::Index{2});
  for (Eigen::Index start = 0; start < cycles; ++start) {
    const Chain chain = solve_chain(c, start);
    std::vector<IntegerVector> extended;
    extended.reserve(solutions.size() * chain.candidates.size());
    for (const IntegerVector& partial : solutions) {
      for (const Integer t : chain.candidates) {
        IntegerVector e = partial;
        for (std::size_t j = 0; j < chain.index.size(); ++j) {
          e(chain.index[j]) = chain.value[j] + (j % 2 == 0 ? t : -t);
        }
        extended.push_back(std::move(e));
      }
    }
    solutions = std::move(extended);
  }
  std::sort(solutions.begin(), solutions.end(), [](const IntegerVector& a, const IntegerVector& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  return solutions;
}

Integer determinant(IntegerMatrix m) {
  assert(m.rows() == m.cols());
  const Eigen::Index n = m.rows();
  Integer sign = 1;
  Integer previous = 1;
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    if (m(i, i) == 0) {
      Eigen::Index pivot = i + 1;
      while (pivot < n && m(pivot, i) == 0) ++pivot;
      if (pivot == n) return 0;
      m.row(i).swap(m.row(pivot));
      sign = -sign;
    }
    for (Eigen::Index r = i + 1; r < n; ++r) {
      for (Eigen::Index col = i + 1; col < n; ++col) {
        m(r, col) = (m(r, col) * m(i, i) - m(r, i) * m(i, col)) / previous;
      }
    }
    previous = m(i, i);
  }
  return n == 0 ? 1 : sign * m(n - 1, n - 1);
}

}  // namespace requad::theory
