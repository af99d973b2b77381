#include "enumerate/graphs/grid_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace requad::enumerate {

using theory::Configuration;
using theory::PairType;

GridDrawing grid_drawing(const Exploration& found, const std::function<GridPosition(const Configuration&)>& position) {
  const PairType type = found.shape.type();
  GridDrawing drawing;
  std::map<std::pair<long, long>, int> spot_at;
  const auto key = [&position](const Configuration& labelling) {
    const GridPosition at = position(labelling);
    return std::pair{std::lround(at[0] * 1024), std::lround(at[1] * 1024)};
  };
  const auto add_spot = [&](const Configuration& labelling, int node, int same_as) {
    const auto [it, is_new] = spot_at.emplace(key(labelling), static_cast<int>(drawing.spots.size()));
    if (is_new) drawing.spots.push_back({node, same_as, labelling, position(labelling)});
    return it->second;
  };
  for (std::size_t i = 0; i < found.nodes.size(); ++i) {
    const Configuration& c = found.nodes[i].reading.configuration;
    const int spot = add_spot(c, static_cast<int>(i), -1);
    if (type.symmetric() && c.degenerate() && !c.merged())
      add_spot(theory::other_labelling(type, c), static_cast<int>(i), spot);
  }
  // A move and its inverse join the same two spots, so this loop meets every edge twice.
  std::map<std::pair<int, int>, int> drawn;
  for (const FoundMove& move : found.moves) {
    if (move.to < 0) continue;
    const auto from = spot_at.find(key(move.before.value()));
    const auto to = spot_at.find(key(move.after.value()));
    if (from == spot_at.end() || to == spot_at.end()) throw std::logic_error("a move leaves the grid");
    const std::pair<int, int> ends = std::minmax(from->second, to->second);
    // Draws one of the two: the move from the spot with the lesser number; for a self-loop, the move that comes first.
    const int met = ++drawn[ends];
    if (from->second == to->second ? met % 2 == 0 : from->second != ends.first) continue;
    drawing.lines.push_back({from->second, to->second, &move});
  }
  return drawing;
}

GridDrawing grid_drawing(const Exploration& found) {
  const PairType type = found.shape.type();
  return grid_drawing(found, [type](const Configuration& labelling) {
    return grid_position(type, type.symmetric() ? labelling : theory::canonical(type, labelling));
  });
}

}  // namespace requad::enumerate
