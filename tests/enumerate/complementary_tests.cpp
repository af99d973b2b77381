// Transported pairs and the complementary operations (section 8), on every configuration of a region.
#include <array>
#include <map>
#include <set>

#include "enumerate/exploration.hpp"
#include "enumerate/generators.hpp"
#include "enumerate/search/search.hpp"
#include "mesh/irregular/complementary_operations.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"

using namespace requad;
using namespace requad::mesh;
using requad::tests::irregular_valences;

TEST_CASE("where nothing is in the way, transport gives the same as pair moves", "[transport]") {
  // Every transport leads to a configuration that moves found. At some, transports reach all that a pair move reaches.
  const theory::Configuration start{{1, 1, theory::IntegerVector::Constant(6, 2)}, 1};
  const auto found = enumerate::explore({theory::kHexagon, theory::region_sides(theory::kHexagon, start)},
                                        {enumerate::glue_region(theory::kHexagon, start)});
  std::map<int, std::set<std::string>> by_moves, by_transport;
  for (const auto& move : found.moves) {
    if (move.to >= 0 && found.holds_pair(move.to) && found.holds_pair(move.from))
      by_moves[move.from].insert(found.nodes[static_cast<std::size_t>(move.to)].signature);
  }
  for (std::size_t i = 0; i < found.nodes.size(); ++i) {
    if (!found.holds_pair(static_cast<int>(i))) continue;
    const Region& region = found.nodes[i].region;
    QuadMesh m = region.mesh;
    Editor editor(m);
    PairTransport transport(editor);
    const auto pair = irregular_vertices(m);
    for (int k = 0; k < 2; ++k) {
      std::vector<HalfEdgeId> starts;
      m.for_each_out(pair[static_cast<std::size_t>(k)], [&](HalfEdgeId h) { starts.push_back(m.twin(h)); });
      for (const HalfEdgeId first : starts) {
        if (transport.carry({first}, std::array{pair[static_cast<std::size_t>(1 - k)]}).refusal != Refusal::none)
          continue;
        CHECK(validate(m).empty());
        by_transport[static_cast<int>(i)].insert(signature(m, m.out(region.mesh.origin(region.root))));
        editor.roll_back();
        CHECK(m == region.mesh);
      }
    }
  }
  std::set<std::string> known;
  for (const auto& node : found.nodes) known.insert(node.signature);
  int same = 0;
  for (const auto& [node, results] : by_transport) {
    for (const auto& result : results) CHECK(known.count(result) == 1);
    same += std::includes(results.begin(), results.end(), by_moves[node].begin(), by_moves[node].end()) ? 1 : 0;
  }
  CHECK(by_moves.size() > 4);
  CHECK(same > 0);
}

TEST_CASE("section 8: a 3-5 pair is cancelled with a third vertex, and never without one", "[complementary]") {
  // By exhaustive search, a triangle of side 6 has 75 fillings with 3-3-5, and one with a single v3.
  enumerate::SearchLimits limits;
  limits.threads = 1;
  int fillings = 0;
  enumerate::search(enumerate::search_problem({6, 6, 6}, {3, 3, 5}), limits, [&](const enumerate::Filling& f) {
    ++fillings;
    const Region region = enumerate::region_of(f);
    QuadMesh m = region.mesh;
    Editor editor(m);
    PairTransport transport(editor);
    std::vector<VertexId> threes;
    VertexId five;
    for (const VertexId v : irregular_vertices(m)) {
      if (m.valence(v) == 5) five = v;
      if (m.valence(v) == 3) threes.push_back(v);
    }
    CHECK(cancel_pair(editor, transport, threes[0], five, {}).refusal == EditRefusal::lone_pair);
    CHECK(cancel_pair(editor, transport, five, threes[0], {threes[1]}).refusal == EditRefusal::wrong_valences);
    CHECK(m == region.mesh);
    // An effort that allows nothing is refused.
    CHECK(cancel_pair(editor, transport, threes[0], five, {threes[1]}, {}, {-1, 3}).refusal == EditRefusal::no_path);
    CHECK(m == region.mesh);
    const Cancellation done = cancel_pair(editor, transport, threes[0], five, {threes[1]});
    REQUIRE(done.refusal == Refusal::none);
    CHECK(done.transports >= graph_distance(region.mesh, threes[0], five));
    CHECK(irregular_valences(m) == std::map<int, int>{{3, 1}});
    CHECK(done.helpers == irregular_vertices(m));
    // It can be made again, transport by transport.
    const QuadMesh cancelled = m;
    editor.roll_back();
    CHECK(m == region.mesh);
    std::vector<std::size_t> marks;
    CHECK(repeat(editor, done, [&](std::size_t mark) { return marks.push_back(mark), true; }));
    CHECK(m == cancelled);
    REQUIRE(static_cast<int>(marks.size()) == done.transports);
    CHECK(marks[0] == 0);
    for (std::size_t i = 1; i < marks.size(); ++i) CHECK(marks[i] == done.ends[i - 1]);
    CHECK(static_cast<int>(done.ends.back()) == done.steps);
    // It can be left off after a transport.
    editor.roll_back();
    CHECK_FALSE(repeat(editor, done, [](std::size_t) { return false; }));
    CHECK(editor.mark() == done.ends[0]);
    editor.roll_back();
    REQUIRE(repeat(editor, done, [](std::size_t) { return true; }));
    CHECK(m.vertex_count() - m.face_count() == region.mesh.vertex_count() - region.mesh.face_count());
  });
  CHECK(fillings == 75);
}

TEST_CASE("section 8: pairs are merged and aligned, or refused with the reason", "[complementary]") {
  const auto irregular_of = [](const QuadMesh& m) { return irregular_vertices(m); };
  for (const auto& [type, merged] : {std::pair{theory::kDigon, 2}, std::pair{theory::kHexagon, 6}}) {
    for (const theory::Configuration& c : theory::parameter_set(theory::RegionShape::regular(type, 7 + merged % 4))) {
      const Region region = enumerate::glue_region(type, c);
      QuadMesh m = region.mesh;
      Editor editor(m);
      auto pair = irregular_of(m);
      const PairResult aligned = align_pair(editor, pair[0], pair[1]);
      REQUIRE(aligned.refusal == Refusal::none);
      CHECK(aligned.frame.degenerate());
      pair = irregular_of(m);
      CHECK(pair.size() == 2);
      const PairResult result = merge_pair(editor, pair[0], pair[1]);
      if ((c.d1() + c.d2()) % 2 == 0) {
        REQUIRE(result.refusal == Refusal::none);
        CHECK(irregular_valences(m) == std::map<int, int>{{merged, 1}});
        // One operation parts the vertex into a pair again (Figure 5).
        CHECK(part_vertex(editor, irregular_of(m)[0]) == Refusal::none);
        CHECK(irregular_valences(m) == std::map<int, int>{{merged == 2 ? 3 : 5, 2}});
      } else {
        CHECK(result.refusal == EditRefusal::odd_distance);
      }
      editor.roll_back();
      CHECK(m == region.mesh);
      CHECK(merge_pair(editor, pair[0], pair[0]).refusal == EditRefusal::wrong_valences);
    }
  }
}
