// Signatures: they do not depend on names, differ for different meshes, and allow the mesh to be rebuilt.
#include <algorithm>
#include <map>
#include <set>

#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/mesh/regions.hpp"

using namespace requad;
using namespace requad::mesh;

TEST_CASE("signatures do not depend on names (topology-11)", "[signature]") {
  std::mt19937 random(3);
  for (const tests::SmallRegion& entry : tests::small_regions(14, true)) {
    const std::string expected = signature(entry.region);
    for (int round = 0; round < 3; ++round) {
      const tests::Relabelled other = tests::relabel(entry.region.mesh, random);
      REQUIRE(signature(other.mesh, other.half_edge[entry.region.root.slot()]) == expected);
    }
  }
}

TEST_CASE("every vertex numbering of a small mesh gives one signature", "[signature]") {
  // All 6! numberings of the vertices of a 2 x 1 grid are tested.
  const Region g = tests::grid(2, 1);
  const std::string expected = signature(g);
  std::array<int, 6> name{0, 1, 2, 3, 4, 5};
  do {
    tests::FaceList faces = tests::face_list(g.mesh);
    for (auto& face : faces) {
      for (int& v : face) v = name[static_cast<std::size_t>(v)];
    }
    const QuadMesh m = QuadMesh::from_faces(6, faces);
    const int root_vertex = name[static_cast<std::size_t>(g.mesh.origin(g.root).index())];
    REQUIRE(signature(m, m.out(VertexId(root_vertex))) == expected);
  } while (std::next_permutation(name.begin(), name.end()));
}

TEST_CASE("signatures tell configurations apart and rebuild them (topology-12)", "[signature]") {
  std::set<std::string> seen;
  for (const tests::SmallRegion& entry : tests::small_regions(16, true, tests::Roots::each_corner)) {
    const std::string text = signature(entry.region);
    INFO(text);
    // Signatures of different configurations of one region must differ, and so must those of different regions.
    CHECK(seen.insert(text).second);
    const Region rebuilt = from_signature(text);
    CHECK(validate(rebuilt.mesh).empty());
    CHECK(signature(rebuilt) == text);
    CHECK(side_lengths(rebuilt) == side_lengths(entry.region));
  }
}

TEST_CASE("closed meshes have signatures, and equivalent roots give the same one", "[signature]") {
  // The cube looks the same from each of its 24 half-edges, and so does its mirror image. A 4 x 5 torus has two kinds
  // of half-edges.
  const QuadMesh c = tests::cube();
  std::set<std::string> cube_signatures;
  for (const HalfEdgeId h : c.half_edges()) {
    cube_signatures.insert(signature(c, h));
    cube_signatures.insert(signature(c, h, Orientation::mirrored));
  }
  CHECK(cube_signatures.size() == 1);
  CHECK(validate(from_signature(*cube_signatures.begin()).mesh).empty());

  const QuadMesh t = tests::torus(4, 5);
  std::map<std::string, int> torus_signatures;
  for (const HalfEdgeId h : t.half_edges()) ++torus_signatures[signature(t, h)];
  CHECK(torus_signatures.size() == 2);
  for (const auto& [text, count] : torus_signatures) CHECK(count == 40);
  CHECK(euler_characteristic(from_signature(torus_signatures.begin()->first).mesh) == 0);
}

namespace {

// The canonical signature by its definition: the least of all rooted signatures.
std::string least_signature(const QuadMesh& m, Orientation orientation) {
  using VertexKind = std::pair<bool, int>;
  const auto kind = [&m](VertexId v) { return VertexKind{m.is_boundary(v), m.face_valence(v)}; };
  std::map<VertexKind, int> count;
  for (const VertexId v : m.vertices()) ++count[kind(v)];
  const VertexKind rarest = std::min_element(count.begin(), count.end(), [](const auto& a, const auto& b) {
                              return a.second < b.second;
                            })->first;
  std::set<std::string> all;
  for (const HalfEdgeId h : m.half_edges()) {
    if (kind(orientation == Orientation::kept ? m.origin(h) : m.target(h)) == rarest)
      all.insert(signature(m, h, orientation));
  }
  return *all.begin();
}

}  // namespace

TEST_CASE("the canonical signature is the least one, although symmetries save work (topology-13)", "[signature]") {
  std::mt19937 random(8);
  std::vector<QuadMesh> meshes{tests::cube(), tests::torus(3, 3), tests::torus(4, 4), tests::torus(4, 6),
                               tests::torus(3, 8)};
  // `m` usually loses its symmetries. `even` keeps one, half-way round the torus, and has several orbits of roots.
  for (int i = 0; i < 40; ++i) {
    QuadMesh m = meshes[static_cast<std::size_t>(i) % 5];
    QuadMesh even = tests::torus(8, 5);
    for (int k = 0; k < 1 + i % 7; ++k) {
      const auto all = m.half_edges();
      flip(m, all[random() % all.size()], Rotation::clockwise);
      const auto h = static_cast<std::int32_t>(random() % (4 * 40));
      const std::int32_t across = 32 * (h / 32) + (h + 16) % 32;  // four columns on, in rows of eight quads
      flip(even, HalfEdgeId(h), Rotation::clockwise);
      flip(even, HalfEdgeId(across), Rotation::clockwise);
    }
    meshes.push_back(std::move(m));
    meshes.push_back(std::move(even));
  }
  for (const tests::SmallRegion& entry : tests::small_regions(12, true)) meshes.push_back(entry.region.mesh);
  for (const QuadMesh& m : meshes) {
    for (const Orientation orientation : {Orientation::kept, Orientation::mirrored}) {
      const std::string least = least_signature(m, orientation);
      REQUIRE(canonical_signature(m, orientation) == least);
      REQUIRE(canonical_signature(tests::relabel(m, random).mesh, orientation) == least);
    }
  }
  // 160,000 roots of 40,000 quads would take an hour if each one were tried.
  const QuadMesh large = tests::torus(200, 200);
  CHECK(canonical_signature(large) == signature(large, large.half_edges().front()));
}

TEST_CASE("mirrored signatures are those of the mirrored mesh", "[signature]") {
  for (const tests::SmallRegion& entry : tests::small_regions(12, true)) {
    tests::FaceList faces = tests::face_list(entry.region.mesh);
    for (auto& face : faces) std::swap(face[1], face[3]);
    const QuadMesh mirrored = QuadMesh::from_faces(entry.region.mesh.vertex_capacity(), faces);
    const VertexId a = entry.region.mesh.origin(entry.region.root), b = entry.region.mesh.target(entry.region.root);
    REQUIRE(signature(entry.region.mesh, entry.region.root, Orientation::mirrored) ==
            signature(mirrored, mirrored.find_half_edge(b, a)));
  }
}

TEST_CASE("orbits under the boundary's symmetries", "[signature]") {
  // A 3 x 3 grid looks the same from all four corners, a 3 x 2 grid only from opposite ones.
  CHECK(rotated_signatures(tests::grid(3, 3)).size() == 4);
  CHECK(rotated_signatures(tests::grid(3, 2)).size() == 2);
  CHECK(reflected_signatures(tests::grid(3, 3)).size() == 4);
  for (const Region& g : {tests::grid(3, 3), tests::grid(3, 2)}) {
    for (const std::string& text : rotated_signatures(g)) CHECK(text == signature(g));
    for (const std::string& text : reflected_signatures(g)) CHECK(text == signature(g));
  }
}

TEST_CASE("texts that are no signatures are refused in one line", "[signature]") {
  const std::string good = signature(tests::grid(2, 2));
  for (const std::string& text :
       {std::string(), std::string("0"), std::string("!!"), good + "0", good.substr(1), std::string("ZZZZZZZZZZZZ"),
        std::string("00001"), std::string("2222"), std::string("w0000"), std::string("000w0")}) {  // w0 is 0 again
    INFO(text);
    try {
      from_signature(text);
      FAIL("was accepted");
    } catch (const MeshError& error) {
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
    }
  }
  // With one letter changed, the text is refused or gives another mesh.
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const char letter : {'0', '1', '2', '5', 'b', 'Z', '_'}) {
      std::string text = good;
      text[i] = letter;
      if (text == good) continue;
      try {
        const Region other = from_signature(text);
        CHECK(validate(other.mesh).empty());
        CHECK(signature(other) != good);
      } catch (const MeshError&) {
      }
    }
  }
}
