// Each claim fails if the facts that it reads are falsified.
#include "enumerate/generators.hpp"
#include "mesh/topology/signature.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/theory/integer_vector.hpp"
#include "tests/verify/falsifying.hpp"
#include "verify/claims/surfaces.hpp"
#include "verify/errata.hpp"

using namespace requad;
using namespace requad::verify;
using requad::tests::claim;
using requad::tests::fails;
using requad::tests::kAll;
using requad::tests::sides;
using requad::tests::study_of;

// A check that cannot fail is worse than none. So this test falsifies the facts that each check reads, one by one.
TEST_CASE("each claim fails on falsified facts", "[verify]") {
  const PairStudy digon = study_of(theory::kDigon, sides({6, 6}));
  const PairStudy hexagon = study_of(theory::kHexagon, sides({5, 5, 5, 5, 5, 5}));
  const PairStudy quad = study_of(theory::kQuad, sides({5, 4, 4, 7}));
  const auto first_made = [](PairStudy& s) -> enumerate::FoundMove& {
    return *std::find_if(s.found.moves.begin(), s.found.moves.end(), [](const auto& m) { return m.to >= 0; });
  };
  const auto first_refused = [](PairStudy& s) -> enumerate::FoundMove& {
    return *std::find_if(s.found.moves.begin(), s.found.moves.end(), [](const auto& m) { return m.to < 0; });
  };
  const auto lose_last_node = [](PairStudy& s) {
    const int last = static_cast<int>(s.found.nodes.size()) - 1;
    s.found.nodes.pop_back();
    s.predicted_of.pop_back();
    std::erase_if(s.found.moves, [last](const auto& m) { return m.from == last || m.to == last; });
  };
  for (const auto& [id, s] : {std::pair{"T2", digon}, std::pair{"T3", hexagon}, std::pair{"T4", quad}}) {
    fails(id, s, lose_last_node);
    fails(id, s, [](PairStudy& x) { ++x.exact_count; });
    fails(id, s, [](PairStudy& x) { x.predicted_of[0] = -1; });
    fails(id, s, [](PairStudy& x) { std::swap(x.predicted_of[0], x.predicted_of[1]); });
    fails(id, s,
          [&](PairStudy& x) { x.found.moves.erase(x.found.moves.begin() + (&first_made(x) - x.found.moves.data())); });
    fails(id, s, [&](PairStudy& x) { first_made(x).restored = false; });
    fails(id, s, [&](PairStudy& x) { first_made(x).inverse_returns = false; });
    fails(id, s, [&](PairStudy& x) { first_refused(x).refused_unchanged = false; });
    fails(id, s, [&](PairStudy& x) { first_made(x).after->parameters.d1 += 2; });
    fails(id, s, [&](PairStudy& x) { first_made(x).after.reset(); });
    fails(id, s, [&](PairStudy& x) { x.found.moves.push_back(first_made(x)); });
    fails(id, s, [](PairStudy& x) { x.searched->pop_back(); });
    fails(id, s, [](PairStudy& x) { x.searched->front() += "0"; });
  }
  fails("T2", digon, [](PairStudy& x) { x.searched_merged->clear(); });
  // A region without configurations, which theory alone calls empty.
  fails("T4", study_of(theory::kQuad, sides({2, 2, 2, 2})), [](PairStudy& x) { x.searched.reset(); });
  // The predicted order of the moves round a node, of a rectangle, of a segment and of a merged v6, is another one.
  const auto swap_two_moves = [](theory::MapNode& node) {
    std::swap(node.moves[0], node.moves[1]);
    std::swap(node.labellings[0], node.labellings[1]);
    std::swap(node.steps[0], node.steps[1]);
  };
  const auto swap_where = [&](auto wanted) {
    return [&swap_two_moves, wanted](PairStudy& x) {
      swap_two_moves(*std::find_if(x.map.nodes.begin(), x.map.nodes.end(), [&](const theory::MapNode& node) {
        const bool all_made =
            std::all_of(node.moves.begin(), node.moves.end(), [](auto dart) { return dart.target >= 0; });
        return all_made && wanted(node.configuration);
      }));
    };
  };
  const auto rectangle = [](const theory::Configuration& c) { return !c.degenerate(); };
  const auto segment = [](const theory::Configuration& c) { return c.degenerate() && !c.merged(); };
  const PairStudy even = study_of(theory::kHexagon, sides({6, 6, 6, 6, 6, 6}));
  fails("T2", study_of(theory::kDigon, sides({7, 7})), swap_where(rectangle));
  fails("T2", digon, swap_where(segment));
  fails("T3", even, swap_where(rectangle));
  fails("T3", even, swap_where([](const theory::Configuration& c) { return c.merged(); }));
  fails("T4", study_of(theory::kQuad, sides({6, 5, 5, 8})), swap_where(rectangle));
  // The edges along which a v6 is parted are found in another order.
  const auto swap_parting = [](PairStudy& x) {
    std::vector<enumerate::FoundMove*> parting;
    for (enumerate::FoundMove& move : x.found.moves) {
      if (!x.found.holds_pair(move.from)) parting.push_back(&move);
    }
    REQUIRE(parting.size() == 3);
    std::swap(parting[0]->move.frame, parting[1]->move.frame);
  };
  fails("T3", even, swap_parting);
  fails("F1", even, swap_parting);
  const auto other_d1 = [&](PairStudy& x) {
    auto& reading = x.found.nodes[static_cast<std::size_t>(first_made(x).to)].reading;
    reading.configuration.parameters.d1 += 3;
    for (auto& f : reading.frames) f.labelling.parameters.d1 += 3;
  };
  fails("P1", quad, other_d1);
  fails("P1", quad, [](PairStudy& x) { x.found.moves.pop_back(); });
  fails("P1", quad, [&](PairStudy& x) {
    first_made(x) = *std::find_if(x.found.moves.begin(), x.found.moves.end(), [&](const auto& m) {
      return m.to >= 0 && &m != &first_made(x) && m.from == first_made(x).from;
    });
  });
  fails("P2", digon, other_d1);
  fails("P2", hexagon, other_d1);
  fails("P3", hexagon, [&](PairStudy& x) { ++first_made(x).faces_made; });
  fails("P3", digon, [](PairStudy& x) { ++x.found.nodes[0].reading.configuration.parameters.d1; });
  fails("P3", quad, [&](PairStudy& x) { ++first_made(x).move.frame.d2; });
  fails("N4", hexagon, [&](PairStudy& x) { ++first_made(x).operations; });
  fails("N4", quad, [&](PairStudy& x) { std::swap(first_made(x).before, first_made(x).after); });
  fails("G1", digon, [](PairStudy& x) {
    // Every valid mesh obeys the law. So this mesh has lost a vertex from its arrays, and the sum lacks its index.
    const auto& m = x.found.nodes[0].region.mesh;
    std::vector<mesh::HalfEdgeId> twin, out;
    std::vector<mesh::VertexId> origin;
    for (int h = 0; h < m.half_edge_capacity(); ++h) {
      twin.push_back(m.twin(mesh::HalfEdgeId(h)));
      origin.push_back(m.origin(mesh::HalfEdgeId(h)));
    }
    for (int v = 0; v < m.vertex_capacity(); ++v) out.push_back(m.out(mesh::VertexId(v)));
    out.back() = mesh::HalfEdgeId();
    x.found.nodes[0].region.mesh = mesh::QuadMesh::from_arrays_unchecked(twin, origin, out);
  });
  fails("L8", digon,
        [](PairStudy& x) { x.found.nodes[0].reading.frames.push_back(x.found.nodes[0].reading.frames[0]); });
  fails("L8", hexagon, [](PairStudy& x) { ++x.found.nodes[0].reading.frames[0].frame.d2; });
  fails("L9", digon, [](PairStudy& x) {
    // Three quads in the shape of an L have five corners and no curvature.
    x.found.nodes[0].region = {mesh::QuadMesh::from_faces(8, tests::FaceList{{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}}),
                               mesh::HalfEdgeId(0)};
  });
  fails("L10", hexagon, [](PairStudy& x) { std::swap(x.found.nodes[0].signature, x.found.nodes[1].signature); });
  fails("T11", quad, [](PairStudy& x) {
    x.found.nodes[1].region = x.found.nodes[0].region;
    x.found.nodes[1].reading.frames = x.found.nodes[0].reading.frames;
  });
  fails("T11", hexagon, [](PairStudy& x) { ++x.found.nodes[0].reading.frames[0].labelling.parameters.e(2); });
  const auto swap_extents = [](PairStudy& x) {
    for (auto& node : x.found.nodes) {
      theory::StripParameters& p = node.reading.frames[0].labelling.parameters;
      std::swap(p.d1, p.d2);
    }
  };
  fails("U2", digon, swap_extents);
  fails("U3", even, swap_extents);
  for (const char* id : {"L8", "D5", "S1"}) {
    fails(id, study_of(theory::kQuad, sides({3, 2, 2, 3})),
          [](PairStudy& x) { x.found.nodes[0].signature = mesh::signature(tests::grid(3, 3)); });
  }
  fails("M1", hexagon, lose_last_node);
  // Several starts: every configuration is there, but no moves join them.
  const auto forget_moves = [](PairStudy& x) { x.found.moves.clear(); };
  fails("M1", study_moves(enumerate::explore_all({theory::kDigon, sides({6, 6})}, theory::Apex::with)), forget_moves);
  fails("M1", digon, [](PairStudy& x) { x.searched->push_back(mesh::signature(tests::grid(3, 3))); });
  fails("R1", quad, [](PairStudy& x) { x.found.nodes[0].signature += "0"; });
  fails("F1", digon, [](PairStudy& x) { ++x.found.nodes[0].reading.configuration.parameters.d1; });
  fails("F1", digon,
        [&](PairStudy& x) { x.found.moves.erase(x.found.moves.begin() + (&first_made(x) - x.found.moves.data())); });
  fails("F1", hexagon, lose_last_node);
  fails("N1", quad, [](PairStudy& x) { x.shape = {theory::kQuad, sides({5, 4, 5, 4})}; });
  fails("N1", quad, [](PairStudy& x) { x.found.nodes[0].region = tests::grid(3, 3); });
  fails("N1", quad, [](PairStudy& x) { x.found.nodes[0].reading.irregular.pop_back(); });
  fails("N2", digon, [](PairStudy& x) { ++x.found.nodes[0].reading.configuration.parameters.d1; });
  fails("N2", digon, [](PairStudy& x) {
    std::erase_if(x.found.moves, [&](const auto& m) { return m.to >= 0 && !x.found.holds_pair(m.to); });
  });

  // The found graph lacks the moves out of merged configurations. So a distance differs from the length of a path.
  fails("R1", digon, [&](PairStudy& x) {
    std::erase_if(x.found.moves, [&](const auto& m) { return m.to >= 0 && !x.found.holds_pair(m.from); });
  });

  // Claims about one irregular vertex: another vertex is in its place, or configurations are missing.
  const auto single = [](int valence, theory::Integer length) {
    const RegionCase region = VertexCase{theory::IntegerVector::Constant(valence, length)};
    return std::get<VertexStudy>(study(region, kAll));
  };
  fails("T1", single(5, 4), [](VertexStudy& x) { x.searched->clear(); });
  fails("T1", single(5, 4), [](VertexStudy& x) { x.glued.clear(); });
  fails("T1", single(8, 3), [](VertexStudy& x) { x.searched->pop_back(), x.glued.pop_back(); });
  fails("T1", single(5, 4),
        [](VertexStudy& x) { x.glued.push_back(x.glued[0]), x.searched->push_back(x.searched->front()); });
  const auto instead = [](const VertexStudy& other) { return [other](VertexStudy& x) { x.glued = other.glued; }; };
  fails("A2", single(3, 6), [&](VertexStudy& x) { x.glued = single(5, 6).glued; });
  fails("A3", single(4, 6), instead(single(5, 6)));
  fails("N5", single(4, 8), instead(single(5, 6)));
  fails("B1", single(5, 6), [&](VertexStudy& x) { x.glued = single(3, 6).glued; });
  fails("A6", single(5, 6), [&](VertexStudy& x) { x.glued = single(6, 6).glued; });
  fails("A4", single(2, 6), instead(single(3, 6)));
  fails("A4", single(6, 6), instead(single(7, 8)));
  // This region has a v3 and a far v5. Claims about the neighbourhood of a vertex do not apply where other vertices are
  // irregular.
  VertexStudy not_single = single(3, 6);
  not_single.glued = {quad.found.nodes[0].region};
  CHECK_FALSE(claim("B1").judge(not_single).applies);
  fails("P4", digon, [](PairStudy& x) {
    // The configuration that the transport should make is missing.
    for (auto& node : x.found.nodes) node.signature += "0";
  });
  fails("P4", quad, [&](PairStudy& x) {
    for (auto& node : x.found.nodes) node.signature += "0";
  });
  // Claim P5: what pipelines and slides make is unknown, and what the move makes is another mesh.
  const PairStudy apart = study_of(theory::kQuad, sides({2, 3, 5, 6}));
  fails("P5", apart, [](PairStudy& x) {
    for (auto& node : x.found.nodes) node.signature += "0";
  });
  fails("P5", apart, [](PairStudy& x) {
    for (auto& move : x.found.moves) move.to = move.to < 0 ? move.to : move.from;
  });
  fails("P5", apart, [](PairStudy& x) { x.found.nodes.back().signature += "0"; });
  const auto three = [](const theory::IntegerVector& s) {
    return std::get<TripleStudy>(study(TripleCase{{3, 3, 5}, s}, kAll));
  };
  const TripleStudy equal = three(sides({4, 4, 4}));
  REQUIRE(equal.fewer.at({3}).size() == 1);
  fails("N3", equal, [](TripleStudy& x) { x.fewer.erase({3}); });
  fails("N3", equal, [](TripleStudy& x) { x.fewer.at({3}).front() += "0"; });
  const TripleStudy other = three(sides({2, 4, 6}));
  REQUIRE(other.fewer.count({2, 5}) == 1);
  fails("N3", other, [](TripleStudy& x) { x.fewer.erase({2, 5}); });
  fails("N3", other, [](TripleStudy& x) { x.fewer[{3}].push_back("0"); });
  // An edit that makes something unknown, fillings that no edit joins to the rest, and fillings from which no edit leads
  // to fewer vertices.
  fails("N3", equal, [](TripleStudy& x) { x.edits.front().push_back({{3, 3, 5}, "0"}); });
  fails("N3", other, [](TripleStudy& x) { x.edits.back().push_back({{2, 5}, "0"}); });
  fails("N3", three(sides({4, 5, 5})), [](TripleStudy& x) {
    for (auto& edits : x.edits) edits.clear();
  });
  const auto three_v5 = [](const theory::IntegerVector& s) {
    return std::get<TripleStudy>(study(TripleCase{{5, 5, 5}, s}, kAll));
  };
  // No filling has fewer irregular vertices. This is the region of the erratum.
  const TripleStudy no_room = three_v5(sides({2, 2, 3, 3, 2, 2, 4}));
  CHECK(no_room.fewer.empty());
  CHECK(claim("N3").judge(no_room).row["not_edited"] == no_room.signatures);
  CHECK(find_errata().back().instance.find("sides 2 2 3 3 2 2 4") != std::string::npos);
  CHECK(find_errata().back().instance.find(no_room.signatures.front()) != std::string::npos);
  fails("N3", no_room, [](TripleStudy& x) { x.fewer[{5, 6}].push_back("0"); });
  const TripleStudy room = three_v5(sides({2, 3, 2, 4, 2, 3, 4}));
  fails("N3", room, [](TripleStudy& x) { x.fewer.clear(); });
  // Claim A1 for a pair that is not adjacent.
  const PairStudy adjacent = study_of(theory::kQuad, sides({5, 4, 4, 5}));
  fails("A1", adjacent, [&](PairStudy& x) {
    for (auto& node : x.found.nodes)
      node.region = enumerate::glue_region(theory::kQuad, {{2, 1, theory::IntegerVector::Constant(4, 2)}, 1});
  });
}

// Claim P6 makes its own moves on the surfaces that it makes. So here the moves are falsified.
TEST_CASE("claim P6 fails on falsified moves", "[verify]") {
  using mesh::PairStep;
  fails("P6", study_of(theory::kQuad, sides({3, 2, 2, 3})),
        [](PairStudy& x) { x.found.nodes[0].reading.frames[0].labelling.parameters.e.setConstant(2); });
  const PairStudy digon = study_of(theory::kDigon, sides({6, 6}));
  const auto& node = *std::find_if(digon.found.nodes.begin(), digon.found.nodes.end(), [](const auto& n) {
    return n.reading.configuration.d1() == 1 && n.reading.configuration.d2() == 1;
  });
  const mesh::QuadMesh& m = node.region.mesh;
  const auto& irregular = node.reading.irregular;
  for (const mesh::PairMove& move : mesh::pair_moves(m, irregular[0], irregular[1])) {
    mesh::QuadMesh after = m;
    const mesh::MoveReport report = mesh::move_pair(after, move);
    INFO(mesh::name(move.step));
    REQUIRE(report.refusal == mesh::Refusal::none);
    CHECK(surface_move_problem(m, move, after, report) == "");
    const auto wrong = [&](const auto& falsify) {
      mesh::PairMove other_move = move;
      mesh::QuadMesh other_mesh = after;
      mesh::MoveReport other = report;
      falsify(other_move, other_mesh, other);
      CHECK(surface_move_problem(m, other_move, other_mesh, other) != "");
    };
    using Move = mesh::PairMove;
    using Mesh = mesh::QuadMesh;
    using Report = mesh::MoveReport;
    wrong([](Move&, Mesh&, Report& r) { r.refusal = mesh::Refusal::edge_exists; });
    wrong([&](Move&, Mesh& x, Report& r) { x = m, r.refusal = mesh::Refusal::edge_exists; });  // there is room
    wrong([&](Move&, Mesh& x, Report&) { x = m; });
    wrong([](Move& x, Mesh&, Report&) { x.step = x.step == PairStep::close ? PairStep::open : PairStep::close; });
    wrong([](Move& x, Mesh&, Report&) { ++x.frame.d1; });
    wrong([](Move&, Mesh&, Report& r) { r.undo.pop_back(); });
    wrong([&](Move&, Mesh&, Report& r) { r.after[1] = m.origin(node.region.root); });
    wrong([](Move&, Mesh&, Report& r) {
      r.inverse.step = r.inverse.step == PairStep::slide_first ? PairStep::slide_second : PairStep::slide_first;
    });
  }
}
