#include "theory/separatrix_vector.hpp"

#include <algorithm>
#include <stdexcept>

namespace requad::theory {

namespace {

std::size_t slot(int i) { return static_cast<std::size_t>(i); }

// Label indices are 0-based here and taken modulo k.
struct Frame {
  PairType type;
  const IntegerVector& sides;
  int k;

  // The region's side that a label lies on.
  int side(const Labelling& l, int label) const { return (label + l.p - 1 + k) % k; }
  Integer length(const Labelling& l, int label) const { return sides(side(l, label)); }
  Integer e(const Labelling& l, int label) const { return l.e[slot((label + k) % k)]; }
};

}  // namespace

Labelling to_labelling(const Configuration& c) {
  Labelling labelling{c.p, c.d1(), c.d2(), {}};
  if (c.parameters.e.size() > kMostSides) throw std::invalid_argument("too many sides for a labelling");
  std::copy(c.parameters.e.begin(), c.parameters.e.end(), labelling.e.begin());
  return labelling;
}

Configuration to_configuration(PairType type, const Labelling& labelling) {
  Configuration c{{labelling.d1, labelling.d2, IntegerVector(type.side_count())}, labelling.p};
  for (int i = 0; i < type.side_count(); ++i) c.parameters.e(i) = labelling.e[slot(i)];
  return c;
}

SeparatrixVector separatrix_vector(const RegionShape& shape, const Labelling& l) {
  const PairType type = shape.type();
  const Frame frame{type, shape.sides(), type.side_count()};
  // Labels of the first and last outward separatrices of v1 and v2.
  const std::array<int, 2> first{0, type.l1 - 2};
  const std::array<int, 2> last{type.l1 - 3, frame.k - 1};
  SeparatrixVector vector;
  for (const int v : {0, 1}) {
    auto& at = v == 0 ? vector.at_v1 : vector.at_v2;
    const int f = first[slot(1 - v)];
    const int g = last[slot(1 - v)];
    at[0] = {frame.side(l, f), frame.e(l, f - 1), l.d2 + frame.e(l, f)};
    at[1] = {frame.side(l, g), frame.length(l, g) - frame.e(l, g + 1), l.d1 + frame.e(l, g)};
    if (l.d1 == 0) at[0] = {-1, -1, l.d2};
    if (l.d2 == 0) at[1] = {-1, -1, l.d1};
    for (int i = first[slot(v)]; i <= last[slot(v)]; ++i) {
      const Integer before = frame.e(l, i - 1) + (i == first[slot(v)] ? l.d1 : 0);
      at[slot(2 + i - first[slot(v)])] = {frame.side(l, i), before, frame.e(l, i)};
    }
  }
  return vector;
}

namespace {

// The labelling with these first legs, read off the crossings by theory-6. The caller checks that it has this vector.
std::optional<Labelling> read(const Frame& frame, std::span<const Crossing> at_v1, int leg1,
                              std::span<const Crossing> at_v2, int leg2) {
  const int k = frame.k;
  const auto at = [](std::span<const Crossing> crossings, int leg, int i) -> const Crossing& {
    const int n = static_cast<int>(crossings.size());
    const int wrapped = leg + i;
    return crossings[slot(wrapped < n ? wrapped : wrapped - n)];
  };
  const Crossing& start = at(at_v1, leg1, 2);
  if (start.side < 0) return std::nullopt;
  Labelling l;
  l.p = start.side + 1;
  const int n1 = frame.type.l1 - 2;
  const auto outward = [&](int i) -> const Crossing& {
    return i < n1 ? at(at_v1, leg1, 2 + i) : at(at_v2, leg2, 2 + i - n1);
  };
  for (int i = 0; i < k; ++i) {
    if (outward(i).side != frame.side(l, i)) return std::nullopt;
    l.e[slot(i)] = outward(i).length;
  }
  const std::array<const Crossing*, 2> first_leg{&at(at_v2, leg2, 0), &at(at_v1, leg1, 0)};
  const std::array<const Crossing*, 2> second_leg{&at(at_v2, leg2, 1), &at(at_v1, leg1, 1)};
  const std::array<int, 2> first{0, n1};
  const std::array<int, 2> last{n1 - 1, k - 1};
  for (const int v : {0, 1}) {
    // The other vertex's first leg comes before this vertex's first crossing, its second leg after the last.
    const Integer d1 =
        first_leg[slot(v)]->side < 0 ? 0 : outward(first[slot(v)]).distance - first_leg[slot(v)]->distance;
    const Integer d2 =
        second_leg[slot(v)]->side < 0 ? 0 : second_leg[slot(v)]->distance - outward(last[slot(v)]).distance;
    if (v == 0) l.d1 = d1, l.d2 = d2;
    if (d1 != l.d1 || d2 != l.d2) return std::nullopt;
  }
  // A leg joins the vertices: one extent is 0, and the length of the leg is the other.
  if (second_leg[0]->side < 0) l.d1 = second_leg[0]->length;
  if (l.d1 < 0 || l.d2 < 0) return std::nullopt;
  return l;
}

}  // namespace

std::optional<Located> locate(const RegionShape& shape, std::span<const Crossing> at_v1,
                              std::span<const Crossing> at_v2) {
  const PairType type = shape.type();
  const Frame frame{type, shape.sides(), type.side_count()};
  const int l1 = type.l1;
  const int l2 = type.l2;
  for (int leg1 = 0; leg1 < l1; ++leg1) {
    for (int leg2 = 0; leg2 < l2; ++leg2) {
      std::optional<Labelling> l = read(frame, at_v1, leg1, at_v2, leg2);
      if (!l || l->d1 == 0) continue;  // d1 = 0 is the other labelling of d2 = 0
      Located located{*l, false, leg1, leg2};
      const SeparatrixVector predicted = separatrix_vector(shape, *l);
      bool same = true;
      for (int i = 0; i < l1 && same; ++i) same = predicted.at_v1[slot(i)] == at_v1[slot((leg1 + i) % l1)];
      for (int i = 0; i < l2 && same; ++i) same = predicted.at_v2[slot(i)] == at_v2[slot((leg2 + i) % l2)];
      // theory-1: nothing else says how long a side is whose only crossing is that of a middle separatrix.
      for (int i = 0; i < frame.k && same; ++i) {
        const bool is_first = i == 0 || i == l1 - 2;
        const bool is_last = i == l1 - 3 || i == frame.k - 1;
        same = frame.length(*l, i) ==
               frame.e(*l, i - 1) + frame.e(*l, i + 1) + (is_first ? l->d1 : 0) + (is_last ? l->d2 : 0);
      }
      if (!same) continue;
      if (const int half = frame.k / 2; type.symmetric() && l->p > half) {
        located.swapped = true;
        located.labelling.p -= half;
        const auto e = located.labelling.e.begin();
        std::rotate(e, e + half, e + frame.k);
      }
      return located;
    }
  }
  return std::nullopt;
}

int locate_merged(const RegionShape& shape, std::span<const Crossing> at_v) {
  const IntegerVector& sides = shape.sides();
  const int k = shape.side_count();
  if (static_cast<int>(at_v.size()) != k) return -1;
  for (int first = 0; first < k; ++first) {
    if (at_v[slot(first)].side != 0) continue;
    const auto at = [&](int i) -> const Crossing& { return at_v[slot((first + i + k) % k)]; };
    for (int i = 0; i < k; ++i) {
      const bool fits =
          at(i).side == i && at(i).distance == at(i - 1).length && sides(i) == at(i - 1).length + at(i + 1).length;
      if (!fits) return -1;
    }
    return first;
  }
  return -1;
}

}  // namespace requad::theory
