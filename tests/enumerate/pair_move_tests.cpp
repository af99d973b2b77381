// Every pair move of every configuration of every region of perimeter <= 16. The result is compared with the glued
// region of the configuration that theory/ predicts.
#include "enumerate/generators.hpp"
#include "enumerate/labels.hpp"
#include "mesh/irregular/pair_moves.hpp"
#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/signature.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/enumerate/census.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "theory/configuration_graph.hpp"

using namespace requad;
using namespace requad::mesh;

namespace {

std::vector<PairMove> moves_of(const QuadMesh& m) {
  const auto v = irregular_vertices(m);
  return v.size() == 1 ? parting_moves(m, v[0]) : pair_moves(m, v[0], v[1]);
}

}  // namespace

TEST_CASE("every pair move of every region of perimeter <= 16", "[pair moves]") {
  std::mt19937 random(6);
  int made = 0, refused = 0, identities = 0;
  for (const tests::CensusEntry& entry : tests::census(16, true)) {
    const QuadMesh& before = entry.region.mesh;
    const auto map = theory::configuration_map(entry.shape, theory::Apex::with);
    const int node = map.find(entry.configuration);
    REQUIRE(node >= 0);
    // The signatures of the neighbours that theory/ predicts, as a multiset.
    std::multiset<std::string> expected;
    int impossible = 0;
    for (const theory::Dart& dart : map.nodes[static_cast<std::size_t>(node)].moves) {
      if (dart.target < 0) {
        ++impossible;
      } else {
        expected.insert(signature(enumerate::glue_region(
            entry.shape.type(), map.nodes[static_cast<std::size_t>(dart.target)].configuration)));
      }
    }
    int refused_here = 0;
    for (const PairMove& move : moves_of(before)) {
      INFO(theory::label(entry.shape.type(), entry.configuration)
           << " " << name(move.step) << " on " << signature(entry.region));
      Region after = entry.region;
      const MoveReport report = move_pair(after.mesh, move);
      QuadMesh tried = before;
      REQUIRE(why_not_move_pair(tried, move) == report.refusal);
      REQUIRE(tried == before);
      if (report.refusal != Refusal::none) {
        REQUIRE(after.mesh == before);
        REQUIRE(report.operations.empty());
        // In such a region, only the boundary can be in the way.
        REQUIRE((report.refusal == EditRefusal::touches_boundary || report.refusal == Refusal::boundary_corner));
        ++refused_here;
        continue;
      }
      ++made;
      identities += report.operations.empty() ? 1 : 0;
      // The result is one of the predicted neighbours. Each occurs as often as predicted.
      const auto it = expected.find(signature(after));
      REQUIRE(it != expected.end());
      expected.erase(it);

      // The operations alone make the same mesh. Every mesh on the way is valid, has at most four irregular vertices,
      // and has the same valences on the boundary.
      QuadMesh on_the_way = before;
      for (const BasicOperation& op : report.operations) {
        for (const VertexId v : changed_vertices(on_the_way, op)) {
          if (v.valid()) REQUIRE_FALSE(on_the_way.is_boundary(v));
        }
        REQUIRE(apply(on_the_way, op).refusal == Refusal::none);
        REQUIRE(validate(on_the_way).empty());
        REQUIRE(irregular_vertices(on_the_way).size() <= 4);
      }
      REQUIRE(on_the_way == after.mesh);
      REQUIRE(report.faces_made() - report.faces_deleted() == after.mesh.face_count() - before.face_count());

      // Undoing restores the arrays. The inverse move leads back, even after all elements were renamed.
      QuadMesh undone = after.mesh;
      REQUIRE(apply_all(undone, report.undo) == Refusal::none);
      REQUIRE(undone == before);
      const tests::Relabelled other = tests::relabel(after.mesh, random);
      PairMove back = report.inverse;
      back.frame.first_leg = other.half_edge[back.frame.first_leg.slot()];
      back.frame.second_leg = other.half_edge[back.frame.second_leg.slot()];
      back.frame.v2 = other.mesh.origin(other.half_edge[after.mesh.out(back.frame.v2).slot()]);
      back.frame.v1 = other.mesh.origin(back.frame.first_leg);
      QuadMesh returned = other.mesh;
      REQUIRE(move_pair(returned, back).refusal == Refusal::none);
      const VertexId root = other.mesh.origin(other.half_edge[after.root.slot()]);
      REQUIRE(signature(returned, returned.out(root)) == signature(entry.region));
    }
    // Every predicted step was made, and every other one was refused.
    REQUIRE(expected.empty());
    REQUIRE(refused_here == impossible);
    refused += refused_here;
  }
  WARN(made << " pair moves made, " << refused << " refused, " << identities << " needed no operation");
  CHECK(made > 300);
  CHECK(identities > 0);
}

TEST_CASE("moves out of an irregular vertex's reach or of the wrong kind are refused", "[pair moves]") {
  const tests::CensusEntry entry = tests::census(10, false).front();
  const auto irregular = irregular_vertices(entry.region.mesh);
  CHECK(pair_moves(entry.region.mesh, irregular[0], irregular[0]).empty());
  CHECK(pair_moves(entry.region.mesh, irregular[0], entry.region.mesh.origin(entry.region.root)).empty());
  CHECK(parting_moves(entry.region.mesh, irregular[0]).empty());
}

TEST_CASE("a third irregular vertex in the way stops a move and leaves the mesh as it was", "[pair moves]") {
  // A 3-3 pair lies well inside a large digon. A flip next to the path of a move then makes 3-3-5-5 there.
  theory::Configuration c;
  c.parameters = {3, 2, theory::IntegerVector::Constant(2, 6)};
  const Region region = enumerate::glue_region(theory::kDigon, c);
  const auto pair = irregular_vertices(region.mesh);
  int stopped = 0, went = 0;
  for (const HalfEdgeId h : region.mesh.half_edges()) {
    QuadMesh disturbed = region.mesh;
    const BasicOperation op{BasicOperation::Kind::flip_cw, h, {}, 0};
    if (why_not(disturbed, op) != Refusal::none) continue;
    const auto touched = changed_vertices(disturbed, op);
    if (std::any_of(touched.begin(), touched.end(),
                    [&](VertexId v) { return v == pair[0] || v == pair[1] || disturbed.is_boundary(v); }))
      continue;
    apply(disturbed, op);
    const QuadMesh before = disturbed;
    for (const PairMove& move : pair_moves(disturbed, pair[0], pair[1])) {
      const MoveReport report = move_pair(disturbed, move);
      if (report.refusal == Refusal::none) {
        ++went;
        REQUIRE(irregular_vertices(disturbed).size() == irregular_vertices(before).size());
        REQUIRE(validate(disturbed).empty());
        REQUIRE(apply_all(disturbed, report.undo) == Refusal::none);
      } else {
        ++stopped;
      }
      REQUIRE(disturbed == before);
    }
  }
  CHECK(stopped > 10);
  CHECK(went > 100);
}
