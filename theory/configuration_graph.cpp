#include "theory/configuration_graph.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace requad::theory {

GridPoint step_offset(PairType type, int step) {
  static constexpr std::array<GridPoint, 4> kDiagonal{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  static constexpr std::array<GridPoint, 4> kAxis{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  return (type.symmetric() ? kDiagonal : kAxis)[static_cast<std::size_t>(step)];
}

Configuration stepped(PairType type, const Configuration& from, int step) {
  const GridPoint delta = step_offset(type, step);
  Configuration to = from;
  IntegerVector& e = to.parameters.e;
  if (!type.symmetric()) {
    // The kernel of Equation 3: what e1 gains e3 loses, what e2 gains e4 loses.
    e(0) += delta.m, e(2) -= delta.m;
    e(1) += delta.n, e(3) -= delta.n;
    return to;
  }
  to.parameters.d1 += delta.m;
  to.parameters.d2 += delta.n;
  // The sides stay, so the change of the strips solves e_{i-1} + e_{i+1} = -(change of the d terms of side i). Its
  // right-hand side is not positive, so solve for the strips themselves.
  const PairSystem system(type);
  const IntegerVector sides = system.side_lengths(from.parameters);
  const auto solutions = system.solve_strips(sides, to.d1(), to.d2());
  e = solutions.empty() ? IntegerVector::Zero(e.size()).eval() : solutions.front();
  return to;
}

bool is_configuration(const Configuration& c) {
  return c.d1() >= 0 && c.d2() >= 0 && c.parameters.e.size() > 0 && c.parameters.e.minCoeff() >= 1;
}

int ConfigurationMap::find(const Configuration& labelling) const {
  if (!is_configuration(labelling)) return -1;
  const auto it = index.find(canonical(type, labelling));
  return it == index.end() ? -1 : it->second;
}

namespace {

// The (labelling, step) pairs of a node, counter-clockwise.
void list_moves(PairType type, MapNode& node) {
  const auto add = [&node](const Configuration& labelling, int step) {
    node.labellings.push_back(labelling);
    node.steps.push_back(step);
  };
  const Configuration& c = node.configuration;
  if (type.symmetric() && c.degenerate()) {
    // (d,0,p) looks into quadrant p by its first two steps; (0,d,p+1) into quadrant p+1 by (+1,-1) and (+1,+1).
    add(c, 0), add(c, 1);
    const Configuration other = other_labelling(type, c);
    add(other, 3), add(other, 0);
  } else {
    for (int step = 0; step < kStepCount; ++step) add(c, step);
  }
}

}  // namespace

ConfigurationMap configuration_map(const RegionShape& shape, Apex apex) {
  const PairType type = shape.type();
  ConfigurationMap map{type, {}, {}};
  const auto add_node = [&map](const Configuration& c) {
    map.index.emplace(c, static_cast<int>(map.nodes.size()));
    map.nodes.push_back({c, {}, {}, {}});
  };
  for (const Configuration& c : parameter_set(shape)) add_node(c);
  if (apex == Apex::with) {
    for (const Configuration& c : merged_configurations(shape)) add_node(c);
  }

  for (MapNode& node : map.nodes) {
    if (node.configuration.merged()) {
      // One move into each quadrant, (0,0,p) -> (1,1,p). Quadrant p + 1 lies clockwise of quadrant p (theory-3).
      for (int p = type.rotation_count(); p >= 1; --p) {
        Configuration labelling = node.configuration;
        labelling.p = p;
        IntegerVector e = labelling.parameters.e;
        for (Eigen::Index i = 0; i < e.size(); ++i) labelling.parameters.e(i) = e((i + p - 1) % e.size());
        node.labellings.push_back(labelling);
        node.steps.push_back(0);
      }
    } else {
      list_moves(type, node);
    }
    node.moves.resize(node.steps.size());
  }

  // Targets first, then the move of the target that leads back: same labelling, opposite step.
  const auto slot_of = [&map](int target, const Configuration& labelling, int step) {
    const MapNode& node = map.nodes[static_cast<std::size_t>(target)];
    for (std::size_t slot = 0; slot < node.steps.size(); ++slot) {
      if (node.configuration.merged()) {
        if (node.labellings[slot].p == labelling.p) return static_cast<int>(slot);
      } else if (node.steps[slot] == step && node.labellings[slot] == labelling) {
        return static_cast<int>(slot);
      }
    }
    throw std::logic_error("a predicted step has no way back");
  };
  for (MapNode& node : map.nodes) {
    for (std::size_t slot = 0; slot < node.moves.size(); ++slot) {
      const Configuration to = stepped(type, node.labellings[slot], node.steps[slot]);
      const int target = map.find(to);
      if (target < 0) continue;
      node.moves[slot] = {target, slot_of(target, to, reverse_step(node.steps[slot]))};
    }
  }
  return map;
}

ConfigurationGraph configuration_graph(const ConfigurationMap& map) {
  ConfigurationGraph graph(map.nodes.size());
  for (std::size_t i = 0; i < map.nodes.size(); ++i) {
    graph[i].configuration = map.nodes[i].configuration;
    for (std::size_t slot = 0; slot < map.nodes[i].moves.size(); ++slot) {
      const Dart& dart = map.nodes[i].moves[slot];
      // Each edge is met from both ends; take it at the smaller (node, slot).
      const std::array<int, 2> here{static_cast<int>(i), static_cast<int>(slot)};
      if (dart.target >= 0 && here < std::array<int, 2>{dart.target, dart.slot}) {
        boost::add_edge(i, static_cast<std::size_t>(dart.target), graph);
      }
    }
  }
  return graph;
}

namespace {

// The grid point between a move and the next one counter-clockwise: half the sum of the two steps beyond the node.
Configuration corner_centre(PairType type, const MapNode& node, std::size_t slot) {
  static constexpr std::array<GridPoint, 4> kBetween{{{0, 1}, {-1, 0}, {0, -1}, {1, 0}}};
  Configuration centre = node.labellings[slot];
  // At the merged node quadrant p is followed counter-clockwise by p - 1; on their common axis (0,x,p) is (x,0,p-1).
  const GridPoint shift =
      node.configuration.merged() ? GridPoint{0, 1} : kBetween[static_cast<std::size_t>(node.steps[slot])];
  centre.parameters.d1 += shift.m;
  centre.parameters.d2 += shift.n;
  Configuration bare = canonical(type, centre);
  if (bare.merged()) bare.p = 1;
  bare.parameters.e.resize(0);
  return bare;
}

}  // namespace

DualGrid dual_grid(const ConfigurationMap& map) {
  assert(map.type.symmetric());
  // face_of[node][slot]: the face counter-clockwise after that move; -2 not visited, -1 the unbounded one.
  std::vector<std::vector<int>> face_of(map.nodes.size());
  for (std::size_t i = 0; i < map.nodes.size(); ++i) face_of[i].assign(map.nodes[i].moves.size(), -2);

  DualGrid dual;
  for (std::size_t i = 0; i < map.nodes.size(); ++i) {
    for (std::size_t slot = 0; slot < face_of[i].size(); ++slot) {
      if (face_of[i][slot] != -2) continue;
      // Walk the face on the left: leave by the move counter-clockwise after, arrive, turn to the next one again.
      std::vector<std::array<std::size_t, 2>> corners;
      bool bounded = true;
      std::size_t node = i;
      std::size_t at = slot;
      do {
        corners.push_back({node, at});
        const std::size_t next = (at + 1) % map.nodes[node].moves.size();
        const Dart& here = map.nodes[node].moves[at];
        if (here.target < 0 || map.nodes[node].moves[next].target < 0) {
          bounded = false;
          break;
        }
        node = static_cast<std::size_t>(here.target);
        // The face lies counter-clockwise after `at`, so clockwise before the move that leads back.
        const auto back = static_cast<std::size_t>(here.slot);
        const std::size_t degree = map.nodes[node].moves.size();
        at = (back + degree - 1) % degree;
      } while (node != i || at != slot);
      int face = -1;
      if (bounded) {
        const Configuration centre = corner_centre(map.type, map.nodes[i], slot);
        for (const auto& [n, s] : corners) {
          if (!(corner_centre(map.type, map.nodes[n], s) == centre))
            throw std::logic_error("a face of the grid has two centres");
        }
        face = static_cast<int>(dual.faces.size());
        dual.faces.push_back(centre);
      }
      for (const auto& [n, s] : corners) face_of[n][s] = face;
    }
  }

  for (std::size_t i = 0; i < map.nodes.size(); ++i) {
    for (std::size_t slot = 0; slot < face_of[i].size(); ++slot) {
      const Dart& dart = map.nodes[i].moves[slot];
      const std::array<int, 2> here{static_cast<int>(i), static_cast<int>(slot)};
      if (dart.target < 0 || !(here < std::array<int, 2>{dart.target, dart.slot})) continue;
      const std::size_t degree = face_of[i].size();
      const int left = face_of[i][slot];
      const int right = face_of[i][(slot + degree - 1) % degree];
      if (left < 0 || right < 0) continue;
      dual.edges.push_back({std::min(left, right), std::max(left, right)});
    }
  }
  std::sort(dual.edges.begin(), dual.edges.end());
  return dual;
}

}  // namespace requad::theory
