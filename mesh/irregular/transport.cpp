#include "mesh/irregular/transport.hpp"

#include <algorithm>

#include "mesh/irregular/transport_step.hpp"

namespace requad::mesh {

const char* name(TransportStep::Kind kind) {
  switch (kind) {
    case TransportStep::Kind::collapse: return "collapse";
    case TransportStep::Kind::flip: return "flip";
    case TransportStep::Kind::split: return "split";
  }
  return "";
}

PlannedStep plan(const QuadMesh& m, AdjacentPair pair, TransportStep step, int turn) {
  return planned_step(m, pair, step, turn);
}

std::vector<HalfEdgeId> departures(const QuadMesh& m, VertexId v) {
  std::vector<HalfEdgeId> result;
  const bool lacks_edges = m.face_valence(v) < 4;
  m.for_each_out(v, [&](HalfEdgeId h) { result.push_back(lacks_edges ? h : m.twin(h)); });
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

Obstacles& Obstacles::operator|=(const Obstacles& o) {
  features |= o.features, boundary |= o.boundary, irregular |= o.irregular, limit |= o.limit;
  return *this;
}

std::string to_string(const Obstacles& obstacles) {
  std::string text;
  const auto add = [&text](bool met, const char* what) {
    if (met) text += (text.empty() ? "" : ", ") + std::string(what);
  };
  add(obstacles.features, "features");
  add(obstacles.boundary, "the boundary");
  add(obstacles.irregular, "other irregular vertices");
  add(obstacles.limit, "the limit of the search");
  return text;
}

namespace {

// What landing on a vertex does. It is regular and becomes an end of the pair; or it is a target that absorbs the pair;
// or it is a target that must be crossed: a v5 that the pair makes a v6, or a v3 that it makes a v2.
enum class Landing { refused, regular, absorbed, crossed };

}  // namespace

// Measures from the targets over vertices on which a pair can land, until both ends of the start have been met and a
// little further, so that small detours are measured too. A pair crosses no feature, so distances end there. A target
// on a feature may have no edge inside its patch, but a split beside it lets it absorb a pair all the same (Figure 18).
// There the corners of its sector count as the target.
void PairTransport::measure_distances(std::span<const VertexId> targets, AdjacentPair start) {
  constexpr int kMargin = 2;
  const QuadMesh& m = editor_.mesh();
  const Sectors& sectors = editor_.sectors();
  sources_.assign(targets.begin(), targets.end());
  for (const VertexId x : targets) {
    if (!sectors.is_fixed(x)) continue;
    m.for_each_out(x, [&](HalfEdgeId h) {
      if (sectors.excess(h) == 0) return;
      for (const VertexId corner : m.corners(QuadMesh::face(h))) {
        if (sectors.may_change(corner)) sources_.push_back(corner);
      }
    });
  }
  const VertexId u = start.u(m);
  const VertexId v = start.v(m);
  const auto enters = [&](VertexId x) { return sectors.may_change(x); };
  const auto passes = [&](VertexId x) { return x == u || x == v || (!sectors.is_fixed(x) && m.face_valence(x) == 4); };
  // Only the nearest sources count. They are found from the start of the transport, so that the search covers a disc round
  // it, not one round each source.
  std::sort(sources_.begin(), sources_.end());
  std::vector<VertexId> near;
  int last = -1;  // distances beyond this one are not needed; -1: not known yet
  distances_.measure(m, std::array{u, v}, enters, passes, [&](VertexId x, int d) {
    if (std::binary_search(sources_.begin(), sources_.end(), x)) {
      near.push_back(x);
      if (last < 0) last = d + 1 + kMargin;
    }
    return last >= 0 && d >= last;
  });
  last = -1;
  farthest_ = 0;
  distances_.measure(m, near, enters, passes, [&](VertexId, int d) {
    farthest_ = d;
    if (last < 0 && distances_.distance(u) >= 0 && distances_.distance(v) >= 0) last = d + kMargin;
    return last >= 0 && d >= last;
  });
}

int PairTransport::distance(VertexId v) const {
  const int d = distances_.distance(v);
  return d >= 0 ? d : farthest_ + 1;
}

// Turns the mesh into that of a node. Rolls back to the node where the two paths part, then makes the steps from there.
void PairTransport::go_to(int node, std::size_t base) {
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

// Queues every step that the pair can make from here.
void PairTransport::expand(int node, AdjacentPair pair, std::span<const VertexId> targets, Obstacles& obstacles) {
  const QuadMesh& m = editor_.mesh();
  const Sectors& sectors = editor_.sectors();
  const VertexId u = pair.u(m);
  const VertexId v = pair.v(m);
  const auto is_target = [&](VertexId x) { return std::find(targets.begin(), targets.end(), x) != targets.end(); };
  const auto meet = [&](VertexId x) { (m.is_boundary(x) ? obstacles.boundary : obstacles.features) = true; };
  // `at` names the vertex and its sector; `gains` means that it becomes the pair's v and has one quad more.
  const auto landing = [&](HalfEdgeId at, bool gains) {
    if (!at.valid()) return Landing::refused;
    const VertexId x = m.origin(at);
    if (!sectors.may_change(x)) return meet(x), Landing::refused;
    const int e = sectors.excess(at);
    if (e == 0) return Landing::regular;
    if (!is_target(x)) return obstacles.irregular = true, Landing::refused;
    if (gains ? e < 0 : e > 0) return Landing::absorbed;
    return !sectors.is_fixed(x) && e == (gains ? 1 : -1) ? Landing::crossed : Landing::refused;
  };
  const bool keeps_u = sectors.is_fixed(u);
  const bool cut = sectors.is_cut(pair.edge);
  const int eu = sectors.excess(pair.at_u());
  const int ev = sectors.excess(pair.at_v());
  for (const TransportStep step : kTransportSteps) {
    const bool collapses = step.kind == TransportStep::Kind::collapse;
    const bool splits = step.kind == TransportStep::Kind::split;
    // On a cut edge there is one hand only.
    if (cut && (step.hand == Hand::right) != pair.against) continue;
    // A target that was crossed absorbs the pair on its far side: a v2 by the collapse, a v6 by the even split.
    const bool takes = (collapses && eu == -2 && is_target(u)) || (splits && ev == 2 && is_target(v));
    if ((collapses && eu != -1 && !takes) || (splits && ev < 0)) continue;
    PlannedStep planned = plan(m, pair, step, splits && takes ? 3 : 2);
    const Landing at_u = splits ? Landing::regular : landing(planned.at_u, false);
    const Landing at_v = landing(planned.at_v, true);
    if (at_u == Landing::refused || at_v == Landing::refused || planned.next_u == planned.next_v) continue;
    if (takes && (at_u != Landing::regular || at_v != Landing::regular)) continue;
    if (collapses && sectors.is_cut(planned.first)) planned.next = planned.beside;
    // The vertices that exist keep their ids, so that distances and targets stay what they are. Only a collapse at a
    // fixed u takes a regular vertex into it, and u is then the next v.
    if (collapses && keeps_u) {
      if (at_v != Landing::regular || sectors.is_fixed(planned.next_v)) continue;
      planned.next_v = u;
    } else if (collapses) {
      planned = renamed(m, planned);
    }
    if (const Refusal refusal = editor_.why_not(planned.operation); refusal != Refusal::none) {
      obstacles.features |= refusal == FeatureRefusal::breaks_feature;
      obstacles.boundary |= refusal == Refusal::boundary_corner || refusal == Refusal::boundary_edge;
      continue;
    }
    VertexId absorbed_by;
    if (at_u == Landing::absorbed) absorbed_by = planned.next_u;
    if (at_v == Landing::absorbed) absorbed_by = planned.next_v;
    if (takes) absorbed_by = collapses ? u : v;
    const int absorbed = (at_u == Landing::absorbed ? 1 : 0) + (at_v == Landing::absorbed ? 1 : 0) + (takes ? 1 : 0);
    // Beyond a target that was crossed, the same position counts as another one: the target lies on the other hand.
    const Node& here = nodes_[static_cast<std::size_t>(node)];
    const int crossings = here.crossings + (at_u == Landing::crossed ? 1 : 0) + (at_v == Landing::crossed ? 1 : 0);
    if (crossings > most_crossings_) continue;
    const std::int64_t key =
        4 * static_cast<std::int64_t>(planned.next.edge.index()) + 2 * crossings + (planned.next.against ? 1 : 0);
    if (absorbed == 0 && !seen_.insert(key).second) continue;
    const int depth = here.depth + 1;
    const int rest =
        absorbed > 0 ? 0 : std::min(splits ? farthest_ + 1 : distance(planned.next_u), distance(planned.next_v));
    nodes_.push_back({node, depth, crossings, absorbed, absorbed_by, planned});
    open_.push({depth + rest, absorbed, depth, static_cast<int>(nodes_.size()) - 1});
  }
}

TransportReport PairTransport::carry(AdjacentPair start, std::span<const VertexId> targets, bool may_cross) {
  const QuadMesh& m = editor_.mesh();
  const Sectors& sectors = editor_.sectors();
  TransportReport result;
  result.refusal = EditRefusal::no_path;
  for (const VertexId x : {start.u(m), start.v(m)}) {
    if (!sectors.may_change(x)) (m.is_boundary(x) ? result.obstacles.boundary : result.obstacles.features) = true;
  }
  if (!to_string(result.obstacles).empty()) return result;

  const std::size_t base = editor_.mark();
  most_crossings_ = may_cross ? 1 : 0;
  nodes_.assign(1, Node{});
  path_.clear();
  open_ = {};
  seen_.clear();
  measure_distances(targets, start);
  const auto met = [this](VertexId v) { return distances_.distance(v) >= 0; };
  if (met(start.u(m)) || met(start.v(m))) open_.push({0, 0, 0, 0});
  while (!open_.empty() && result.states < most_states_) {
    const int node = open_.top().node;
    open_.pop();
    ++result.states;
    go_to(node, base);
    const Node& here = nodes_[static_cast<std::size_t>(node)];
    const AdjacentPair pair = node == 0 ? start : here.step.next;
    if (here.absorbed > 0) {
      result.refusal = Refusal::none;
      result.pair = pair;
      result.absorbed_by = here.absorbed_by;
      result.steps = here.depth;
      return result;
    }
    expand(node, pair, targets, result.obstacles);
  }
  result.obstacles.limit = !open_.empty();
  editor_.roll_back(base);
  return result;
}

}  // namespace requad::mesh
