#include "theory/configuration_table.hpp"

#include <algorithm>
#include <stdexcept>

namespace requad::theory {

ConfigurationTable::ConfigurationTable(const RegionShape& shape) : shape_(shape), type_(shape.type()) {
  const PairSystem& system = shape_.system();
  const std::vector<Configuration> pairs = parameter_set(shape);
  const std::vector<Configuration> merged = merged_configurations(shape);
  if (merged.size() > 1) throw std::invalid_argument("more than one merged configuration");
  pairs_ = static_cast<int>(pairs.size());
  merged_ = !merged.empty();
  for (const Configuration& c : pairs) {
    const GridPoint at = grid_point(type_, c);
    columns_ = std::max(columns_, at.m + 1);
    rows_ = std::max(rows_, at.n + 1);
    const Integer faces = system.face_count(c.parameters);
    most_faces_ = std::max(most_faces_, faces);
    if (&c == &pairs.front() || faces < system.face_count(smallest_.parameters)) smallest_ = c;
  }
  for (const Configuration& c : merged) most_faces_ = std::max(most_faces_, system.face_count(c.parameters));
  number_.assign(static_cast<std::size_t>(type_.rotation_count() * columns_ * rows_), -1);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const GridPoint at = grid_point(type_, pairs[i]);
    std::int32_t& number = number_[static_cast<std::size_t>(((pairs[i].p - 1) * columns_ + at.m) * rows_ + at.n)];
    if (number >= 0) throw std::logic_error("two configurations at one grid point");
    number = static_cast<std::int32_t>(i);
  }
}

std::int64_t ConfigurationTable::count_edges() const {
  std::int64_t ends = 0;
  const auto count = [&](const Place& place) {
    if (find(place) < 0) return;
    for (int slot = 0; slot < slot_count(place); ++slot) ends += move(place, slot).target >= 0 ? 1 : 0;
  };
  if (merged_) count({});
  for (int p = 1; p <= type_.rotation_count(); ++p) {
    for (Integer m = 1; m < columns_; ++m) {
      for (Integer n = 0; n < rows_; ++n) count({p, {m, n}});
    }
  }
  return ends / 2;
}

int ConfigurationTable::find(const Place& place) const {
  if (is_merged(place)) return merged_ ? pairs_ : -1;
  const auto [m, n] = place.at;
  if (m < 0 || n < 0 || m >= columns_ || n >= rows_ || place.p < 1 || place.p > type_.rotation_count()) return -1;
  return number_[static_cast<std::size_t>(((place.p - 1) * columns_ + m) * rows_ + n)];
}

ConfigurationTable::Move ConfigurationTable::move(const Place& place, int slot) const {
  const int turns = type_.rotation_count();
  const auto wrapped = [turns](int p) { return (p - 1 + turns) % turns + 1; };
  Move move;
  Place from = place;
  // As list_moves() of configuration_graph.cpp orders them: (d,0,p) looks into quadrant p by its first two steps, and
  // as (0,d,p+1) into quadrant p + 1 by two more; at the merged node quadrant p + 1 lies clockwise of quadrant p.
  if (is_merged(place)) {
    from.p = turns - slot;
    move.step = 0;
  } else if (degenerate(place)) {
    move.other = slot >= 2;
    move.step = slot < 2 ? slot : slot == 2 ? 3 : 0;
    if (move.other) from = {wrapped(place.p + 1), {place.at.n, place.at.m}};
  } else {
    move.step = slot;
  }
  const GridPoint offset = step_offset(type_, move.step);
  const Place to{from.p, {from.at.m + offset.m, from.at.n + offset.n}};
  const int back = reverse_step(move.step);
  move.to = to;
  if (is_merged(to)) {
    move.to.p = 1;
    move.back_slot = turns - to.p;
  } else if (degenerate(to)) {
    if (to.at.m == 0) move.to = {wrapped(to.p - 1), {to.at.n, 0}};  // theory-3
    move.back_slot = to.at.n == 0 ? back : back == 3 ? 2 : 3;
  } else {
    move.back_slot = back;
  }
  move.target = find(move.to);
  return move;
}

}  // namespace requad::theory
