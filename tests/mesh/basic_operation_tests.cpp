// Tests of every basic operation at every site of every small region (claims B2 and B3). Surgery on face lists predicts
// whether an operation is legal. It knows no half-edges.
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/disks.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/mesh/regions.hpp"
#include "tests/support/sanitizers.hpp"

using namespace requad;
using namespace requad::mesh;
using tests::FaceList;

namespace {

using Kind = BasicOperation::Kind;

struct Tally {
  int legal = 0;
  int refused = 0;
  std::mt19937 random{16};  // the seed
};

// Checks one operation at one site. `expected` says whether it is legal, and what the result is.
void check_site(const Region& region, const BasicOperation& op, const tests::LegalResult& expected, Tally& tally) {
  const QuadMesh& before = region.mesh;
  const Refusal refusal = why_not(before, op);
  INFO(to_string(op) << ": " << refusal.clause());
  REQUIRE((refusal == Refusal::none) == expected.legal);

  QuadMesh after = before;
  const Applied done = apply(after, op);
  REQUIRE(done.refusal == refusal);
  if (refusal != Refusal::none) {
    REQUIRE(after == before);
    ++tally.refused;
    return;
  }
  ++tally.legal;
  REQUIRE(validate(after).empty());
  // Laws topology-5 and topology-6, and the sizes.
  REQUIRE(euler_characteristic(after) == euler_characteristic(before));
  REQUIRE(tests::boundary_cycle(after) == tests::boundary_cycle(before));
  const int change = op.kind == Kind::collapse ? -1 : op.kind == Kind::split ? 1 : 0;
  REQUIRE(after.face_count() == before.face_count() + change);
  REQUIRE(after.vertex_count() == before.vertex_count() + change);
  // The result is the mesh that the surgery made. Boundary vertices keep their ids, so both have the same root.
  const VertexId root = before.origin(region.root);
  REQUIRE(signature(after, after.out(root)) ==
          signature(expected.mesh, expected.mesh.out(VertexId(expected.name[root.slot()]))));

  // Law topology-7 and claim B2.
  const auto changed = changed_vertices(before, op);
  for (const VertexId v : before.vertices()) {
    if (!after.is_live(v)) continue;
    if (std::find(changed.begin(), changed.end(), v) == changed.end()) REQUIRE(after.valence(v) == before.valence(v));
  }
  const auto difference = [&](VertexId v) { return after.valence(v) - before.valence(v); };
  switch (op.kind) {
    case Kind::flip_ccw:
    case Kind::flip_cw:
      REQUIRE(difference(changed[0]) == -1);
      REQUIRE(difference(changed[1]) == -1);
      REQUIRE(difference(changed[2]) == 1);
      REQUIRE(difference(changed[3]) == 1);
      break;
    case Kind::collapse: {
      const VertexId a = before.origin(op.h), b = before.target(op.h);
      const VertexId c = before.target(before.next(op.h)), d = before.origin(before.previous(op.h));
      REQUIRE(after.valence(a) == before.valence(a) + before.valence(c) - 2);
      REQUIRE(difference(b) == -1);
      REQUIRE(difference(d) == -1);
      break;
    }
    case Kind::split: {
      const VertexId v = changed[0], w = after.origin(QuadMesh::opposite(done.made));
      REQUIRE(after.valence(v) + after.valence(w) == before.valence(v) + 2);
      REQUIRE(difference(changed[1]) == 1);
      REQUIRE(difference(changed[2]) == 1);
      break;
    }
  }

  // Law topology-8 and claim B3: the inverse restores everything. The inverse of a flip is the other flip. Collapse and
  // split are inverse to each other.
  QuadMesh undone = after;
  REQUIRE(apply(undone, done.inverse).refusal == Refusal::none);
  REQUIRE(undone == before);
  REQUIRE(validate(undone).empty());
  const Kind inverse = op.kind == Kind::flip_ccw   ? Kind::flip_cw
                       : op.kind == Kind::flip_cw  ? Kind::flip_ccw
                       : op.kind == Kind::collapse ? Kind::split
                                                   : Kind::collapse;
  REQUIRE(done.inverse.kind == inverse);

  // The operation and its inverse commute with renaming everything.
  const tests::Relabelled other = tests::relabel(before, tally.random);
  QuadMesh moved = other.mesh;
  const Applied there = apply(moved, tests::renamed(op, other));
  REQUIRE(there.refusal == Refusal::none);
  const VertexId other_root = other.mesh.origin(other.half_edge[region.root.slot()]);
  REQUIRE(signature(moved, moved.out(other_root)) == signature(after, after.out(root)));
  REQUIRE(apply(moved, there.inverse).refusal == Refusal::none);
  REQUIRE(signature(moved, moved.out(other_root)) == signature(region));
}

// Checks every flip and collapse at every half-edge, and splits at all pairs of half-edges into and out of a vertex.
void check_all_sites(const Region& region, Tally& tally) {
  INFO("on " << signature(region));
  const QuadMesh& m = region.mesh;
  for (const HalfEdgeId h : m.half_edges()) {
    for (const Rotation rotation : {Rotation::counter_clockwise, Rotation::clockwise}) {
      tests::LegalResult expected;
      if (!m.is_boundary(h))
        expected = tests::is_legal_result(m, tests::flipped(m, h, rotation), m.vertex_capacity(), -1);
      check_site(region, {rotation == Rotation::clockwise ? Kind::flip_cw : Kind::flip_ccw, h, {}, 0}, expected, tally);
    }
    const VertexId gone = m.target(m.next(h));
    check_site(region, {Kind::collapse, h, {}, 0},
               tests::is_legal_result(m, tests::collapsed(m, h), m.vertex_capacity(), gone.index()), tally);
  }
  for (const VertexId v : m.vertices()) {
    std::vector<HalfEdgeId> out;
    m.for_each_out(v, [&out](HalfEdgeId h) { out.push_back(h); });
    const std::size_t n = out.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        // The sector goes from face i counter-clockwise to face j. It must not cross the boundary.
        const HalfEdgeId first = out[i];
        const HalfEdgeId last = m.previous(out[j]);
        std::vector<FaceId> sector;
        for (std::size_t k = i;; k = (k + 1) % n) {
          sector.push_back(m.face(out[k]));
          if (k == j) break;
        }
        tests::LegalResult expected;
        if (!m.is_boundary(v) || i <= j) {
          expected = tests::is_legal_result(m, tests::split(m, sector, first, last), m.vertex_capacity() + 1, -1);
        }
        check_site(region, {Kind::split, first, last, static_cast<int>(i % 4)}, expected, tally);
      }
    }
  }
}

}  // namespace

TEST_CASE("every basic operation at every site of every small region", "[operations]") {
  Tally total;
  const auto regions = tests::small_regions(tests::kSanitized ? 14 : 16, true);
  CHECK(regions.size() > (tests::kSanitized ? 50 : 100));
  for (const tests::SmallRegion& small : regions) check_all_sites(small.region, total);
  WARN(regions.size() << " regions: " << total.legal << " operations performed, " << total.refused << " refused");
  CHECK(total.legal > (tests::kSanitized ? 10000 : 30000));
  CHECK(total.refused > (tests::kSanitized ? 3000 : 10000));
}

TEST_CASE("every basic operation at every site of every small disk", "[operations]") {
  // These disks have interior vertices of low valence, and edges between boundary vertices. So more operations are
  // refused, for more reasons.
  Tally total;
  int disks = 0;
  for (const auto& [perimeter, faces] :
       {std::pair{4, 5}, std::pair{6, 5}, std::pair{8, 5}, std::pair{10, tests::kSanitized ? 4 : 5}}) {
    for (const Region& disk : tests::small_disks(perimeter, faces)) {
      check_all_sites(disk, total);
      ++disks;
    }
  }
  WARN(disks << " disks: " << total.legal << " operations performed, " << total.refused << " refused");
  CHECK(total.legal > (tests::kSanitized ? 5000 : 50000));
  CHECK(total.refused > (tests::kSanitized ? 5000 : 50000));
}

TEST_CASE("every flip and collapse at every site of closed meshes", "[operations]") {
  // A closed mesh has no boundary cycle and no boundary root to compare. Surgery predicts whether an operation is
  // legal. The test checks this, the validity of the result, and the inverse. Random legal operations first lead to
  // meshes that have many places near doubled edges and low valences.
  const unsigned seed = 40;
  std::mt19937 random(seed);
  int refused_edges = 0, performed = 0;
  for (int round = 0; round < 60; ++round) {
    INFO("seed " << seed << ", round " << round);
    QuadMesh m = round % 3 == 0 ? tests::cube() : round % 3 == 1 ? tests::torus(3, 3) : tests::torus(4, 3);
    for (int operation = 0; operation < round; ++operation) {
      const auto all = m.half_edges();
      const HalfEdgeId h = all[std::uniform_int_distribution<std::size_t>(0, all.size() - 1)(random)];
      const Kind kind = std::array{Kind::flip_ccw, Kind::flip_cw, Kind::collapse,
                                   Kind::split}[std::uniform_int_distribution<std::size_t>(0, 3)(random)];
      apply(m, {kind, h, kind == Kind::split ? m.previous(h) : HalfEdgeId(), 0});
    }
    REQUIRE(validate(m).empty());
    m = QuadMesh::from_faces(m.vertex_count(), m.compact_faces());  // the surgery requires a mesh without gaps
    std::vector<std::pair<BasicOperation, tests::LegalResult>> sites;
    for (const HalfEdgeId h : m.half_edges()) {
      for (const Rotation rotation : {Rotation::counter_clockwise, Rotation::clockwise}) {
        sites.push_back({{rotation == Rotation::clockwise ? Kind::flip_cw : Kind::flip_ccw, h, {}, 0},
                         tests::is_legal_result(m, tests::flipped(m, h, rotation), m.vertex_capacity(), -1)});
      }
      sites.push_back(
          {{Kind::collapse, h, {}, 0},
           tests::is_legal_result(m, tests::collapsed(m, h), m.vertex_capacity(), m.target(m.next(h)).index())});
    }
    for (const auto& [op, expected] : sites) {
      QuadMesh after = m;
      const Applied done = apply(after, op);
      INFO(to_string(op) << ": " << done.refusal.clause());
      REQUIRE((done.refusal == Refusal::none) == expected.legal);
      refused_edges += done.refusal == Refusal::edge_exists ? 1 : 0;
      if (!expected.legal) continue;
      ++performed;
      REQUIRE(validate(after).empty());
      REQUIRE(canonical_signature(after) == canonical_signature(expected.mesh));
      REQUIRE(apply(after, done.inverse).refusal == Refusal::none);
      REQUIRE(after == m);
    }
  }
  CHECK(performed > 1000);
  CHECK(refused_edges > 100);
}

TEST_CASE("each refusal occurs", "[operations]") {
  const Region g = tests::grid(3, 3);
  CHECK(why_not_flip(g.mesh, g.root, Rotation::clockwise) == Refusal::boundary_edge);
  CHECK(why_not_flip(g.mesh, HalfEdgeId(1000), Rotation::clockwise) == Refusal::dead_element);
  CHECK(why_not_flip(g.mesh, HalfEdgeId(), Rotation::clockwise) == Refusal::dead_element);
  CHECK(why_not_collapse(g.mesh, g.mesh.find_half_edge(VertexId(5), VertexId(1))) == Refusal::boundary_corner);
  const HalfEdgeId inner = g.mesh.find_half_edge(VertexId(5), VertexId(6));
  CHECK(why_not_split(g.mesh, inner, g.mesh.twin(inner)) == Refusal::same_edge);
  CHECK(why_not_split(g.mesh, inner, inner) == Refusal::not_one_fan);
  // After one collapse on the cube, some operations would make a valence too low, and some would double an edge.
  const QuadMesh c = tests::cube();
  QuadMesh once = c;
  CHECK(collapse(once, HalfEdgeId(0)) == Refusal::none);
  bool too_low = false, exists = false;
  for (const HalfEdgeId h : once.half_edges()) {
    too_low = too_low || why_not_collapse(once, h) == Refusal::valence_too_low;
    exists = exists || why_not_flip(once, h, Rotation::clockwise) == Refusal::edge_exists ||
             why_not_collapse(once, h) == Refusal::edge_exists;
  }
  CHECK(too_low);
  CHECK(exists);
}

TEST_CASE("a flip is one split and one collapse", "[operations]") {
  // Claim B3 (Figure 2, below): a split opens a path through the edge, then a collapse closes the quad beside it.
  const Region g = tests::grid(4, 3);
  int checked = 0;
  for (const HalfEdgeId h : g.mesh.half_edges()) {
    if (why_not_flip(g.mesh, h, Rotation::counter_clockwise) != Refusal::none) continue;
    QuadMesh flipped = g.mesh;
    flip_unchecked(flipped, h, Rotation::counter_clockwise);
    // The flip gives the same mesh as some split at an end of the edge followed by some collapse.
    bool found = false;
    for (const HalfEdgeId first : g.mesh.half_edges()) {
      for (const HalfEdgeId last : g.mesh.half_edges()) {
        if (found || g.mesh.target(last) != g.mesh.origin(first) || why_not_split(g.mesh, first, last) != Refusal::none)
          continue;
        if (g.mesh.origin(first) != g.mesh.origin(h) && g.mesh.origin(first) != g.mesh.target(h)) continue;
        QuadMesh split_mesh = g.mesh;
        split_unchecked(split_mesh, first, last);
        for (const HalfEdgeId k : split_mesh.half_edges()) {
          QuadMesh result = split_mesh;
          if (collapse(result, k) == Refusal::none &&
              signature(result, result.out(VertexId(0))) == signature(flipped, flipped.out(VertexId(0)))) {
            found = true;
          }
        }
      }
    }
    CHECK(found);
    ++checked;
  }
  CHECK(checked > 5);
}
