// The costs of operations, which are counted and not timed: words of the mesh's arrays that change, and allocations.
// Law
// topology-9 (mesh/topology/basic_operations.hpp) and enumerate/search/backtracking.hpp state the bounds.
#include <optional>

#include "enumerate/search/backtracking.hpp"
#include "mesh/topology/basic_operations.hpp"
#include "tests/support/allocations.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/enumerate/census.hpp"
#include "tests/support/mesh/meshes.hpp"

using namespace requad;
using namespace requad::mesh;

namespace {

using Kind = BasicOperation::Kind;

template <class Work>
std::int64_t allocations_of(Work&& work) {
  const std::int64_t before = tests::allocations();
  work();
  return tests::allocations() - before;
}

struct Words {
  int twins = 0, origins = 0, outs = 0;
};

// The number of words that differ. If only one mesh has an element, all its words count.
Words words_changed(const QuadMesh& a, const QuadMesh& b) {
  Words n;
  for (int i = 0; i < std::max(a.half_edge_capacity(), b.half_edge_capacity()); ++i) {
    const HalfEdgeId h(i);
    const bool in_both = i < std::min(a.half_edge_capacity(), b.half_edge_capacity());
    n.twins += !in_both || a.twin(h) != b.twin(h) ? 1 : 0;
    n.origins += !in_both || a.origin(h) != b.origin(h) ? 1 : 0;
  }
  for (int i = 0; i < std::max(a.vertex_capacity(), b.vertex_capacity()); ++i) {
    const VertexId v(i);
    const bool in_both = i < std::min(a.vertex_capacity(), b.vertex_capacity());
    n.outs += !in_both || a.out(v) != b.out(v) ? 1 : 0;
  }
  return n;
}

// Law topology-9 in numbers. A face has 4 twins and 4 origins.
void check_words(const QuadMesh& before, const BasicOperation& op) {
  QuadMesh after = before;
  INFO(to_string(op));
  if (apply(after, op).refusal != Refusal::none) return;
  const Words n = words_changed(before, after);
  if (op.kind == Kind::flip_ccw || op.kind == Kind::flip_cw) {
    // A flip changes two twins of each face and two outer twins. At vertices, it changes the ends before and after.
    CHECK(n.twins <= 6);
    CHECK(n.origins == 2);
    CHECK(n.outs <= 4);
  } else {
    // A collapse or a split changes the face, the twins of its four neighbours, and the other faces at the vertex.
    const bool is_split = op.kind == Kind::split;
    const QuadMesh& with = is_split ? after : before;
    const HalfEdgeId made = is_split ? QuadMesh::half_edge(FaceId(after.face_capacity() - 1), 0) : op.h;
    const int around = with.face_valence(with.origin(QuadMesh::opposite(made))) - 1;
    CHECK(n.twins <= 8);
    CHECK(n.origins == 4 + around);
    CHECK(n.outs <= 4);
  }
}

void check_words_at_all_sites(const QuadMesh& m) {
  for (const HalfEdgeId h : m.half_edges()) {
    check_words(m, {Kind::flip_ccw, h, {}, 0});
    check_words(m, {Kind::flip_cw, h, {}, 0});
    check_words(m, {Kind::collapse, h, {}, 0});
    m.for_each_out(m.origin(h), [&](HalfEdgeId g) { check_words(m, {Kind::split, h, QuadMesh::previous(g), 0}); });
  }
}

}  // namespace

TEST_CASE("law topology-9: a basic operation changes few words", "[operations][costs]") {
  for (const tests::CensusEntry& entry : tests::census(10, true)) check_words_at_all_sites(entry.region.mesh);
  check_words_at_all_sites(tests::cube());
  check_words_at_all_sites(tests::torus(4, 5));
  check_words_at_all_sites(tests::torus(12, 9));  // as many on a larger mesh
}

TEST_CASE("basic operations and traversal allocate nothing", "[operations][costs]") {
  QuadMesh m = tests::torus(16, 16);
  // This shows that the counter works.
  std::optional<QuadMesh> copy;
  REQUIRE(allocations_of([&] { copy.emplace(m); }) >= 2);
  REQUIRE(*copy == m);

  const int half_edges = m.half_edge_capacity();
  int made = 0;
  CHECK(allocations_of([&] {
          for (int i = 0; i < half_edges; ++i) {
            const HalfEdgeId h(i);
            flip_unchecked(m, h, Rotation::counter_clockwise);
            flip_unchecked(m, QuadMesh::next(h), Rotation::clockwise);
            made += flip(m, h, Rotation::clockwise) == Refusal::none ? 1 : 0;
            made += flip(m, QuadMesh::previous(h), Rotation::counter_clockwise) == Refusal::none ? 1 : 0;
          }
        }) == 0);
  CHECK(made == 2 * half_edges);

  const auto close_and_open = [&m, &made](HalfEdgeId h, bool checked) {
    const HalfEdgeId first = m.twin(QuadMesh::next(h));
    const HalfEdgeId last = m.twin(QuadMesh::opposite(h));
    if (checked) {
      made += collapse(m, h) == Refusal::none ? 1 : 0;
      made += split(m, first, last, h.index() & 3).refusal == Refusal::none ? 1 : 0;
    } else {
      collapse_unchecked(m, h);
      split_unchecked(m, first, last, h.index() & 3);
    }
  };
  close_and_open(HalfEdgeId(0), true);  // the free lists grow to their size
  made = 0;
  CHECK(allocations_of([&] {
          for (int i = 0; i < half_edges; ++i) {
            close_and_open(HalfEdgeId(i), true);
            close_and_open(HalfEdgeId(i), false);
          }
        }) == 0);
  CHECK(made == 2 * half_edges);
  CHECK(m == tests::torus(16, 16));

  // Operations as data, which return their inverses.
  CHECK(allocations_of([&] {
          for (int i = 0; i < half_edges; ++i) {
            for (const Kind kind : {Kind::flip_ccw, Kind::flip_cw, Kind::collapse}) {
              const Applied done = apply(m, {kind, HalfEdgeId(i), {}, 0});
              made -= done.refusal == Refusal::none && apply(m, done.inverse).refusal == Refusal::none ? 0 : 1;
            }
          }
        }) == 0);
  CHECK(made == 2 * half_edges);

  std::int64_t seen = 0;
  CHECK(allocations_of([&] {
          for (int i = 0; i < m.vertex_capacity(); ++i) {
            const VertexId v(i);
            m.for_each_out(v, [&](HalfEdgeId h) { seen += m.target(m.straight(h)) == v ? 1 : 0; });
            seen += m.valence(v) + (m.adjacent(v, m.target(m.out(v))) ? 1 : 0);
          }
        }) == 0);
  CHECK(seen == 16 * 16 * 5);
}

TEST_CASE("the search allocates nothing once its stacks have their size", "[search][costs]") {
  using enumerate::BacktrackingSearch;
  const auto count = [](const std::vector<int>& sides, const std::vector<int>& irregular) {
    enumerate::SearchControl control{enumerate::SearchLimits()};
    enumerate::PartialMesh start(irregular);
    std::vector<enumerate::PartialMesh::BoundaryVertex> ring;
    for (const int quads : enumerate::search_problem(sides, irregular).interior_quads)
      ring.push_back({start.add_vertex(), quads});
    const int length = static_cast<int>(ring.size());
    for (int i = 0; i < length; ++i) start.add_edge(i, (i + 1) % length);
    start.open_hole(ring);
    REQUIRE(enumerate::may_be_filled(start, control.pruning));
    BacktrackingSearch search(start, control);
    std::int64_t fillings = 0;
    const BacktrackingSearch::Visit visit = [&fillings](const enumerate::Filling&) { ++fillings; };
    const std::atomic<bool> wanted = false;
    const BacktrackingSearch::WorkSharing sharing{wanted, {}};
    const BacktrackingSearch::GuidingPath root = search.guiding_path();
    REQUIRE(search.run(visit, sharing));
    const std::int64_t states = search.states();
    const std::int64_t found = fillings;
    search.go_to(root);
    CHECK(allocations_of([&] { search.run(visit, sharing); }) == 0);
    CHECK(search.states() == states);
    CHECK(fillings == 2 * found);
    return states;
  };
  CHECK(count({10, 10}, {3, 3}) > 1000);
  CHECK(count({5, 5, 5, 5, 5, 5}, {5, 5}) > 1000);
  CHECK(count({6, 6, 6}, {3, 3, 5}) > 1000);
}
