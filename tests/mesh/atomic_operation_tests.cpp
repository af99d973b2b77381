// Atomic operations (section 5): every listed operation is performed, at every vertex and along every edge of small
// regions, and compared with the paper's statement. The statement is written out here by hand.
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "mesh/irregular/atomic_operations.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/mesh/neighbourhoods.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/mesh/regions.hpp"
#include "tests/support/sanitizers.hpp"

using namespace requad;
using namespace requad::mesh;
using requad::tests::neighbourhood;
using requad::tests::pair_neighbourhood;
using requad::tests::rel_boundary;
using requad::tests::vertex_of;

namespace {

using StepKind = TransportStep::Kind;
using Valences = std::multiset<int>;

// The valences that an operation changes, according to section 5 and Figures 3 to 5, if all vertices are regular except
// those that the operation is about. Worked out by hand from the law of section 4.
struct Stated {
  Valences before;
  Valences after;
  std::string inverse;  // kind and step of the inverse
};
const std::map<std::string, Stated> kStated{
    {"move-35 collapse", {{3, 4, 4, 5}, {3, 4, 5}, "move-35 split"}},
    {"move-35 flip", {{3, 4, 4, 5}, {3, 4, 4, 5}, "move-35 flip"}},
    {"move-35 split", {{3, 4, 5}, {3, 4, 4, 5}, "move-35 collapse"}},
    {"move-v3 collapse", {{3, 4, 4, 4}, {3, 3, 5}, "remove-35-v3 split"}},
    {"move-v3 flip", {{3, 4, 4, 4}, {3, 3, 4, 5}, "remove-35-v3 flip"}},
    {"move-v5 flip", {{4, 4, 4, 5}, {3, 4, 5, 5}, "remove-35-v5 flip"}},
    {"move-v5 split", {{4, 4, 5}, {3, 4, 5, 5}, "remove-35-v5 collapse"}},
    {"remove-35-v3 split", {{3, 3, 5}, {3, 4, 4, 4}, "move-v3 collapse"}},
    {"remove-35-v3 flip", {{3, 3, 4, 5}, {3, 4, 4, 4}, "move-v3 flip"}},
    {"remove-35-v5 flip", {{3, 4, 5, 5}, {4, 4, 4, 5}, "move-v5 flip"}},
    {"remove-35-v5 collapse", {{3, 4, 5, 5}, {4, 4, 5}, "move-v5 split"}},
    {"generate-3355 flip", {{4, 4, 4, 4}, {3, 3, 5, 5}, "remove-3355 flip"}},
    {"remove-3355 flip", {{3, 3, 5, 5}, {4, 4, 4, 4}, "generate-3355 flip"}},
};

std::string kind_and_way(const AtomicName& n) { return std::string(rule(n.kind).name) + " " + name(n.step.kind); }

struct AtomicTally {
  std::map<std::string, int> performed;
  std::map<Refusal, int> refused;
};

// Checks one operation. It changes exactly the stated valences, and its inverse restores the mesh. The inverse of the
// inverse is the operation.
void check_choice(const Region& region, const AtomicChoice& choice, AtomicTally& tally) {
  const QuadMesh& before = region.mesh;
  const AtomicOperation& op = choice.operation;
  const VertexId v = before.origin(op.along);
  const VertexId w = before.target(op.along);
  INFO(to_string(op.name) << " along " << v.index() << " -> " << w.index() << (op.swapped ? ", swapped" : "") << ": "
                          << choice.refusal.clause());
  QuadMesh m = before;
  Editor editor(m);
  const AtomicReport report = perform(editor, op);
  REQUIRE(report.refusal == choice.refusal);
  if (choice.refusal != Refusal::none) {
    REQUIRE(m == before);
    REQUIRE(editor.mark() == 0);
    // A step of a pair that has none of the three kinds is reported as a move.
    const bool no_kind =
        choice.refusal == EditRefusal::touches_boundary || choice.refusal == EditRefusal::irregular_in_the_way;
    const bool of_pair = rule(op.name.kind).valences[0] == 3 && rule(op.name.kind).valences[1] == 5;
    if (no_kind && of_pair) REQUIRE(op.name.kind == AtomicKind::move_35);
    ++tally.refused[choice.refusal];
    return;
  }
  ++tally.performed[kind_and_way(op.name)];
  REQUIRE(editor.mark() == 1);
  REQUIRE(validate(m).empty());

  // The report has every vertex whose valence changed. The only other vertices in it are those of a collapse or split.
  const int capacity = std::max(before.vertex_capacity(), m.vertex_capacity());
  constexpr std::array<int, 2> kNothing{-1, -1};
  std::vector<std::array<int, 2>> told(static_cast<std::size_t>(capacity), kNothing);
  for (const ValenceChange& c : report.changes) {
    REQUIRE(told[c.vertex.slot()] == kNothing);
    told[c.vertex.slot()] = {c.before, c.after};
  }
  Valences changed_before, changed_after;
  for (int i = 0; i < capacity; ++i) {
    const VertexId x(i);
    const int was = before.is_live(x) ? before.valence(x) : 0;
    const int is = m.is_live(x) ? m.valence(x) : 0;
    const std::array<int, 2>& change = told[x.slot()];
    if (was != is) REQUIRE(change != kNothing);
    if (change == kNothing) continue;
    REQUIRE(change == std::array<int, 2>{was, is});
    REQUIRE_FALSE((before.is_live(x) && before.is_boundary(x)));
    if (was > 0) changed_before.insert(was);
    if (is > 0) changed_after.insert(is);
  }

  const auto at = [&](VertexId x) { return m.is_live(x) ? m.valence(x) : 0; };
  std::string inverse;
  if (op.name.kind == AtomicKind::raise) {
    // Figure 5a: V and the opposite corner c of the face become one vertex of valence l(V) + l(c) - 2.
    const bool left = op.name.step.hand == Hand::left;
    const HalfEdgeId h = left ? op.along : before.next(before.twin(op.along));
    const VertexId c = before.target(before.next(h));
    REQUIRE(before.origin(h) == v);
    REQUIRE(at(op.swapped ? c : v) == before.valence(v) + before.valence(c) - 2);
    REQUIRE(at(op.swapped ? v : c) == 0);
    REQUIRE(at(before.target(h)) == before.valence(before.target(h)) - 1);
    REQUIRE(at(before.origin(before.previous(h))) == before.valence(before.origin(before.previous(h))) - 1);
    REQUIRE(report.changes.size() == 4);
    inverse = "lower split";
  } else if (op.name.kind == AtomicKind::lower) {
    // Figure 5b: the K - 1 edges on that hand, strictly between the two edges of the path, go to the new vertex.
    const int rest = before.valence(v) - 1 - op.name.turn;
    const VertexId made = report.changes.back().vertex;
    REQUIRE(report.changes.size() == 4);
    REQUIRE_FALSE(before.is_live(made));
    REQUIRE(at(op.swapped ? made : v) == rest + 2);
    REQUIRE(at(op.swapped ? v : made) == op.name.turn + 1);
    REQUIRE(at(w) == before.valence(w) + 1);
    HalfEdgeId to_z = op.along;
    for (int k = 0; k < op.name.turn; ++k) to_z = op.name.step.hand == Hand::left ? before.ccw(to_z) : before.cw(to_z);
    REQUIRE(at(before.target(to_z)) == before.valence(before.target(to_z)) + 1);
    inverse = "raise collapse";
  } else {
    const Stated& stated = kStated.at(kind_and_way(op.name));
    REQUIRE(changed_before == stated.before);
    REQUIRE(changed_after == stated.after);
    inverse = stated.inverse;
    // A pair that was moved or generated is adjacent. A vertex moves along the edge that the operation names.
    if (op.name.kind == AtomicKind::move_v3) REQUIRE((at(v) != 3 && at(w) == 3));
    if (op.name.kind == AtomicKind::move_v5) REQUIRE((at(v) == (op.swapped ? 3 : 4) && at(w) == 5));
    if (inverse.rfind("move-35", 0) == 0 || inverse.rfind("remove", 0) == 0) {
      const HalfEdgeId back = report.inverse.along;
      const int at_v = m.valence(m.origin(back)), at_w = m.valence(m.target(back));
      REQUIRE((at_v == 3 && at_w == 5));
    }
  }
  REQUIRE(kind_and_way(report.inverse.name) == inverse);

  const QuadMesh after = m;
  const AtomicReport back = perform(editor, report.inverse);
  REQUIRE(back.refusal == Refusal::none);
  REQUIRE(m == before);
  REQUIRE(validate(m).empty());
  REQUIRE(back.inverse.name == op.name);
  REQUIRE(m.origin(back.inverse.along) == v);
  REQUIRE(m.target(back.inverse.along) == w);
  REQUIRE(perform(editor, back.inverse).refusal == Refusal::none);
  if (!(m == after)) REQUIRE(rel_boundary(m, region) == rel_boundary(after, region));
}

// Checks every operation at every vertex and along every edge, with both choices of names.
void check_everywhere(const Region& region, AtomicTally& tally) {
  INFO("on " << signature(region));
  const QuadMesh& m = region.mesh;
  QuadMesh copy = m;
  const Editor editor(copy);
  const auto check = [&](const std::vector<AtomicChoice>& list) {
    for (const AtomicChoice& choice : list) {
      check_choice(region, choice, tally);
      if (choice.refusal != Refusal::none || choice.operation.name.step.kind == StepKind::flip) continue;
      AtomicChoice other = choice;
      other.operation.swapped = true;
      check_choice(region, other, tally);
    }
  };
  for (const VertexId v : m.vertices()) {
    check(atomic_operations(editor, v));
    if (m.is_boundary(v)) {
      REQUIRE(atomic_operations(editor, v).empty());
      continue;
    }
    m.for_each_out(v, [&](HalfEdgeId h) { check(atomic_operations(editor, h)); });
  }
}

}  // namespace

TEST_CASE("atomic names are read as they are written", "[atomic]") {
  std::set<std::string> names;
  for (const AtomicRule& r : atomic_rules()) {
    CHECK(&rule(r.kind) == &r);
    CHECK(rule(r.inverse).inverse == r.kind);
    for (const TransportStep step : kTransportSteps) {
      for (int turn = 2; turn < 12; ++turn) {
        const AtomicName n{r.kind, step, r.kind == AtomicKind::lower ? turn : 0};
        const std::string text = to_string(n);
        if (!r.has(step.kind)) {
          CHECK_FALSE(parse_atomic_name(text));
          continue;
        }
        REQUIRE(parse_atomic_name(text));
        CHECK(*parse_atomic_name(text) == n);
        CHECK(to_string(*parse_atomic_name(text)) == text);
        names.insert(text);
      }
    }
  }
  // There are 6 moves of a pair. There are 4 moves each of a v3 and of a v5, and 4 removals each at a v3 and at a v5.
  // Two flips make 3-3-5-5, and two remove it. There are 2 raises, and 10 values of K for a lower on each of 2 hands.
  CHECK(names.size() == 6 + 4 * 4 + 2 * 2 + 2 + 2 * 10);
  CHECK(names.count("move-v3 flip left") == 1);
  CHECK(names.count("lower split right 3") == 1);
  for (const std::string text :
       {"", " ", "move-v3", "move-v3 flip", "move-v3 split left", "move-v5 collapse left", "move-v3 flip Left",
        "move-v3  flip left", "move-v3 flip left ", "move-v3 flip left 2", "lower split left", "lower split left 1",
        "lower split left 02", "lower split left 3x", "lower split left 99999999999999", "remove-35 flip left"}) {
    INFO(text);
    CHECK_FALSE(parse_atomic_name(text));
  }
}

TEST_CASE("every atomic operation does what the table says, and its inverse restores the mesh", "[atomic]") {
  AtomicTally tally;
  int regions = 0;
  for (int valence = 2; valence <= 9; ++valence, ++regions) check_everywhere(neighbourhood(valence), tally);
  for (const tests::SmallRegion& entry : tests::small_regions(tests::kSanitized ? 12 : 16, true)) {
    check_everywhere(entry.region, tally);
    ++regions;
  }
  check_everywhere(pair_neighbourhood(), tally);
  ++regions;
  // Removals are possible after one generation of irregular vertices.
  for (const int valence : {3, 4, 5}) {
    const Region start = neighbourhood(valence);
    QuadMesh m = start.mesh;
    Editor editor(m);
    for (const AtomicChoice& choice : atomic_operations(editor, vertex_of(m, valence))) {
      const AtomicKind kind = choice.operation.name.kind;
      if (kind == AtomicKind::raise || kind == AtomicKind::lower) continue;
      REQUIRE(perform(editor, choice.operation).refusal == Refusal::none);
      check_everywhere({m, m.out(start.mesh.origin(start.root))}, tally);
      ++regions;
      editor.roll_back();
    }
  }
  int performed = 0, refused = 0;
  for (const auto& [what, stated] : kStated) {
    INFO(what);
    CHECK(tally.performed[what] > 20);
  }
  for (const auto& [what, n] : tally.performed) performed += n;
  for (const auto& [why, n] : tally.refused) refused += n;
  WARN(regions << " regions: " << performed << " atomic operations performed and undone, " << refused << " refused");
  CHECK(tally.performed.size() == kStated.size() + 2);
  CHECK(tally.refused[EditRefusal::touches_boundary] > 100);
  CHECK(tally.refused[EditRefusal::irregular_in_the_way] > 100);
  CHECK(tally.refused.count(EditRefusal::no_such_step) == 0);
}
