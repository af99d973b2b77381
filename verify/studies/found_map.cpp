#include "verify/studies/found_map.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace requad::verify {

using enumerate::FoundMove;
using theory::Configuration;
using theory::Integer;
using theory::MapNode;
using theory::PairType;

namespace {

std::string step_text(const Configuration& from, const Configuration& to) {
  const auto text = [](const Configuration& c) {
    std::string t =
        "d1=" + std::to_string(c.d1()) + " d2=" + std::to_string(c.d2()) + " p=" + std::to_string(c.p) + " e=";
    for (const auto e : c.parameters.e) t += std::to_string(e) + ",";
    return t;
  };
  return "the step from " + text(from) + " to " + text(to) + " is none of the theorem's four";
}

// Both labellings of a 3-5 segment describe the same four translations; the map has them for one.
Configuration labelled(PairType type, const Configuration& c) {
  return type.symmetric() ? c : theory::canonical(type, c);
}

// A move, as the labels before and after it show it.
struct ReadMove {
  Configuration before;
  Configuration after;
  int step = -1;          // the index of its offset (step_offset())
  std::size_t place = 0;  // in the order round the configuration
};

// The step between two labellings in one frame; nothing if it is none of the four.
std::optional<int> step_between(PairType type, const Configuration& from, const Configuration& to) {
  if (from.p != to.p && !from.merged() && !to.merged()) return std::nullopt;
  const theory::GridPoint a = theory::grid_point(type, from), b = theory::grid_point(type, to);
  for (int step = 0; step < theory::kStepCount; ++step) {
    const theory::GridPoint offset = theory::step_offset(type, step);
    if (b == theory::GridPoint{a.m + offset.m, a.n + offset.n}) return step;
  }
  return std::nullopt;
}

// The quadrant 0..3 of a direction with two entries that are not 0, counter-clockwise from x, y > 0.
std::size_t quadrant(Integer x, Integer y) { return x > 0 ? (y > 0 ? 0 : 3) : (y > 0 ? 1 : 2); }

// The place of a move of a merged vertex: the rank of its edge, clockwise, among the edges out of the vertex. An edge
// and the opposite one part it alike.
std::size_t place_of_edge(const mesh::QuadMesh& m, mesh::HalfEdgeId edge, std::size_t places) {
  std::size_t rank = 0;
  for (mesh::HalfEdgeId h = m.out(m.origin(edge)); h != edge; h = m.cw(h)) ++rank;
  return rank % places;
}

// The index of the region's side that a 3-5 pair comes nearer to, 0-based, or nothing if the strips of not exactly one
// side become fewer.
std::optional<std::size_t> nearer_side(const Configuration& from, const Configuration& to) {
  std::optional<std::size_t> nearer;
  const Eigen::Index k = from.parameters.e.size();
  for (Eigen::Index side = 0; side < k; ++side) {
    const auto strips = [&](const Configuration& c) { return c.parameters.e((side - (c.p - 1) + k) % k); };
    if (strips(to) >= strips(from)) continue;
    if (nearer) return std::nullopt;
    nearer = static_cast<std::size_t>(side);
  }
  return nearer;
}

ReadMove read_move(const PairStudy& s, const FoundMove& move, std::size_t places) {
  const PairType type = s.shape.type();
  if (!move.before || !move.after) throw std::logic_error("a move's frame has no labelling");
  ReadMove result{labelled(type, *move.before), labelled(type, *move.after), -1, 0};
  Configuration& before = result.before;
  // The merged configuration has the same labels in every quadrant. The step out of it leads into quadrant p.
  if (before.merged()) before.p = result.after.p;
  const auto step = step_between(type, before, result.after);
  if (!step) throw std::logic_error(step_text(before, result.after));
  result.step = *step;
  if (!type.symmetric()) {
    const auto side = nearer_side(*move.before, *move.after);
    if (!side) throw std::logic_error(step_text(before, result.after));
    result.place = *side;
  } else if (before.merged()) {
    const auto& region = s.found.nodes[static_cast<std::size_t>(move.from)].region;
    result.place = place_of_edge(region.mesh, move.move.frame.first_leg, places);
  } else {
    const Integer first = result.after.d2() - before.d2(), second = result.after.d1() - before.d1();
    result.place = 3 - (before.d1() == 0 ? quadrant(-second, first) : quadrant(first, second));
  }
  return result;
}

}  // namespace

theory::ConfigurationMap found_map(const PairStudy& s) {
  theory::ConfigurationMap map = s.map;
  for (MapNode& node : map.nodes) {
    const auto places =
        static_cast<std::size_t>(node.configuration.merged() ? map.type.rotation_count() : theory::kStepCount);
    node.moves.assign(places, theory::Dart{});
    node.labellings.assign(places, node.configuration);
    node.steps.assign(places, -1);
  }
  std::vector<std::vector<ReadMove>> moves(map.nodes.size());
  for (const FoundMove& move : s.found.moves) {
    if (move.to < 0) continue;
    const int from = s.predicted_of[static_cast<std::size_t>(move.from)];
    const int to = s.predicted_of[static_cast<std::size_t>(move.to)];
    if (from < 0 || to < 0) throw std::logic_error("a move joins configurations that are not predicted");
    const auto at = static_cast<std::size_t>(from);
    MapNode& node = map.nodes[at];
    const ReadMove read = read_move(s, move, node.moves.size());
    if (node.moves[read.place].target >= 0) throw std::logic_error("two moves make one step");
    node.moves[read.place].target = to;
    node.labellings[read.place] = read.before;
    node.steps[read.place] = read.step;
    moves[at].push_back(read);
  }
  // A move leads back if its labels are the same in the other order.
  const auto same = [](const Configuration& a, const Configuration& b) { return a.merged() ? b.merged() : a == b; };
  for (std::size_t at = 0; at < moves.size(); ++at) {
    for (const ReadMove& there : moves[at]) {
      theory::Dart& dart = map.nodes[at].moves[there.place];
      for (const ReadMove& back : moves[static_cast<std::size_t>(dart.target)]) {
        const bool quadrant_fits = !there.after.merged() || back.before.p == there.before.p;
        if (same(back.before, there.after) && same(back.after, there.before) && quadrant_fits)
          dart.slot = static_cast<int>(back.place);
      }
      if (dart.slot < 0) throw std::logic_error("no move leads back");
    }
  }
  return map;
}

namespace {

// By how many places the moves of a node of the predicted map come later than those of the found one; nothing if they
// are other moves, or in another order. A node without moves fits as it is.
std::optional<std::size_t> shift_between(const MapNode& predicted, const MapNode& found) {
  const std::size_t n = found.moves.size();
  if (predicted.moves.size() != n) return std::nullopt;
  const auto same_move = [&](std::size_t p, std::size_t f) {
    if (predicted.moves[p].target != found.moves[f].target) return false;
    if (found.moves[f].target < 0) return true;
    const Configuration& a = predicted.labellings[p];
    const Configuration& b = found.labellings[f];
    return predicted.steps[p] == found.steps[f] && (a.merged() ? b.merged() && a.p == b.p : a == b);
  };
  for (std::size_t shift = 0; shift < n; ++shift) {
    bool fits = true;
    for (std::size_t f = 0; f < n && fits; ++f) fits = same_move((f + shift) % n, f);
    if (fits) return shift;
  }
  return std::nullopt;
}

}  // namespace

std::string node_difference(const theory::ConfigurationMap& predicted, const theory::ConfigurationMap& found,
                            std::size_t node) {
  const MapNode& here = predicted.nodes[node];
  const MapNode& there = found.nodes[node];
  const auto shift = shift_between(here, there);
  if (!shift) {
    std::vector<int> targets[2];
    for (const theory::Dart& dart : here.moves) targets[0].push_back(dart.target);
    for (const theory::Dart& dart : there.moves) targets[1].push_back(dart.target);
    for (std::vector<int>& list : targets) std::sort(list.begin(), list.end());
    return targets[0] == targets[1] ? "the moves lie in another order round it than theory says, or are other steps"
                                    : "the moves lead to other configurations than theory says";
  }
  const std::size_t n = here.moves.size();
  for (std::size_t f = 0; f < n; ++f) {
    const theory::Dart& dart = there.moves[f];
    if (dart.target < 0) continue;
    const auto target = static_cast<std::size_t>(dart.target);
    const auto shift_there = shift_between(predicted.nodes[target], found.nodes[target]);
    const std::size_t back = static_cast<std::size_t>(dart.slot) + shift_there.value_or(0);
    if (static_cast<std::size_t>(here.moves[(f + *shift) % n].slot) != back % found.nodes[target].moves.size())
      return "a move is undone by another one than theory says";
  }
  return "";
}

}  // namespace requad::verify
