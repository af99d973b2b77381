#include "mesh/courier.hpp"

#include <algorithm>

namespace requad::mesh {

const char* name(CourierStep::Way way) {
  switch (way) {
    case CourierStep::Way::collapse:
      return "collapse";
    case CourierStep::Way::flip:
      return "flip";
    case CourierStep::Way::split:
      return "split";
  }
  return "";
}

PlannedStep plan(const QuadMesh& m, HalfEdgeId courier, CourierStep step, int turn) {
  const bool left = step.hand == Hand::left;
  const HalfEdgeId back = m.twin(courier);  // v -> u
  PlannedStep result;
  switch (step.way) {
    case CourierStep::Way::collapse: {
      const HalfEdgeId keep = left ? courier : QuadMesh::next(back);  // u -> v or u -> d
      result.operation = {BasicOperation::Kind::collapse, keep, {}, 0};
      result.next_v = m.origin(QuadMesh::opposite(keep));
      result.edge = m.twin(left ? QuadMesh::opposite(courier) : keep);
      result.next_u = left ? m.origin(QuadMesh::previous(courier)) : m.target(keep);
      break;
    }
    case CourierStep::Way::flip: {
      const HalfEdgeId edge = left ? QuadMesh::next(courier) : QuadMesh::previous(back);  // v -> c or c -> v
      const HalfEdgeId across = m.twin(edge);
      result.operation = {left ? BasicOperation::Kind::flip_cw : BasicOperation::Kind::flip_ccw, edge, {}, 0};
      result.next_u = left ? m.target(edge) : m.origin(edge);
      if (across.valid())
        result.next_v = left ? m.origin(QuadMesh::previous(across)) : m.target(QuadMesh::next(across));
      result.edge = edge;
      result.reversed = left;
      break;
    }
    case CourierStep::Way::split: {
      HalfEdgeId to_z = back;
      for (int k = 0; k < turn; ++k) to_z = left ? m.cw(to_z) : m.ccw(to_z);
      const HalfEdgeId from_z = m.twin(to_z);
      result.operation = left ? BasicOperation{BasicOperation::Kind::split, to_z, courier, 0}
                              : BasicOperation{BasicOperation::Kind::split, back, from_z, 0};
      result.next_v = m.target(to_z);
      result.edge = left ? to_z : from_z;
      result.reversed = !left;
      break;
    }
  }
  return result;
}

PlannedStep renamed(const QuadMesh& m, const PlannedStep& step) {
  PlannedStep result = step;
  BasicOperation& op = result.operation;
  if (op.kind == BasicOperation::Kind::collapse) {
    op.h = QuadMesh::opposite(op.h);
  } else if (op.kind == BasicOperation::Kind::split) {
    op.h = m.twin(step.operation.last);
    op.last = m.twin(step.operation.h);
  }
  return result;
}

namespace {

// What landing on a vertex does: it is regular and becomes the courier's end; it is a target that takes the courier; or
// a target that must be crossed, a v5 that the courier makes a v6 or a v3 that it makes a v2.
enum class Landing { refused, regular, absorbed, crossed };

}  // namespace

// From the targets over vertices on which a courier can land, until both ends of the start have been met and a little
// further, so that small detours are measured too.
void Courier::measure_distances(std::span<const VertexId> targets, HalfEdgeId start) {
  constexpr int kMargin = 2;
  const QuadMesh& m = editor_.mesh();
  const VertexId u = m.origin(start);
  const VertexId v = m.target(start);
  int last = -1;  // distances beyond this one are not needed; -1: not known yet
  surroundings_.measure(
      m, targets, [&](VertexId x) { return !editor_.is_fixed(x); },
      [&](VertexId x) { return x == u || x == v || m.face_valence(x) == 4; },
      [&](VertexId, int d) {
        farthest_ = d;
        if (last < 0 && surroundings_.distance(u) >= 0 && surroundings_.distance(v) >= 0) last = d + kMargin;
        return last >= 0 && d >= last;
      });
}

int Courier::distance(VertexId v) const {
  const int d = surroundings_.distance(v);
  return d >= 0 ? d : farthest_ + 1;
}

// Makes the mesh that of a node: back to where the paths part, then forward.
void Courier::go_to(int node, std::size_t base) {
  std::vector<int> wanted;
  for (int n = node; n > 0; n = nodes_[static_cast<std::size_t>(n)].parent) wanted.push_back(n);
  std::reverse(wanted.begin(), wanted.end());
  std::size_t common = 0;
  while (common < path_.size() && common < wanted.size() && path_[common] == wanted[common]) ++common;
  editor_.roll_back(base + common);
  path_.resize(common);
  for (std::size_t i = common; i < wanted.size(); ++i) {
    editor_.run(nodes_[static_cast<std::size_t>(wanted[i])].step.operation);
    path_.push_back(wanted[i]);
  }
}

// Queues every step that can be made from here.
void Courier::expand(int node, HalfEdgeId courier, std::span<const VertexId> targets) {
  const QuadMesh& m = editor_.mesh();
  const VertexId u = m.origin(courier);
  const VertexId v = m.target(courier);
  if (editor_.is_fixed(u) || editor_.is_fixed(v)) return;
  const auto is_target = [&](VertexId x) { return std::find(targets.begin(), targets.end(), x) != targets.end(); };
  const auto landing = [&](VertexId x, bool gains) {
    if (!x.valid() || editor_.is_fixed(x)) return Landing::refused;
    const int l = m.face_valence(x);
    if (!is_target(x)) return l == 4 ? Landing::regular : Landing::refused;
    if (gains ? l < 4 : l > 4) return Landing::absorbed;
    return l == (gains ? 5 : 3) ? Landing::crossed : Landing::refused;
  };
  const int lu = m.face_valence(u);
  const int lv = m.face_valence(v);
  for (const CourierStep step : kCourierSteps) {
    const bool collapses = step.way == CourierStep::Way::collapse;
    const bool splits = step.way == CourierStep::Way::split;
    // A target that was crossed takes the courier on its far side: a v2 by the collapse, a v6 by the even split.
    const bool takes = (collapses && lu == 2 && is_target(u)) || (splits && lv == 6 && is_target(v));
    if ((collapses && lu != 3 && !takes) || (splits && lv < 4)) continue;
    PlannedStep planned = plan(m, courier, step, splits && takes ? 3 : 2);
    const Landing at_u = splits ? Landing::regular : landing(planned.next_u, false);
    const Landing at_v = landing(planned.next_v, true);
    if (at_u == Landing::refused || at_v == Landing::refused || planned.next_u == planned.next_v) continue;
    if (takes && (at_u != Landing::regular || at_v != Landing::regular)) continue;
    // Vertices that were there before keep their ids, so that distances and targets stay what they are.
    if (collapses) planned = renamed(m, planned);
    if (editor_.why_not(planned.operation) != Refusal::none) continue;
    VertexId absorbed_by;
    if (at_u == Landing::absorbed) absorbed_by = planned.next_u;
    if (at_v == Landing::absorbed) absorbed_by = planned.next_v;
    if (takes) absorbed_by = collapses ? u : v;
    const bool absorbed = absorbed_by.valid();
    // Beyond a target that was crossed, the same place is another one: the target lies on the other hand.
    const Node& here = nodes_[static_cast<std::size_t>(node)];
    const int crossings = here.crossings + (at_u == Landing::crossed ? 1 : 0) + (at_v == Landing::crossed ? 1 : 0);
    if (crossings > most_crossings_) continue;
    const std::int64_t key =
        4 * static_cast<std::int64_t>(planned.edge.index()) + 2 * crossings + (planned.reversed ? 1 : 0);
    if (!absorbed && !seen_.insert(key).second) continue;
    const int depth = here.depth + 1;
    const int rest =
        absorbed ? 0 : std::min(splits ? farthest_ + 1 : distance(planned.next_u), distance(planned.next_v));
    nodes_.push_back({node, depth, crossings, absorbed, absorbed_by, planned});
    open_.push({depth + rest, depth, static_cast<int>(nodes_.size()) - 1});
  }
}

Transport Courier::carry(HalfEdgeId start, std::span<const VertexId> targets, bool may_cross,
                         std::int64_t most_states) {
  Transport result;
  const std::size_t base = editor_.mark();
  most_crossings_ = may_cross ? 1 : 0;
  nodes_.assign(1, Node{});
  path_.clear();
  open_ = {};
  seen_.clear();
  measure_distances(targets, start);
  const auto met = [this](VertexId v) { return surroundings_.distance(v) >= 0; };
  if (met(editor_.mesh().origin(start)) || met(editor_.mesh().target(start))) open_.push({0, 0, 0});
  while (!open_.empty() && result.states < most_states) {
    const int node = open_.top().node;
    open_.pop();
    ++result.states;
    go_to(node, base);
    const Node& here = nodes_[static_cast<std::size_t>(node)];
    const HalfEdgeId courier = node == 0 ? start : here.step.courier(editor_.mesh());
    if (here.absorbed) {
      result.courier = courier;
      result.absorbed_by = here.absorbed_by;
      result.steps = here.depth;
      return result;
    }
    expand(node, courier, targets);
  }
  editor_.roll_back(base);
  result.refusal = Refusal::no_way;
  return result;
}

}  // namespace requad::mesh
