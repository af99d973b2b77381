// The walk on one mesh. Its counts are compared with formulas written out by hand, and with explorations by signatures.
// Its costs are counted, and it must fail where mesh and theory differ. The table of configurations is compared with
// the map, and predicted separatrix vectors are compared with separatrices that are traced on meshes.
#include "enumerate/exploration.hpp"
#include "enumerate/generators.hpp"
#include "enumerate/walk.hpp"
#include "mesh/irregular/pair_moves.hpp"
#include "mesh/topology/separatrix.hpp"
#include "tests/support/allocations.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/enumerate/census.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "theory/separatrix_vector.hpp"

using namespace requad;
using enumerate::WalkResult;
using requad::tests::sides;

namespace {

theory::IntegerVector regular(theory::PairType type, theory::Integer length) {
  return theory::IntegerVector::Constant(type.side_count(), length);
}

// Theorem 7.2.
std::int64_t tau(std::int64_t length) {
  const std::int64_t n = length / 2;
  return length % 2 == 0 ? n * (n - 1) : n * n;
}

// The number of edges of a regular digon's grid (Figure 10). Levels s have the parity of L and end at L - 2. Each level
// is a cycle of s edges, s + 1 edges lead to the next level, and one edge leads to the apex. A hexagon has three times
// as many (Figure 11).
std::int64_t grid_edges(std::int64_t length) {
  std::int64_t edges = length % 2 == 0 ? 1 : 0;
  for (std::int64_t s = length % 2 == 0 ? 2 : 1; s <= length - 2; s += 2)
    edges += s + (s + 2 <= length - 2 ? s + 1 : 0);
  return edges;
}

theory::Place place_of(theory::PairType type, const theory::Configuration& c) {
  return {c.p, theory::grid_point(type, c)};
}

}  // namespace

TEST_CASE("the table of configurations agrees with the map of configurations", "[walk]") {
  for (const tests::CensusEntry& entry : tests::census(18, false)) {
    if (!(entry.configuration == theory::parameter_set(entry.shape).front())) continue;  // each region once
    const theory::ConfigurationMap map = theory::configuration_map(entry.shape, theory::Apex::with);
    const theory::ConfigurationTable table(entry.shape);
    INFO(entry.shape.type().name() << " " << entry.shape.sides().transpose());
    REQUIRE(table.size() == static_cast<int>(map.nodes.size()));
    std::int64_t ends = 0;
    for (std::size_t i = 0; i < map.nodes.size(); ++i) {
      const theory::MapNode& node = map.nodes[i];
      const theory::Place place = place_of(entry.shape.type(), node.configuration);
      REQUIRE(table.find(place) == static_cast<int>(i));
      REQUIRE(table.slot_count(place) == static_cast<int>(node.moves.size()));
      REQUIRE(table.most_faces() >= theory::PairSystem(entry.shape.type()).face_count(node.configuration.parameters));
      for (std::size_t slot = 0; slot < node.moves.size(); ++slot) {
        const auto move = table.move(place, static_cast<int>(slot));
        REQUIRE(move.target == node.moves[slot].target);
        REQUIRE(move.step == node.steps[slot]);
        if (move.target < 0) continue;
        ++ends;
        REQUIRE(move.back_slot == node.moves[slot].slot);
        REQUIRE(move.to ==
                place_of(entry.shape.type(), map.nodes[static_cast<std::size_t>(move.target)].configuration));
      }
    }
    REQUIRE(table.count_edges() == ends / 2);
    REQUIRE(table.find({1, {-1, 1}}) == -1);
    REQUIRE(table.find({1, {1000, 0}}) == -1);
    REQUIRE(table.find({entry.shape.type().rotation_count() + 1, {1, 0}}) == -1);
  }
}

TEST_CASE("predicted separatrix vectors are those traced on the mesh, and give the configuration back", "[walk]") {
  std::mt19937 random(7);
  int located = 0, disturbed = 0;
  for (const tests::CensusEntry& entry : tests::census(16, false)) {
    const enumerate::Reading reading = enumerate::read(entry.region, entry.shape.type());
    const auto positions = mesh::boundary_positions(entry.region);
    for (const enumerate::LabelledFrame& f : reading.frames) {
      // The separatrices in the order of the frame, as in Law theory-5.
      std::vector<theory::Crossing> at_v1, at_v2;
      for (const mesh::PairFrame& frame : mesh::both_ends(entry.region.mesh, f.frame)) {
        auto& at = at_v1.empty() ? at_v1 : at_v2;
        mesh::HalfEdgeId h = frame.first_leg;
        do {
          const mesh::Separatrix s = mesh::trace(entry.region.mesh, h);
          theory::Crossing crossing{-1, -1, s.length()};
          if (s.end == mesh::Separatrix::End::boundary) {
            const auto position = positions[entry.region.mesh.target(s.path.back()).slot()];
            crossing.side = position.side;
            crossing.distance = position.distance;
          }
          at.push_back(crossing);
          h = entry.region.mesh.ccw(h);
        } while (h != frame.first_leg);
      }
      // The labels of v1 come first, unless v1 and v2 were swapped to bring p into range. Equal valences allow this.
      const theory::SeparatrixVector predicted =
          theory::separatrix_vector(entry.shape, theory::to_labelling(f.labelling));
      const auto starts = [](const auto& vector, const auto& read) {
        return std::equal(read.begin(), read.end(), vector.begin());
      };
      const bool as_named = starts(predicted.at_v1, at_v1) && starts(predicted.at_v2, at_v2);
      const bool swapped =
          entry.shape.type().symmetric() && starts(predicted.at_v1, at_v2) && starts(predicted.at_v2, at_v1);
      REQUIRE((as_named || swapped));

      // The vectors may start with any separatrix.
      std::rotate(at_v1.begin(), at_v1.begin() + static_cast<std::ptrdiff_t>(random() % at_v1.size()), at_v1.end());
      std::rotate(at_v2.begin(), at_v2.begin() + static_cast<std::ptrdiff_t>(random() % at_v2.size()), at_v2.end());
      const auto found = theory::locate(entry.shape, at_v1, at_v2);
      REQUIRE(found.has_value());
      REQUIRE(theory::to_configuration(entry.shape.type(), found->labelling) == entry.configuration);
      ++located;

      // A distance, a length or a side that is wrong by one belongs to no configuration.
      for (int k = 0; k < 3; ++k) {
        auto wrong = at_v1;
        theory::Crossing& crossing = wrong[random() % wrong.size()];
        (k == 0 ? crossing.distance : crossing.length) += 1;
        if (k == 2) crossing.side = (crossing.side + 1) % entry.shape.type().side_count(), crossing.length -= 1;
        if (crossing.side < 0 && k == 0) continue;
        REQUIRE_FALSE(theory::locate(entry.shape, wrong, at_v2).has_value());
        ++disturbed;
      }
    }
  }
  CHECK(located > 150);
  CHECK(disturbed > 400);
}

TEST_CASE("following a path and tracing it give the same end", "[walk]") {
  std::mt19937 random(8);
  std::vector<mesh::QuadMesh> meshes{tests::torus(5, 4), tests::cube(), tests::grid(3, 2).mesh};
  for (const tests::CensusEntry& entry : tests::census(14, true)) meshes.push_back(entry.region.mesh);
  for (mesh::QuadMesh& m : meshes) {
    for (int i = 0; i < 6; ++i) mesh::apply(m, tests::random_operation(m, random));
    std::vector<mesh::SeparatrixEnd> paths;
    for (const mesh::HalfEdgeId h : m.half_edges()) paths.push_back({h, 0, mesh::Separatrix::End::closed});
    mesh::trace_ends(m, paths, m.half_edge_capacity());
    std::size_t i = 0;
    for (const mesh::HalfEdgeId h : m.half_edges()) {
      const mesh::Separatrix s = mesh::trace(m, h);
      const mesh::SeparatrixEnd& arrival = paths[i++];
      REQUIRE(arrival.end == s.end);
      if (s.end == mesh::Separatrix::End::closed) continue;  // a closed path has no end
      REQUIRE(arrival.last == s.path.back());
      REQUIRE(arrival.length == s.length());
    }
    for (const mesh::HalfEdgeId h : m.half_edges()) {
      REQUIRE(mesh::leaves_regular_vertex(m, h) == (!m.is_boundary(m.origin(h)) && m.valence(m.origin(h)) == 4));
    }
  }
}

TEST_CASE("PairMover makes the same moves as move_pair", "[walk]") {
  int made = 0;
  for (const tests::CensusEntry& entry : tests::census(14, true)) {
    const auto v = mesh::irregular_vertices(entry.region.mesh);
    const auto moves =
        v.size() == 1 ? mesh::parting_moves(entry.region.mesh, v[0]) : mesh::pair_moves(entry.region.mesh, v[0], v[1]);
    for (const mesh::PairMove& move : moves) {
      mesh::QuadMesh by_report = entry.region.mesh;
      mesh::QuadMesh by_mover = entry.region.mesh;
      const mesh::MoveReport report = mesh::move_pair(by_report, move);
      const mesh::PairMover::Moved moved = mesh::PairMover(by_mover).move(move);
      REQUIRE(moved.refusal == report.refusal);
      REQUIRE(by_mover == by_report);
      if (report.refusal != mesh::Refusal::none) continue;
      ++made;
      REQUIRE(moved.operations == static_cast<int>(report.operations.size()));
      REQUIRE(moved.v1 == report.inverse.frame.v1);
      REQUIRE(moved.v2 == report.inverse.frame.v2);
    }
  }
  CHECK(made > 150);
}

TEST_CASE("enumerate-3: the walk visits each configuration once and each edge both ways", "[walk]") {
  for (std::int64_t length = 3; length <= 14; ++length) {
    INFO("side " << length);
    const WalkResult digon = enumerate::walk({theory::kDigon, regular(theory::kDigon, length)});
    CHECK(digon.problem.empty());
    CHECK(digon.configurations == tau(length));
    CHECK(digon.merged == (length % 2 == 0 ? 1 : 0));
    CHECK(digon.edges == grid_edges(length));
    CHECK(digon.moves == 2 * digon.edges);
    if (length > 9) continue;
    const WalkResult hexagon = enumerate::walk({theory::kHexagon, regular(theory::kHexagon, length)});
    CHECK(hexagon.problem.empty());
    CHECK(hexagon.configurations == 3 * tau(length));
    CHECK(hexagon.edges == 3 * grid_edges(length));
  }
  // Theorem 7.4: E1 = d1+e2+e4, E2 = e1+e3, E3 = d2+e2+e4, E4 = d1+d2+e1+e3 with d1 = 2, d2 = 1: K = (E2-1)(E1-d1-1).
  const WalkResult quad = enumerate::walk({theory::kQuad, sides({8, 7, 7, 10})});
  CHECK(quad.problem.empty());
  CHECK(quad.configurations == 6 * 5);
  CHECK(quad.edges == 5 * 5 + 6 * 4);  // of the grid
}

TEST_CASE("the walk finds what exploration finds in regions of all kinds", "[walk]") {
  int regions = 0;
  for (const tests::CensusEntry& entry : tests::census(16, false)) {
    if (!(entry.configuration == theory::parameter_set(entry.shape).front())) continue;
    INFO(entry.shape.type().name() << " " << entry.shape.sides().transpose());
    const auto found = enumerate::explore(entry.shape, {entry.region});
    const WalkResult walked = enumerate::walk(theory::ConfigurationTable(entry.shape), entry.region);
    CHECK(walked.problem.empty());
    CHECK(walked.configurations + walked.merged == static_cast<std::int64_t>(found.nodes.size()));
    const auto made = std::count_if(found.moves.begin(), found.moves.end(), [](const auto& m) { return m.to >= 0; });
    CHECK(walked.moves == made);
    CHECK(walked.refusals == static_cast<std::int64_t>(found.moves.size()) - made);
    ++regions;
  }
  CHECK(regions > 60);
}

TEST_CASE("the walk fails where mesh and theory differ", "[walk]") {
  const auto digon = [](theory::Integer length) { return regular(theory::kDigon, length); };
  const auto start = [&](theory::Integer length) {
    return enumerate::glue_region(theory::kDigon, theory::parameter_set({theory::kDigon, digon(length)}).front());
  };
  REQUIRE(enumerate::walk(theory::ConfigurationTable({theory::kDigon, digon(8)}), start(8)).complete());

  // The mesh has another region than the table.
  const WalkResult other = enumerate::walk(theory::ConfigurationTable({theory::kDigon, digon(8)}), start(10));
  CHECK(other.problem == "in the region to start from, the separatrices are those of no configuration");
  CHECK(other.mesh.has_value());
  CHECK_FALSE(other.complete());

  // The root is moved by one edge, so all labels are wrong by one.
  mesh::Region turned = start(8);
  turned.root = turned.mesh.next_on_boundary(turned.root);
  CHECK_FALSE(enumerate::walk(theory::ConfigurationTable({theory::kDigon, digon(8)}), turned).problem.empty());

  // The root is moved by one side. This rotation keeps the sides of the hexagon, but it is no symmetry of the pair.
  mesh::Region rotated = enumerate::glue_region(theory::kHexagon, {{1, 1, theory::to_vector({1, 2, 2, 1, 2, 2})}, 1});
  const auto lengths = mesh::side_lengths(rotated);
  const theory::ConfigurationTable table({theory::kHexagon, theory::to_vector({lengths.begin(), lengths.end()})});
  CHECK(enumerate::walk(table, rotated).complete());
  for (int i = 0; i < lengths[0]; ++i) rotated.root = rotated.mesh.next_on_boundary(rotated.root);
  CHECK_FALSE(enumerate::walk(table, rotated).complete());

  // A mesh without a pair, and one with four irregular vertices.
  CHECK_FALSE(
      enumerate::walk(theory::ConfigurationTable({theory::kDigon, digon(8)}), tests::grid(4, 4)).problem.empty());
  mesh::Region disturbed = start(8);
  for (const mesh::HalfEdgeId h : disturbed.mesh.half_edges()) {
    if (mesh::flip(disturbed.mesh, h, mesh::Rotation::clockwise) == mesh::Refusal::none) break;
  }
  CHECK_FALSE(enumerate::walk(theory::ConfigurationTable({theory::kDigon, digon(8)}), disturbed).problem.empty());
}

// Costs are counted. A slide takes max(d1, d2) + O(1) operations, open and close take d1 + d2 + O(1). An identification
// traces each separatrix once. No separatrix is longer than the longest side and the way round R_alpha.
TEST_CASE("a walk keeps to its bounds of operations, traced edges, allocations and memory", "[walk]") {
  struct Case {
    theory::PairType type;
    theory::IntegerVector e;
  };
  for (const Case& c :
       {Case{theory::kDigon, regular(theory::kDigon, 110)}, Case{theory::kHexagon, regular(theory::kHexagon, 60)},
        Case{theory::kQuad, sides({60, 70, 50, 90})}}) {
    INFO(c.type.name());
    std::vector<std::int64_t> counts;
    counts.reserve(1000);
    const WalkResult w = enumerate::walk({c.type, c.e}, [&](std::int64_t) { counts.push_back(tests::allocations()); });
    REQUIRE(w.problem.empty());
    CHECK(counts.size() >= 3);
    CHECK(counts.front() == counts.back());
    const theory::Integer longest = c.e.maxCoeff();
    CHECK(w.operations <= w.moves * (longest + 2));
    CHECK(w.traced <= w.identifications * (c.type.l1 + c.type.l2) * longest);
    CHECK(w.identifications == w.moves + w.refusals + 1);
    CHECK(w.other_bytes <= w.mesh_bytes);
  }
}

TEST_CASE("a pair move keeps to its bound of operations, by the extents of R_alpha", "[walk]") {
  for (const int d1 : {0, 1, 5, 20}) {
    for (const int d2 : {1, 4, 20}) {
      for (const theory::PairType type : {theory::kDigon, theory::kHexagon, theory::kQuad}) {
        const auto region = enumerate::glue_region(
            type, theory::canonical(type, {{d1, d2, theory::IntegerVector::Constant(type.side_count(), 4)}, 1}));
        const auto v = mesh::irregular_vertices(region.mesh);
        for (const mesh::PairMove& move : mesh::pair_moves(region.mesh, v[0], v[1])) {
          mesh::QuadMesh m = region.mesh;
          m.reserve(2 * m.face_count(), 2 * m.vertex_count());
          mesh::PairMover mover(m);
          const mesh::PairMover::Moved there = mover.move(move);
          REQUIRE(there.refusal == mesh::Refusal::none);
          const bool slide = move.step == mesh::PairStep::slide_first || move.step == mesh::PairStep::slide_second;
          CHECK(there.operations <= (slide ? std::max(d1, d2) : d1 + d2) + 1);
        }
      }
    }
  }
}
