#include "theory/proofs/polytope.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace requad::theory {

namespace {

// A largest independent set of rows of A. Where A x = b has a solution, these rows alone have the same solutions.
std::vector<Eigen::Index> spanning_rows(const IntegerMatrix& a) {
  std::vector<Eigen::Index> rows;
  RationalMatrix chosen;
  const RationalMatrix all = to_rational(a);
  for (Eigen::Index r = 0; r < a.rows(); ++r) {
    chosen.push_back(all[static_cast<std::size_t>(r)]);
    if (rank(chosen) == static_cast<int>(chosen.size())) {
      rows.push_back(r);
    } else {
      chosen.pop_back();
    }
  }
  return rows;
}

// The columns of some unknowns, inverted: it solves A x = b for these (the basic ones) once the others are given.
class Basis {
 public:
  // Returns nothing if the columns are dependent. Precondition: there are as many columns as rows.
  static std::optional<Basis> of(const Polytope& p, const std::vector<Eigen::Index>& rows,
                                 std::vector<Eigen::Index> columns) {
    RationalMatrix square(rows.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
      for (const Eigen::Index c : columns) square[r].emplace_back(p.a(rows[r], c));
    }
    if (rank(square) < static_cast<int>(rows.size())) return std::nullopt;
    Basis basis(p);
    basis.rows_ = rows;
    basis.columns_ = std::move(columns);
    basis.inverse_ = inverse(square);
    for (Eigen::Index c = 0; c < p.a.cols(); ++c) {
      if (!std::binary_search(basis.columns_.begin(), basis.columns_.end(), c)) basis.free_.push_back(c);
    }
    return basis;
  }

  const std::vector<Eigen::Index>& free() const { return free_; }

  // The x with A x = L b and these values of the free unknowns. Returns nothing if it violates a row outside rows_.
  std::optional<RationalVector> solve(Integer dilation, const std::vector<Integer>& free_values) const {
    RationalVector rhs;
    for (const Eigen::Index r : rows_) {
      Rational value = Rational(dilation) * p_->b(r);
      for (std::size_t i = 0; i < free_.size(); ++i) value -= Rational(p_->a(r, free_[i])) * free_values[i];
      rhs.push_back(value);
    }
    const RationalVector basic = inverse_ * rhs;
    RationalVector x(static_cast<std::size_t>(p_->a.cols()), 0);
    for (std::size_t i = 0; i < columns_.size(); ++i) x[static_cast<std::size_t>(columns_[i])] = basic[i];
    for (std::size_t i = 0; i < free_.size(); ++i) x[static_cast<std::size_t>(free_[i])] = free_values[i];
    const RationalVector image = to_rational(p_->a) * x;
    for (Eigen::Index r = 0; r < p_->b.size(); ++r) {
      if (image[static_cast<std::size_t>(r)] != Rational(dilation) * p_->b(r)) return std::nullopt;
    }
    return x;
  }

 private:
  explicit Basis(const Polytope& p) : p_(&p) {}

  const Polytope* p_;
  std::vector<Eigen::Index> rows_;
  std::vector<Eigen::Index> columns_;  // basic, sorted
  std::vector<Eigen::Index> free_;
  RationalMatrix inverse_;
};

// Calls visit(basis) for every basis of the system of P, until it returns true.
template <class Visit>
void for_each_basis(const Polytope& p, Visit&& visit) {
  const std::vector<Eigen::Index> rows = spanning_rows(p.a);
  std::vector<bool> chosen(static_cast<std::size_t>(p.a.cols()), false);
  std::fill_n(chosen.begin(), rows.size(), true);
  do {
    std::vector<Eigen::Index> columns;
    for (std::size_t c = 0; c < chosen.size(); ++c) {
      if (chosen[c]) columns.push_back(static_cast<Eigen::Index>(c));
    }
    const auto basis = Basis::of(p, rows, std::move(columns));
    if (basis && visit(*basis)) return;
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
}

}  // namespace

bool surely_bounded(const Polytope& p) {
  if (p.a.size() == 0 || p.a.minCoeff() < 0) return false;
  for (Eigen::Index c = 0; c < p.a.cols(); ++c) {
    if (p.a.col(c).maxCoeff() <= 0) return false;
  }
  return true;
}

int dimension_bound(const Polytope& p) { return static_cast<int>(p.a.cols()) - rank(to_rational(p.a)); }

std::vector<RationalVector> vertices(const Polytope& p) {
  std::vector<RationalVector> found;
  for_each_basis(p, [&](const Basis& basis) {
    auto x = basis.solve(1, std::vector<Integer>(basis.free().size(), 0));
    if (x && std::all_of(x->begin(), x->end(), [](const Rational& v) { return v >= 0; })) {
      found.push_back(std::move(*x));
    }
    return false;
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Integer common_denominator(const std::vector<RationalVector>& points) {
  Integer multiple = 1;
  for (const RationalVector& point : points) {
    for (const Rational& x : point) multiple = std::lcm(multiple, x.denominator());
  }
  return multiple;
}

Integer count_lattice_points(const Polytope& p, Integer dilation) {
  if (!surely_bounded(p)) throw std::domain_error("the polytope may be unbounded");
  const std::vector<RationalVector> corners = vertices(p);
  Integer count = 0;
  for_each_basis(p, [&](const Basis& basis) {
    // The free unknowns run over the integers of the dilated box.
    std::vector<Integer> low, high;
    for (const Eigen::Index c : basis.free()) {
      const auto at = [c](const RationalVector& x) { return x[static_cast<std::size_t>(c)]; };
      Rational least = corners.empty() ? Rational(0) : at(corners.front());
      Rational most = least;
      for (const RationalVector& x : corners) least = std::min(least, at(x)), most = std::max(most, at(x));
      least *= dilation, most *= dilation;
      low.push_back(least.floor());
      high.push_back(most.floor());
    }
    std::vector<Integer> values = low;
    for (;;) {
      const auto x = basis.solve(dilation, values);
      bool inside = x.has_value();
      for (std::size_t j = 0; inside && j < x->size(); ++j) {
        inside = (*x)[j].is_integer() && (p.strict[j] ? (*x)[j] > 0 : (*x)[j] >= 0);
      }
      count += inside ? 1 : 0;
      std::size_t i = 0;
      while (i < values.size() && values[i] == high[i]) values[i] = low[i], ++i;
      if (i == values.size()) break;
      ++values[i];
    }
    return true;  // one basis is enough
  });
  return count;
}

QuasiPolynomial counting_quasi_polynomial(const Polytope& p, Integer period) {
  QuasiPolynomial result;
  const int degree = dimension_bound(p);
  for (Integer residue = 0; residue < period; ++residue) {
    std::vector<Integer> lengths, counts;
    for (Integer length = residue == 0 ? period : residue; static_cast<int>(lengths.size()) <= degree;
         length += period) {
      lengths.push_back(length);
      counts.push_back(count_lattice_points(p, length));
    }
    result.by_residue.push_back(interpolate(lengths, counts));
    result.samples.insert(result.samples.end(), lengths.begin(), lengths.end());
  }
  std::sort(result.samples.begin(), result.samples.end());
  return result;
}

}  // namespace requad::theory
