// QuadMesh: building, traversal, and the validator on meshes with each defect that it names.
#include "mesh/topology/basic_operations.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"

using namespace requad::mesh;
using requad::tests::cube;
using requad::tests::FaceList;
using requad::tests::grid;
using requad::tests::torus;

namespace {

std::string build_error(int vertices, const FaceList& faces) {
  try {
    QuadMesh::from_faces(vertices, faces);
  } catch (const MeshError& error) {
    return error.what();
  }
  return "";
}

// The arrays of a 2 x 1 grid, to be damaged.
struct Arrays {
  std::vector<HalfEdgeId> twin, out;
  std::vector<VertexId> origin;
  Arrays() {
    const QuadMesh m = grid(2, 1).mesh;
    for (int h = 0; h < m.half_edge_capacity(); ++h) {
      twin.push_back(m.twin(HalfEdgeId(h)));
      origin.push_back(m.origin(HalfEdgeId(h)));
    }
    for (int v = 0; v < m.vertex_capacity(); ++v) out.push_back(m.out(VertexId(v)));
  }
  std::vector<Defect> check() const { return validate(QuadMesh::from_arrays_unchecked(twin, origin, out)); }
};

bool reports(const std::vector<Defect>& defects, Defect::Kind kind) {
  for (const Defect& d : defects) {
    if (d.kind == kind) return !d.message.empty();
  }
  return false;
}

}  // namespace

TEST_CASE("handles are distinct types", "[mesh]") {
  static_assert(!std::is_convertible_v<VertexId, FaceId>);
  static_assert(!std::is_convertible_v<int, VertexId>);
  CHECK_FALSE(VertexId().valid());
  CHECK(VertexId(0).valid());
}

TEST_CASE("closed meshes and disks have their counts", "[mesh]") {
  const QuadMesh c = cube();
  CHECK(validate(c).empty());
  CHECK(euler_characteristic(c) == 2);
  CHECK(boundary_loop_count(c) == 0);
  CHECK(c.edge_count() == 12);
  for (const VertexId v : c.vertices()) CHECK(c.valence(v) == 3);

  const QuadMesh t = torus(4, 5);
  CHECK(validate(t).empty());
  CHECK(euler_characteristic(t) == 0);
  CHECK(component_count(t) == 1);

  const QuadMesh g = grid(3, 2).mesh;
  CHECK(validate(g).empty());
  CHECK(euler_characteristic(g) == 1);
  CHECK(boundary_loop_count(g) == 1);
  CHECK(g.edge_count() == 3 * 3 + 4 * 2);
}

TEST_CASE("traversal", "[mesh]") {
  const Region r = grid(3, 3);
  const QuadMesh& m = r.mesh;
  CHECK(m.origin(r.root) == VertexId(0));
  CHECK(m.is_boundary(r.root));
  int corners = 0;
  for (const VertexId v : m.vertices()) {
    const auto around = m.neighbours(v);
    CHECK(static_cast<int>(around.size()) == m.valence(v));
    for (const VertexId w : around) {
      CHECK(m.adjacent(v, w));
      CHECK(m.adjacent(w, v));
    }
    corners += m.valence(v) == 2 ? 1 : 0;
  }
  CHECK(corners == 4);
  CHECK_FALSE(m.adjacent(VertexId(0), VertexId(5)));
  for (const HalfEdgeId h : m.half_edges()) {
    CHECK(m.previous(m.next(h)) == h);
    CHECK(m.opposite(h) == m.next(m.next(h)));
    if (m.ccw(h).valid()) CHECK(m.cw(m.ccw(h)) == h);
  }
  // A straight path leads from the middle of one side to the other: vertices (0,1) (1,1) (2,1) (3,1).
  HalfEdgeId h = m.find_half_edge(VertexId(1), VertexId(5));
  h = m.straight(h);
  CHECK(m.target(h) == VertexId(9));
  h = m.straight(h);
  CHECK(m.target(h) == VertexId(13));
}

TEST_CASE("from_faces refuses what is no quad mesh", "[mesh]") {
  CHECK(build_error(4, {{0, 1, 2, 4}}).find("not in 0..3") != std::string::npos);
  CHECK(build_error(4, {{0, 1, 2, -1}}).find("not in 0..3") != std::string::npos);
  CHECK(build_error(4, {{0, 1, 0, 3}}).find("twice") != std::string::npos);
  CHECK(build_error(4, {{0, 0, 1, 3}}).find("twice") != std::string::npos);
  CHECK(build_error(5, {{0, 1, 2, 3}}).find("no face") != std::string::npos);
  CHECK(build_error(6, {{0, 1, 2, 3}, {0, 1, 4, 5}}).find("not oriented alike") != std::string::npos);
  CHECK(build_error(8, {{0, 1, 2, 3}, {1, 0, 4, 5}, {0, 1, 6, 7}}).find("3 faces") != std::string::npos);
  CHECK(build_error(7, {{0, 1, 2, 3}, {0, 4, 5, 6}}).find("not manifold") != std::string::npos);
  // A Moebius band of three quads.
  CHECK(build_error(6, {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 3, 0, 5}}).find("not oriented alike") != std::string::npos);
}

TEST_CASE("the validator names each kind of defect", "[mesh]") {
  CHECK(Arrays().check().empty());
  using DefectKind = Defect::Kind;
  const auto h = [](int i) { return HalfEdgeId(i); };

  SECTION("sizes") {
    Arrays a;
    a.origin.pop_back();
    a.twin.pop_back();
    CHECK(reports(a.check(), DefectKind::sizes));
  }
  SECTION("origin out of range") {
    Arrays a;
    a.origin[2] = VertexId(99);
    CHECK(reports(a.check(), DefectKind::range));
  }
  SECTION("twin out of range") {
    Arrays a;
    a.twin[2] = h(1000);
    CHECK(reports(a.check(), DefectKind::range));
  }
  SECTION("out of range") {
    Arrays a;
    a.out[0] = h(77);
    CHECK(reports(a.check(), DefectKind::range));
  }
  SECTION("half deleted face") {
    Arrays a;
    a.origin[5] = VertexId();
    CHECK(reports(a.check(), DefectKind::half_deleted));
  }
  SECTION("a half-edge out of a deleted vertex") {
    Arrays a;
    a.out[1] = h(-1);
    CHECK(reports(a.check(), DefectKind::isolated));
  }
  SECTION("a vertex without a face") {
    Arrays a;
    a.out.push_back(h(0));
    CHECK(reports(a.check(), DefectKind::isolated));
  }
  SECTION("twin with itself") {
    Arrays a;
    a.twin[0] = h(0);
    CHECK(reports(a.check(), DefectKind::twin));
  }
  SECTION("twin that does not answer") {
    Arrays a;
    a.twin[0] = h(5);
    CHECK(reports(a.check(), DefectKind::twin));
  }
  SECTION("twins that do not meet") {
    Arrays a;
    // Two boundary half-edges of different faces that have no vertices in common.
    std::vector<int> free;
    for (int i = 0; i < 8; ++i) {
      if (!a.twin[static_cast<std::size_t>(i)].valid()) free.push_back(i);
    }
    a.twin[static_cast<std::size_t>(free.front())] = h(free.back());
    a.twin[static_cast<std::size_t>(free.back())] = h(free.front());
    CHECK(reports(a.check(), DefectKind::twin_ends));
  }
  SECTION("out of another vertex") {
    Arrays a;
    std::swap(a.out[0], a.out[5]);
    CHECK(reports(a.check(), DefectKind::out));
  }
  SECTION("a boundary fan that starts inside") {
    Arrays a;
    for (std::size_t v = 0; v < a.out.size(); ++v) {
      for (int i = 0; i < 8; ++i) {
        const auto slot = static_cast<std::size_t>(i);
        if (a.origin[slot] == VertexId(static_cast<int>(v)) && a.twin[slot].valid()) a.out[v] = h(i);
      }
    }
    CHECK(reports(a.check(), DefectKind::out));
  }
  SECTION("two fans at one vertex") {
    // Two separate quads whose corners 0 are renamed to one vertex.
    const QuadMesh m = QuadMesh::from_faces(8, FaceList{{0, 1, 2, 3}, {4, 5, 6, 7}});
    Arrays a;
    a.twin.assign(8, h(-1));
    a.origin.clear();
    for (int i = 0; i < 8; ++i) a.origin.push_back(i == 4 ? VertexId(0) : m.origin(h(i)));
    a.out = {h(0), h(1), h(2), h(3), h(-1), h(5), h(6), h(7)};
    CHECK(reports(a.check(), DefectKind::fan));
  }
  SECTION("a vertex twice in a face") {
    Arrays a;
    const VertexId keep = a.origin[0];
    a.origin[2] = keep;
    CHECK(reports(a.check(), DefectKind::repeated_vertex));
  }
  SECTION("two edges between the same vertices") {
    // Both quads have an edge 0-1, but they are not glued along it.
    const QuadMesh m = QuadMesh::from_faces(8, FaceList{{0, 1, 2, 3}, {4, 5, 6, 7}});
    Arrays a;
    a.twin.assign(8, h(-1));
    a.origin.clear();
    for (int i = 0; i < 8; ++i) a.origin.push_back(i == 4 ? VertexId(0) : i == 5 ? VertexId(1) : m.origin(h(i)));
    a.out = {h(0), h(1), h(2), h(3), h(-1), h(-1), h(6), h(7)};
    CHECK(reports(a.check(), DefectKind::repeated_edge));
  }
}

TEST_CASE("the validator ends, whatever the arrays hold", "[mesh]") {
  std::mt19937 random(20120713);
  for (int round = 0; round < 3000; ++round) {
    const int faces = std::uniform_int_distribution<int>(0, 4)(random);
    const int vertices = std::uniform_int_distribution<int>(0, 6)(random);
    std::uniform_int_distribution<int> half_edge(-1, 4 * faces + 1), vertex(-1, vertices);
    std::vector<HalfEdgeId> twin, out;
    std::vector<VertexId> origin;
    for (int i = 0; i < 4 * faces; ++i) twin.emplace_back(half_edge(random));
    for (int i = 0; i < 4 * faces; ++i) origin.emplace_back(vertex(random));
    for (int i = 0; i < vertices; ++i) out.emplace_back(half_edge(random));
    const auto defects = validate(QuadMesh::from_arrays_unchecked(twin, origin, out));
    for (const Defect& d : defects) REQUIRE(d.message.find('\n') == std::string::npos);
  }
}

TEST_CASE("a mesh gets its earlier ids back", "[mesh]") {
  // By hand: two vertices and a face are removed, so later ones get lower numbers when the mesh is written.
  QuadMesh m = torus(4, 4);
  REQUIRE(collapse(m, HalfEdgeId(4 * 5 + 1)) == Refusal::none);
  REQUIRE(collapse(m, HalfEdgeId(4 * 2)) == Refusal::none);
  const QuadMesh compact = QuadMesh::from_faces(14, m.compact_faces());
  std::vector<VertexId> free_vertices;
  for (const int f : {5, 2}) {
    const QuadMesh whole = torus(4, 4);
    free_vertices.push_back(whole.origin(QuadMesh::half_edge(FaceId(f), f == 5 ? 3 : 2)));
  }
  const QuadMesh again = compact.with_free_ids({FaceId(5), FaceId(2)}, free_vertices);
  CHECK(validate(again).empty());
  CHECK(again == m);
  std::swap(free_vertices[0], free_vertices[1]);
  const QuadMesh other_order = compact.with_free_ids({FaceId(5), FaceId(2)}, free_vertices);
  CHECK(validate(other_order).empty());
  CHECK_FALSE(other_order == m);
  CHECK(compact.with_free_ids({}, {}) == compact);
  // An id that is given twice, no id, and an id beyond the last one.
  CHECK_THROWS_AS(compact.with_free_ids({FaceId(5), FaceId(5)}, {}), MeshError);
  CHECK_THROWS_AS(compact.with_free_ids({FaceId()}, {}), MeshError);
  CHECK_THROWS_AS(compact.with_free_ids({}, {VertexId(15)}), MeshError);
}
