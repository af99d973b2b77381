// Atomic operations (section 5): every operation that is listed, at every vertex and along every edge of generated
// neighbourhoods, against the paper's statement written out by hand, and against exhausting the basic operations.
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "enumerate/generators.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/irregular/atomic_operations.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/support.hpp"

using namespace requad;
using namespace requad::mesh;

namespace {

using Kind = BasicOperation::Kind;
using StepKind = TransportStep::Kind;
using Valences = std::multiset<int>;

// One vertex of this valence in the middle of a region that is regular otherwise, four quads from every side.
Region neighbourhood(int valence) {
  return enumerate::glue_region({valence + 1, 3}, {{0, 0, theory::IntegerVector::Constant(valence, 4)}, 1});
}
// An adjacent 3-5 pair, likewise.
Region pair_neighbourhood() {
  return enumerate::glue_region(theory::kQuad, {{1, 0, theory::IntegerVector::Constant(4, 4)}, 1});
}
// The vertex of this valence; the middle of a regular grid.
VertexId vertex_of(const QuadMesh& m, int valence) {
  for (const VertexId v : irregular_vertices(m)) {
    if (m.valence(v) == valence) return v;
  }
  for (const VertexId v : m.vertices()) {
    bool inside = valence == 4 && !m.is_boundary(v);
    for (const VertexId w : m.neighbours(v)) {
      for (const VertexId x : m.neighbours(w)) inside = inside && !m.is_boundary(x);
    }
    if (inside) return v;
  }
  return {};
}

std::string rel_boundary(const QuadMesh& m, const Region& region) {
  return signature(m, m.out(region.mesh.origin(region.root)));
}

// What section 5 and Figures 3 to 5 say of the vertices that an operation of a kind and way changes, with all of them
// regular but for the ones that it is about. By hand from the law of section 4.
struct Stated {
  Valences before;
  Valences after;
  std::string inverse;  // its kind and way
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

// One operation: exactly the valence changes stated, and an inverse that restores the mesh, whose inverse is it again.
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
    // A step of a pair that is none of its kinds is told of as a move.
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

  // The report tells of every vertex whose valence changed, and of no other but a collapse's or split's own.
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
    // Figure 5a: V and the opposite corner c of the face become one of valence l(V) + l(c) - 2.
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
    // Figure 5b: K - 1 edges strictly between the path's on the hand go to the new vertex.
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
    // A pair that is moved or generated is adjacent; what moves, moves by the edge it is said to move along.
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

// Every operation at every vertex and along every edge, and each with the other choice of names.
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

// Every legal basic operation that changes no valence on the boundary, each once up to names.
std::vector<BasicOperation> exhausted(const QuadMesh& m) {
  std::vector<BasicOperation> all;
  const auto add = [&](const BasicOperation& op) {
    if (why_not(m, op) != Refusal::none) return;
    const auto changed = changed_vertices(m, op);
    if (std::none_of(changed.begin(), changed.end(), [&](VertexId x) { return x.valid() && m.is_boundary(x); }))
      all.push_back(op);
  };
  for (const HalfEdgeId h : m.half_edges()) {
    if (h < m.twin(h)) add({Kind::flip_ccw, h, {}, 0}), add({Kind::flip_cw, h, {}, 0});
    if (h.index() % 4 < 2) add({Kind::collapse, h, {}, 0});
  }
  for (const VertexId v : m.vertices()) {
    if (m.is_boundary(v)) continue;
    std::vector<HalfEdgeId> out;
    m.for_each_out(v, [&out](HalfEdgeId h) { out.push_back(h); });
    for (std::size_t i = 0; i < out.size(); ++i) {
      for (std::size_t k = i + 1; k < out.size(); ++k) add({Kind::split, out[i], m.twin(out[k]), 0});
    }
  }
  return all;
}

Valences sorted_valences(const QuadMesh& m) {
  Valences valences;
  for (const VertexId v : irregular_vertices(m)) valences.insert(m.valence(v));
  return valences;
}

std::size_t count(const std::vector<AtomicChoice>& list, AtomicKind kind) {
  return static_cast<std::size_t>(
      std::count_if(list.begin(), list.end(), [=](const AtomicChoice& c) { return c.operation.name.kind == kind; }));
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
  // 6 moves of a pair, 4 of a v3, a v5 and their removals each, 2 flips that make and 2 that remove 3-3-5-5, 2 raises,
  // and lowers by 10 values of K on 2 hands.
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
  for (const tests::CensusEntry& entry : tests::census(16, true)) {
    check_everywhere(entry.region, tally);
    ++regions;
  }
  check_everywhere(pair_neighbourhood(), tally);
  ++regions;
  // Where the removals are: one generation away.
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
  WARN(regions << " regions: " << performed << " atomic operations performed and taken back, " << refused
               << " refused");
  CHECK(tally.performed.size() == kStated.size() + 2);
  CHECK(tally.refused[EditRefusal::touches_boundary] > 100);
  CHECK(tally.refused[EditRefusal::irregular_in_the_way] > 100);
  CHECK(tally.refused.count(EditRefusal::no_such_step) == 0);
}

TEST_CASE("section 5: a v3 moves in three directions, each by two collapses and two flips", "[atomic]") {
  // And a v5 in five, each by two splits and two flips. The operations and what they make are those that exhausting all
  // basic operations finds.
  for (const int valence : {3, 5}) {
    const Region region = neighbourhood(valence);
    QuadMesh m = region.mesh;
    const VertexId v = vertex_of(m, valence);
    Editor editor(m);
    const StepKind way = valence == 3 ? StepKind::collapse : StepKind::split;
    std::map<VertexId, std::map<StepKind, int>> ways;
    std::set<std::pair<VertexId, std::string>> listed;
    for (const AtomicChoice& choice : atomic_operations(editor, v)) {
      if (choice.operation.name.kind != (valence == 3 ? AtomicKind::move_v3 : AtomicKind::move_v5)) continue;
      const VertexId n = m.target(choice.operation.along);
      CHECK(choice.refusal == Refusal::none);
      ++ways[n][choice.operation.name.step.kind];
      perform(editor, choice.operation);
      listed.insert({n, rel_boundary(m, region)});
      editor.roll_back();
    }
    CHECK(ways.size() == static_cast<std::size_t>(valence));
    for (const auto& [n, count] : ways) CHECK(count == std::map<StepKind, int>{{way, 2}, {StepKind::flip, 2}});
    CHECK(listed.size() == static_cast<std::size_t>(4 * valence));

    std::set<std::pair<VertexId, std::string>> found;
    for (const BasicOperation& op : exhausted(m)) {
      QuadMesh after = m;
      apply(after, op);
      const bool other = op.kind == (valence == 3 ? Kind::split : Kind::collapse);
      if (other || sorted_valences(after) != Valences{3, 5, valence}) continue;
      for (const VertexId n : m.neighbours(v)) {
        std::vector<VertexId> rest = irregular_vertices(after);
        std::erase(rest, n);
        if (rest.size() == 2 && after.valence(n) == valence && after.adjacent(rest[0], rest[1]))
          found.insert({n, rel_boundary(after, region)});
      }
    }
    CHECK(listed == found);
  }
}

TEST_CASE("section 5: an adjacent 3-5 pair moves in six directions", "[atomic]") {
  const Region region = pair_neighbourhood();
  QuadMesh m = region.mesh;
  Editor editor(m);
  const VertexId three = vertex_of(m, 3), five = vertex_of(m, 5);
  for (const HalfEdgeId along : {m.find_half_edge(three, five), m.find_half_edge(five, three)}) {
    std::map<StepKind, std::set<std::string>> listed;
    for (const AtomicChoice& choice : atomic_operations(editor, along)) {
      if (choice.operation.name.kind != AtomicKind::move_35) continue;
      CHECK(choice.refusal == Refusal::none);
      perform(editor, choice.operation);
      listed[choice.operation.name.step.kind].insert(rel_boundary(m, region));
      editor.roll_back();
    }
    std::map<StepKind, std::set<std::string>> found;
    for (const BasicOperation& op : exhausted(m)) {
      QuadMesh after = m;
      apply(after, op);
      const auto pair = irregular_vertices(after);
      if (sorted_valences(after) != Valences{3, 5} || !after.adjacent(pair[0], pair[1])) continue;
      const StepKind way = op.kind == Kind::collapse ? StepKind::collapse
                           : op.kind == Kind::split  ? StepKind::split
                                                     : StepKind::flip;
      found[way].insert(rel_boundary(after, region));
    }
    CHECK(listed == found);
    for (const auto& [way, results] : listed) CHECK(results.size() == 2);
    CHECK(listed.size() == 3);
  }
  // At either vertex of the pair the same six are listed.
  CHECK(count(atomic_operations(editor, three), AtomicKind::move_35) == 6);
  CHECK(count(atomic_operations(editor, five), AtomicKind::move_35) == 6);
}

TEST_CASE("section 5: one flip makes 3-3-5-5, each flip listed once", "[atomic]") {
  const Region region = neighbourhood(4);
  QuadMesh m = region.mesh;
  Editor editor(m);
  const VertexId v = vertex_of(m, 4);
  std::multiset<std::string> listed, found;
  for (const AtomicChoice& choice : atomic_operations(editor, v)) {
    if (choice.operation.name.kind != AtomicKind::generate_3355) continue;
    REQUIRE(perform(editor, choice.operation).refusal == Refusal::none);
    CHECK(sorted_valences(m) == Valences{3, 3, 5, 5});
    listed.insert(rel_boundary(m, region));
    editor.roll_back();
  }
  for (const BasicOperation& op : exhausted(m)) {
    const auto changed = changed_vertices(m, op);
    if (op.kind == Kind::collapse || op.kind == Kind::split) continue;
    if (std::find(changed.begin(), changed.end(), v) == changed.end()) continue;
    QuadMesh after = m;
    apply(after, op);
    found.insert(rel_boundary(after, region));
  }
  CHECK(listed.size() == 16);
  CHECK(listed == found);
}

TEST_CASE("Figure 5: type changes of any valence", "[atomic]") {
  for (int valence = 2; valence <= 9; ++valence) {
    INFO(valence);
    const Region region = neighbourhood(valence);
    QuadMesh m = region.mesh;
    Editor editor(m);
    const VertexId v = vertex_of(m, valence);
    const auto list = atomic_operations(editor, v);
    // One raise for each face; one lower for each diagonal of the polygon of the edges.
    CHECK(count(list, AtomicKind::raise) == static_cast<std::size_t>(valence));
    CHECK(count(list, AtomicKind::lower) == static_cast<std::size_t>(std::max(valence * (valence - 3) / 2, 0)));
    std::multiset<std::string> results;
    for (const AtomicChoice& choice : list) {
      const AtomicKind kind = choice.operation.name.kind;
      if (kind != AtomicKind::raise && kind != AtomicKind::lower) continue;
      REQUIRE(perform(editor, choice.operation).refusal == Refusal::none);
      CHECK((kind == AtomicKind::raise ? m.valence(v) > valence : m.valence(v) < valence));
      if (valence == 2) CHECK(sorted_valences(m) == Valences{3, 3});
      if (valence == 6 && choice.operation.name.turn == 3) CHECK(sorted_valences(m) == Valences{5, 5});
      results.insert(rel_boundary(m, region));
      editor.roll_back();
    }
    // The two faces of a v2 become one in both ways.
    const std::size_t different = std::set<std::string>(results.begin(), results.end()).size();
    CHECK(different == (valence == 2 ? 1 : results.size()));
    // All collapses at v and all splits of v that leave no v2 are there.
    std::multiset<std::string> found;
    for (const BasicOperation& op : exhausted(m)) {
      const auto changed = changed_vertices(m, op);
      QuadMesh after = m;
      const Applied done = apply(after, op);
      const bool raises = op.kind == Kind::collapse && (m.origin(op.h) == v || m.origin(QuadMesh::opposite(op.h)) == v);
      const bool lowers = op.kind == Kind::split && changed[0] == v && after.valence(v) > 2 &&
                          after.valence(after.origin(QuadMesh::opposite(done.made))) > 2;
      if (raises || lowers) found.insert(rel_boundary(after, region));
    }
    CHECK(results == found);
  }
}

TEST_CASE("atomic operations are refused with the reason", "[atomic]") {
  // Beside the boundary.
  Region grid = tests::grid(3, 3);
  Editor on_grid(grid.mesh);
  const VertexId corner(0), inner(5);  // (0,0) and (1,1)
  CHECK(atomic_operations(on_grid, corner).empty());
  for (const AtomicChoice& choice : atomic_operations(on_grid, inner)) {
    const HalfEdgeId along = choice.operation.along;
    const bool at_boundary =
        grid.mesh.is_boundary(grid.mesh.target(along)) || grid.mesh.is_boundary(grid.mesh.origin(along));
    if (at_boundary) CHECK(choice.refusal == EditRefusal::touches_boundary);
  }
  const AtomicName flip = *parse_atomic_name("generate-3355 flip left");
  CHECK(plan(on_grid, {flip, HalfEdgeId(1000)}).refusal == Refusal::dead_element);
  CHECK(plan(on_grid, {flip, HalfEdgeId()}).refusal == Refusal::dead_element);
  const HalfEdgeId middle = grid.mesh.find_half_edge(inner, VertexId(6));
  REQUIRE(middle.valid());
  CHECK(plan(on_grid, {flip, middle}).refusal == EditRefusal::touches_boundary);

  // Not what the name is about.
  Region region = neighbourhood(3);
  QuadMesh& m = region.mesh;
  const QuadMesh before = m;
  Editor editor(m);
  const VertexId v = vertex_of(m, 3);
  const HalfEdgeId along = m.out(v);
  CHECK(plan(editor, {*parse_atomic_name("move-v5 flip left"), along}).refusal == EditRefusal::wrong_valences);
  CHECK(plan(editor, {*parse_atomic_name("generate-3355 flip left"), along}).refusal == EditRefusal::wrong_valences);
  CHECK(plan(editor, {*parse_atomic_name("lower split left 3"), along}).refusal == EditRefusal::wrong_valences);
  CHECK(plan(editor, {*parse_atomic_name("lower split left 2"), along}).refusal == Refusal::none);
  CHECK(plan(editor, {{AtomicKind::move_v3, {StepKind::split, Hand::left}, 0}, along}).refusal ==
        EditRefusal::no_such_step);
  // With a v3 at the far corner of a face, a v3 cannot become a v5 there.
  REQUIRE(perform(editor, {*parse_atomic_name("move-v3 flip left"), along}).refusal == Refusal::none);
  const HalfEdgeId back = m.find_half_edge(before.target(along), v);
  REQUIRE(back.valid());
  bool in_the_way = false;
  for (const AtomicChoice& choice : atomic_operations(editor, m.origin(back)))
    in_the_way = in_the_way || choice.refusal == EditRefusal::irregular_in_the_way;
  CHECK(in_the_way);
  editor.roll_back();
  CHECK(m == before);
}

TEST_CASE("atomic operations keep features, or say that they can not", "[atomic]") {
  Region region = neighbourhood(3);
  QuadMesh& m = region.mesh;
  const VertexId v = vertex_of(m, 3);
  const HalfEdgeId along = m.out(v);
  const VertexId w = m.target(along);
  const VertexId c = m.target(m.next(along));
  const auto refusal_of = [&](const FeatureSet& features, const std::string& name) {
    const Editor editor(m, &features);
    return plan(editor, {*parse_atomic_name(name), along}).refusal;
  };
  // The flip on the left turns the edge w - c; on the right it does not.
  FeatureSet opposite;
  opposite.insert(w, c);
  CHECK(refusal_of(opposite, "move-v3 flip left") == FeatureRefusal::breaks_feature);
  CHECK(refusal_of(opposite, "move-v3 flip right") == Refusal::none);
  // A collapse removes v, or c if v is on a feature, or neither if both are.
  FeatureSet own;
  own.insert(v, w);
  CHECK(refusal_of(own, "move-v3 collapse left") == FeatureRefusal::breaks_feature);
  FeatureSet both = own;
  both.insert(w, c);
  for (const FeatureSet& features : {own, both}) {
    QuadMesh copy = m;
    Editor editor(copy, &features);
    int collapses = 0;
    for (const AtomicChoice& choice : atomic_operations(editor, along)) {
      if (to_string(choice.operation.name) != "move-v3 collapse left") continue;
      ++collapses;
      CHECK(choice.operation.swapped == (features.size() == 1));
      REQUIRE(choice.refusal == (features.size() == 1 ? Refusal::none : FeatureRefusal::breaks_feature));
      const AtomicReport report = perform(editor, choice.operation);
      CHECK(copy.adjacent(v, w));
      if (report.refusal != Refusal::none) continue;
      CHECK_FALSE(copy.is_live(c));
      CHECK(perform(editor, report.inverse).refusal == Refusal::none);
      CHECK(copy == m);
    }
    CHECK(collapses == 1);
  }
}

TEST_CASE("requad-edit atomic lists, makes and refuses", "[atomic][programs]") {
  using nlohmann::json;
  const Region region = neighbourhood(3);
  tests::spill(tests::scratch() / "v3.obj", obj_text(region));
  const VertexId v = vertex_of(region.mesh, 3);
  const VertexId w = region.mesh.target(region.mesh.out(v));
  const std::string at = "atomic v3.obj " + std::to_string(v.index() + 1);
  const std::string outer = std::to_string(region.mesh.origin(region.root).index() + 1);
  const std::string along = at + " " + std::to_string(w.index() + 1);

  const tests::Outcome listed = tests::call("edit", at + " --json -");
  REQUIRE(listed.code == 0);
  const json operations = json::parse(listed.out)["operations"];
  CHECK(operations.size() == 12 + 3);
  std::set<std::string> names;
  for (const json& operation : operations) {
    names.insert(operation["operation"]);
    CHECK(operation["from"] == v.index() + 1);
    CHECK(operation["legal"] == true);
    CHECK(parse_atomic_name(operation["inverse"].get<std::string>()));
    CHECK(operation["valences"].size() == 4);
  }
  CHECK(names == std::set<std::string>{"move-v3 collapse left", "move-v3 collapse right", "move-v3 flip left",
                                       "move-v3 flip right", "raise collapse left"});
  CHECK(json::parse(tests::call("edit", along + " --json -").out)["operations"].size() == 4 + 2);
  CHECK(tests::call("edit", at).out.find("v3 -> gone") != std::string::npos);

  const tests::Outcome made = tests::call("edit", along + " --make 'move-v3 flip left' -o moved.obj --json -");
  REQUIRE(made.code == 0);
  const json report = json::parse(made.out);
  CHECK(report["inverse"] == "remove-35-v3 flip right");
  CHECK(report["before"]["interior_irregular"] == 1);
  CHECK(report["after"]["interior_irregular"] == 3);
  const std::string valences = tests::call("edit", "info moved.obj").out;
  CHECK(valences.find("v3:2") != std::string::npos);
  CHECK(valences.find("v5:1") != std::string::npos);

  for (const auto& [arguments, code, why] : std::vector<std::tuple<std::string, int, std::string>>{
           {along + " --make 'move-v5 flip left' -o no.obj", 1, "the valences that this needs"},
           {"atomic v3.obj " + outer, 1, "a boundary vertex would change its valence"},
           {at + " --make 'move-v3 flip left' -o no.obj", 2, "along several edges"},
           {at + " --make 'move-35 flip left' -o no.obj", 2, "there is no 'move-35 flip left' here"},
           {along + " --make 'dance' -o no.obj", 2, "no atomic operation"},
           {along + " --make 'move-v3 flip left'", 2, "-o is missing"},
           {at + " " + outer, 2, "no edge joins"},
           {at + " 999999", 2, "there is no vertex 999999"},
           {"atomic v3.obj", 2, "atomic: expected IN V [W]"}}) {
    INFO(arguments);
    const tests::Outcome outcome = tests::call("edit", arguments);
    CHECK(outcome.code == code);
    CHECK(outcome.err.find(why) != std::string::npos);
    CHECK(tests::line_count(outcome.err) == 1);
  }
  CHECK_FALSE(std::filesystem::exists(tests::scratch() / "no.obj"));
}
