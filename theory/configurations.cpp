#include "theory/configurations.hpp"

#include <algorithm>
#include <cassert>

namespace requad::theory {

namespace {

bool lexicographically_less(const IntegerVector& a, const IntegerVector& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace

bool operator==(const Configuration& a, const Configuration& b) {
  return a.p == b.p && a.d1() == b.d1() && a.d2() == b.d2() && a.parameters.e == b.parameters.e;
}

bool operator<(const Configuration& a, const Configuration& b) {
  if (a.p != b.p) return a.p < b.p;
  if (a.d1() != b.d1()) return a.d1() < b.d1();
  if (a.d2() != b.d2()) return a.d2() < b.d2();
  return lexicographically_less(a.parameters.e, b.parameters.e);
}

GridPoint grid_point(PairType type, const Configuration& c) {
  if (type.side_count() % 4 == 0) return {c.parameters.e(0), c.parameters.e(1)};
  return {c.d1(), c.d2()};
}

std::string label(PairType type, const Configuration& c) { return label(type, grid_point(type, c), c.p); }

std::string label(PairType type, const GridPoint& at, int p) {
  const bool merged = at == GridPoint{0, 0};
  std::string text = "(" + std::to_string(at.m) + "," + std::to_string(at.n);
  if (type.has_third_index() && !merged) text += "," + std::to_string(p);
  return text + ")";
}

std::string parameters_problem(PairType type, const StripParameters& p) {
  const int k = type.side_count();
  const auto in_range = [](Integer x, Integer low) { return low <= x && x <= kMaxLength; };
  if (!in_range(p.d1, 0) || !in_range(p.d2, 0)) {
    return "d1, d2 = " + std::to_string(p.d1) + ", " + std::to_string(p.d2) + " are not in 0.." +
           std::to_string(kMaxLength);
  }
  if (p.d1 == 0 && p.d2 == 0) return "d1 = d2 = 0 is the merged vertex, not a pair";
  if (p.e.size() != k) {
    return "a " + type.name() + " pair has " + std::to_string(k) + " strip counts e1.." + "e" + std::to_string(k) +
           ", not " + std::to_string(p.e.size());
  }
  for (const Integer e : p.e) {
    if (!in_range(e, 1)) {
      return "strip count " + std::to_string(e) + " is not in 1.." + std::to_string(kMaxLength) +
             " (with 0 an irregular vertex would lie on the boundary)";
    }
  }
  return "";
}

Configuration other_labelling(PairType type, const Configuration& c) {
  assert(c.degenerate() && !c.merged());
  const int k = type.side_count();
  const int shift = c.d2() == 0 ? 1 : -1;  // (d,0,p) -> (0,d,p+1), and back
  Configuration other;
  other.parameters = {c.d2(), c.d1(), rotated(c.parameters.e, shift)};
  other.p = (c.p - 1 + shift + k) % k + 1;
  if (type.symmetric() && other.p > k / 2) {
    other.p -= k / 2;
    other.parameters.e = rotated(other.parameters.e, k / 2);
  }
  return other;
}

Configuration canonical(PairType type, Configuration c) {
  const int k = type.side_count();
  if (c.merged()) {
    c.parameters.e = rotated(c.parameters.e, 1 - c.p);
    c.p = 1;
    return c;
  }
  if (type.symmetric() && c.p > k / 2) {
    c.p -= k / 2;
    c.parameters.e = rotated(c.parameters.e, k / 2);
  }
  return c.d1() == 0 ? other_labelling(type, c) : c;
}

IntegerVector region_sides(PairType type, const Configuration& c) {
  return rotated(PairSystem(type).side_lengths(c.parameters), 1 - c.p);
}

namespace {

// The largest d that fits beside two strips on every side whose length d adds to.
Integer longest(const IntegerVector& sides, const IntegerVector& offset) {
  Integer bound = kMaxLength;
  for (Eigen::Index i = 0; i < sides.size(); ++i) {
    if (offset(i) > 0) bound = std::min(bound, sides(i) - 2);
  }
  return bound;
}

}  // namespace

std::vector<Configuration> parameter_set(const RegionShape& shape) {
  const PairSystem& system = shape.system();
  std::vector<Configuration> found;
  for (int p = 1; p <= shape.type().rotation_count(); ++p) {
    const IntegerVector& labelled = shape.labelled_sides(p);
    const Integer d1_end = longest(labelled, system.first_offset());
    const Integer d2_end = longest(labelled, system.last_offset());
    for (Integer d1 = 1; d1 <= d1_end; ++d1) {  // d1 = 0 is the other labelling of d2 = 0
      for (Integer d2 = 0; d2 <= d2_end; ++d2) {
        for (IntegerVector& e : system.solve_strips(labelled, d1, d2)) {
          found.push_back({{d1, d2, std::move(e)}, p});
        }
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Configuration> merged_configurations(const RegionShape& shape) {
  std::vector<Configuration> found;
  if (!shape.type().symmetric()) return found;
  for (IntegerVector& e : solve_circulant(shape.sides())) found.push_back({{0, 0, std::move(e)}, 1});
  return found;
}

}  // namespace requad::theory
