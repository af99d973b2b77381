#include "mesh/irregular/atomic_operations.hpp"

#include <charconv>
#include <utility>

namespace requad::mesh {

using StepKind = TransportStep::Kind;

// --- rules and names -------------------------------------------------------------------------------------------------

namespace {

constexpr std::array<AtomicRule, 9> kRules{{
    {AtomicKind::move_35, AtomicKind::move_35, "move-35", {3, 5, 4, 4}, true, true, true, "Figure 3"},
    {AtomicKind::move_v3, AtomicKind::remove_35_v3, "move-v3", {3, 4, 4, 4}, true, true, false, "Figure 4a-c"},
    {AtomicKind::move_v5, AtomicKind::remove_35_v5, "move-v5", {4, 5, 4, 4}, false, true, true, "Figure 4d-f"},
    {AtomicKind::remove_35_v3,
     AtomicKind::move_v3,
     "remove-35-v3",
     {3, 5, 4, 3},
     false,
     true,
     true,
     "Figure 4a-c in reverse"},
    {AtomicKind::remove_35_v5,
     AtomicKind::move_v5,
     "remove-35-v5",
     {3, 5, 5, 4},
     true,
     true,
     false,
     "Figure 4d-f in reverse"},
    {AtomicKind::generate_3355,
     AtomicKind::remove_3355,
     "generate-3355",
     {4, 4, 4, 4},
     false,
     true,
     false,
     "3-3-5-5 generation"},
    {AtomicKind::remove_3355,
     AtomicKind::generate_3355,
     "remove-3355",
     {3, 5, 5, 3},
     false,
     true,
     false,
     "3-3-5-5 removal"},
    {AtomicKind::raise, AtomicKind::lower, "raise", {0, 0, 0, 0}, true, false, false, "Figure 5a"},
    {AtomicKind::lower, AtomicKind::raise, "lower", {0, 0, 0, 0}, false, false, true, "Figure 5b"},
}};

const char* name(Hand hand) { return hand == Hand::left ? "left" : "right"; }

bool is_type_change(AtomicKind kind) { return kind == AtomicKind::raise || kind == AtomicKind::lower; }

}  // namespace

bool AtomicRule::has(StepKind by) const {
  switch (by) {
    case StepKind::collapse: return collapses;
    case StepKind::flip: return flips;
    case StepKind::split: return splits;
  }
  return false;
}

std::span<const AtomicRule> atomic_rules() { return kRules; }
const AtomicRule& rule(AtomicKind kind) { return kRules[static_cast<std::size_t>(kind)]; }

std::string to_string(const AtomicName& n) {
  std::string text = std::string(rule(n.kind).name) + " " + name(n.step.kind) + " " + name(n.step.hand);
  if (n.kind == AtomicKind::lower) text += " " + std::to_string(n.turn);
  return text;
}

std::optional<AtomicName> parse_atomic_name(std::string_view text) {
  for (const AtomicRule& r : kRules) {
    for (const TransportStep step : kTransportSteps) {
      AtomicName candidate{r.kind, step, 0};
      if (!r.has(step.kind)) continue;
      if (r.kind == AtomicKind::lower) {
        const std::string_view digits = text.substr(text.rfind(' ') + 1);
        std::from_chars(digits.data(), digits.data() + digits.size(), candidate.turn);
        if (candidate.turn < 2) continue;
      }
      if (to_string(candidate) == text) return candidate;
    }
  }
  return std::nullopt;
}

// --- from names to basic operations ----------------------------------------------------------------------------------

namespace {

// An operation as a step of an adjacent pair. Where a v5 moves or V is split, V is the pair's v. There the pair runs
// against the direction in which the operation is seen.
struct Sent {
  HalfEdgeId pair;
  TransportStep step;
};
bool runs_against(AtomicKind kind) { return kind == AtomicKind::move_v5 || kind == AtomicKind::lower; }
Sent turned(const QuadMesh& m, AtomicKind kind, Sent s) {
  return runs_against(kind) ? Sent{m.twin(s.pair), {s.step.kind, other(s.step.hand)}} : s;
}

constexpr int kStraight = 2;  // the split's path takes the second edge, as in transport

struct Resolved {
  Refusal refusal = Refusal::none;
  Sent sent;
  PlannedStep planned;
};

// Whether the valences are those of the rule.
Refusal why_not_by_valences(const QuadMesh& m, const AtomicName& name, const Sent& sent, const PlannedStep& planned) {
  if (name.kind == AtomicKind::raise)
    return m.valence(planned.next_v) < 3 ? EditRefusal::wrong_valences : Refusal::none;
  if (name.kind == AtomicKind::lower) return Refusal::none;  // any V; K is in range
  const std::array<int, 4>& wanted = rule(name.kind).valences;
  if (m.valence(m.origin(sent.pair)) != wanted[0] || m.valence(m.target(sent.pair)) != wanted[1])
    return EditRefusal::wrong_valences;
  const bool next_u_fits = sent.step.kind == StepKind::split || m.valence(planned.next_u) == wanted[2];
  return next_u_fits && m.valence(planned.next_v) == wanted[3] ? Refusal::none : EditRefusal::irregular_in_the_way;
}

Resolved resolve(const Editor& editor, const AtomicOperation& op) {
  const QuadMesh& m = editor.mesh();
  const auto refused = [](Refusal why) { return Resolved{why, {}, {}}; };
  if (!m.is_live(op.along)) return refused(Refusal::dead_element);
  if (m.is_boundary(m.origin(op.along)) || m.is_boundary(m.target(op.along)))
    return refused(EditRefusal::touches_boundary);
  const auto& [kind, step, turn] = op.name;
  if (!rule(kind).has(step.kind)) return refused(EditRefusal::no_such_step);
  if (kind == AtomicKind::lower && (turn < 2 || turn >= m.valence(m.origin(op.along))))
    return refused(EditRefusal::wrong_valences);

  Resolved r;
  r.sent = turned(m, kind, {op.along, step});
  r.planned = plan(m, AdjacentPair{r.sent.pair}, r.sent.step, kind == AtomicKind::lower ? turn : kStraight);
  const bool renames = (step.kind == StepKind::collapse && kind != AtomicKind::raise) != op.swapped;
  if (renames) r.planned = renamed(m, r.planned);
  if (step.kind == StepKind::split) r.planned.operation.corner = op.corner;

  const bool ends_somewhere = r.planned.next_v.valid();  // the far side of a flipped edge may be outside
  for (const VertexId v : {r.planned.next_u, r.planned.next_v}) {
    if (!ends_somewhere || (v.valid() && m.is_boundary(v))) return refused(EditRefusal::touches_boundary);
  }
  r.refusal = why_not_by_valences(m, op.name, r.sent, r.planned);
  if (r.refusal == Refusal::none) r.refusal = editor.why_not(r.planned.operation);
  return r;
}

}  // namespace

AtomicPlan plan(const Editor& editor, const AtomicOperation& operation) {
  const Resolved r = resolve(editor, operation);
  return {r.refusal, r.planned.operation};
}

// --- performing ------------------------------------------------------------------------------------------------------

namespace {

StepKind inverse(StepKind by) {
  switch (by) {
    case StepKind::collapse: return StepKind::split;
    case StepKind::flip: return StepKind::flip;
    case StepKind::split: return StepKind::collapse;
  }
  return by;
}

}  // namespace

AtomicReport perform(Editor& editor, const AtomicOperation& op) {
  const QuadMesh& m = editor.mesh();
  AtomicReport report;
  const Resolved r = resolve(editor, op);
  report.refusal = r.refusal;
  if (report.refusal != Refusal::none) return report;
  const AtomicKind kind = op.name.kind;
  report.operation = r.planned.operation;
  for (const VertexId v : changed_vertices(m, report.operation)) {
    if (v.valid()) report.changes.push_back({v, m.valence(v), 0});
  }
  const VertexId kept = m.origin(report.operation.h);
  const VertexId w = m.target(op.along);
  const int opposite_valence = kind == AtomicKind::raise ? m.valence(r.planned.next_v) : 0;

  const Applied done = editor.run(report.operation);
  const bool splits = op.name.step.kind == StepKind::split;
  const VertexId made = splits ? m.origin(QuadMesh::opposite(done.made)) : VertexId();
  if (splits) report.changes.push_back({made, 0, 0});
  for (ValenceChange& c : report.changes) c.after = m.is_live(c.vertex) ? m.valence(c.vertex) : 0;

  AtomicOperation& back = report.inverse;
  back.name.kind = rule(kind).inverse;
  back.swapped = op.swapped;
  back.corner = done.inverse.corner;
  if (is_type_change(kind)) {
    // This is still seen from V to W. Of the two parts of a split, V is the one that is not on the hand.
    back.along = m.find_half_edge(splits && op.swapped ? made : kept, w);
    back.name.step = {inverse(op.name.step.kind), op.name.step.hand};
    back.name.turn = kind == AtomicKind::raise ? opposite_valence - 1 : 0;
  } else {
    // The pair looks back, on the other hand, to where it came from.
    const Sent sent =
        turned(m, back.name.kind, {r.planned.next.forth(m), {inverse(r.sent.step.kind), other(r.sent.step.hand)}});
    back.along = sent.pair;
    back.name.step = sent.step;
  }
  return report;
}

// --- lists -----------------------------------------------------------------------------------------------------------

namespace {

class Lister {
 public:
  explicit Lister(const Editor& editor) : editor_(editor), m_(editor.mesh()) {}

  // The operations that lie along one edge, except the type changes.
  void add_edge(HalfEdgeId along) {
    const VertexId w = m_.target(along);
    const int lv = m_.valence(m_.origin(along));
    const int lw = m_.is_boundary(w) ? 0 : m_.valence(w);
    if (lv == 3 && lw == 5) add_pair(along);
    if (lv == 5 && lw == 3) add_pair(m_.twin(along));
    if (lv == 3) add_ways(AtomicKind::move_v3, along);
    if (lv == 5) add_ways(AtomicKind::move_v5, along);
    if (lv == 4) {
      add_ways(AtomicKind::generate_3355, along);
      add_ways(AtomicKind::generate_3355, m_.twin(along));
    }
  }
  void add_raise(HalfEdgeId along, Hand hand) { add({{AtomicKind::raise, {StepKind::collapse, hand}, 0}, along}); }
  void add_lower(HalfEdgeId along, int turn) { add({{AtomicKind::lower, {StepKind::split, Hand::left}, turn}, along}); }

  std::vector<AtomicChoice> take() { return std::move(choices_); }

 private:
  void add_ways(AtomicKind kind, HalfEdgeId along) {
    for (const TransportStep step : kTransportSteps) {
      if (rule(kind).has(step.kind)) add({{kind, step, 0}, along});
    }
  }

  // Each of the six steps is of one of the kinds for an adjacent 3-5 pair, or move-35 if all of them are refused.
  void add_pair(HalfEdgeId pair) {
    for (const TransportStep step : kTransportSteps) {
      AtomicChoice best;
      for (const AtomicRule& r : kRules) {
        if (r.valences[0] != 3 || r.valences[1] != 5 || !r.has(step.kind)) continue;
        const AtomicChoice choice = judged({{r.kind, step, 0}, pair});
        const bool fits = choice.refusal != EditRefusal::irregular_in_the_way;
        if (r.kind == AtomicKind::move_35 || fits) best = choice;
        if (fits) break;
      }
      choices_.push_back(best);
    }
  }

  AtomicChoice judged(AtomicOperation op) const {
    Refusal refusal = plan(editor_, op).refusal;
    if (refusal == FeatureRefusal::breaks_feature && op.name.step.kind != StepKind::flip) {
      AtomicOperation other = op;
      other.swapped = true;
      if (plan(editor_, other).refusal == Refusal::none) return {other, Refusal::none};
    }
    return {op, refusal};
  }
  void add(const AtomicOperation& op) { choices_.push_back(judged(op)); }

  const Editor& editor_;
  const QuadMesh& m_;
  std::vector<AtomicChoice> choices_;
};

}  // namespace

std::vector<AtomicChoice> atomic_operations(const Editor& editor, VertexId v) {
  const QuadMesh& m = editor.mesh();
  if (m.is_boundary(v)) return {};
  std::vector<HalfEdgeId> out;
  m.for_each_out(v, [&out](HalfEdgeId h) { out.push_back(h); });
  const int l = static_cast<int>(out.size());
  Lister list(editor);
  for (const HalfEdgeId h : out) list.add_edge(h);
  for (const HalfEdgeId h : out) list.add_raise(h, Hand::left);
  // The left part is the new and the larger one. Where both are equal, half of the edges make all paths.
  for (int turn = (l + 1) / 2; turn <= l - 2; ++turn) {
    for (int i = 0; i < (2 * turn == l ? turn : l); ++i) list.add_lower(out[static_cast<std::size_t>(i)], turn);
  }
  return list.take();
}

std::vector<AtomicChoice> atomic_operations(const Editor& editor, HalfEdgeId along) {
  const QuadMesh& m = editor.mesh();
  Lister list(editor);
  list.add_edge(along);
  for (const Hand hand : {Hand::left, Hand::right}) list.add_raise(along, hand);
  for (int turn = 2; turn <= m.valence(m.origin(along)) - 2; ++turn) list.add_lower(along, turn);
  return list.take();
}

}  // namespace requad::mesh
