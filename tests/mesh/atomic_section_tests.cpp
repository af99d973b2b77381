// Atomic operations compared with section 5 of the paper. The listed operations are compared with all basic operations.
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "mesh/irregular/atomic_operations.hpp"
#include "mesh/topology/separatrix.hpp"
#include "tests/mesh/neighbourhoods.hpp"
#include "tests/support/catch.hpp"

using namespace requad;
using namespace requad::mesh;
using requad::tests::neighbourhood;
using requad::tests::pair_neighbourhood;
using requad::tests::rel_boundary;
using requad::tests::vertex_of;

namespace {

using Kind = BasicOperation::Kind;
using StepKind = TransportStep::Kind;
using Valences = std::multiset<int>;

std::size_t count(const std::vector<AtomicChoice>& list, AtomicKind kind) {
  return static_cast<std::size_t>(
      std::count_if(list.begin(), list.end(), [=](const AtomicChoice& c) { return c.operation.name.kind == kind; }));
}

}  // namespace

TEST_CASE("section 5: a v3 moves in three directions, a v5 in five, each by four operations", "[atomic]") {
  // The four are two flips, and two collapses for a v3 or two splits for a v5. A search through all basic operations
  // finds the same operations and the same results.
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
    for (const BasicOperation& op : operations_inside(m)) {
      QuadMesh after = m;
      apply(after, op);
      const bool other = op.kind == (valence == 3 ? Kind::split : Kind::collapse);
      if (other || sorted_irregular_valences(after) != Valences{3, 5, valence}) continue;
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
    for (const BasicOperation& op : operations_inside(m)) {
      QuadMesh after = m;
      apply(after, op);
      const auto pair = irregular_vertices(after);
      if (sorted_irregular_valences(after) != Valences{3, 5} || !after.adjacent(pair[0], pair[1])) continue;
      const StepKind way = op.kind == Kind::collapse ? StepKind::collapse
                           : op.kind == Kind::split  ? StepKind::split
                                                     : StepKind::flip;
      found[way].insert(rel_boundary(after, region));
    }
    CHECK(listed == found);
    for (const auto& [way, results] : listed) CHECK(results.size() == 2);
    CHECK(listed.size() == 3);
  }
  // The same six operations are listed at either vertex of the pair.
  CHECK(count(atomic_operations(editor, three), AtomicKind::move_35) == 6);
  CHECK(count(atomic_operations(editor, five), AtomicKind::move_35) == 6);
}

TEST_CASE("section 5: one flip makes 3-3-5-5, and each such flip is listed once", "[atomic]") {
  const Region region = neighbourhood(4);
  QuadMesh m = region.mesh;
  Editor editor(m);
  const VertexId v = vertex_of(m, 4);
  std::multiset<std::string> listed, found;
  for (const AtomicChoice& choice : atomic_operations(editor, v)) {
    if (choice.operation.name.kind != AtomicKind::generate_3355) continue;
    REQUIRE(perform(editor, choice.operation).refusal == Refusal::none);
    CHECK(sorted_irregular_valences(m) == Valences{3, 3, 5, 5});
    listed.insert(rel_boundary(m, region));
    editor.roll_back();
  }
  for (const BasicOperation& op : operations_inside(m)) {
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
    // There is one raise for each face. There is one lower for each pair of edges that are not neighbours.
    CHECK(count(list, AtomicKind::raise) == static_cast<std::size_t>(valence));
    CHECK(count(list, AtomicKind::lower) == static_cast<std::size_t>(std::max(valence * (valence - 3) / 2, 0)));
    std::multiset<std::string> results;
    for (const AtomicChoice& choice : list) {
      const AtomicKind kind = choice.operation.name.kind;
      if (kind != AtomicKind::raise && kind != AtomicKind::lower) continue;
      REQUIRE(perform(editor, choice.operation).refusal == Refusal::none);
      CHECK((kind == AtomicKind::raise ? m.valence(v) > valence : m.valence(v) < valence));
      if (valence == 2) CHECK(sorted_irregular_valences(m) == Valences{3, 3});
      if (valence == 6 && choice.operation.name.turn == 3) CHECK(sorted_irregular_valences(m) == Valences{5, 5});
      results.insert(rel_boundary(m, region));
      editor.roll_back();
    }
    // Both raises of a v2 give the same mesh.
    const std::size_t different = std::set<std::string>(results.begin(), results.end()).size();
    CHECK(different == (valence == 2 ? 1 : results.size()));
    // These are all collapses at v, and all splits of v that leave no v2.
    std::multiset<std::string> found;
    for (const BasicOperation& op : operations_inside(m)) {
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
