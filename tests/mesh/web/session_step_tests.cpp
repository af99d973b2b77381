// Steps of the editor's session beside moves: features, smoothing, scripts, reductions; the stages of a step; and what
// colours tell.
#include <algorithm>
#include <map>
#include <set>

#include "mesh/topology/separatrix.hpp"
#include "mesh/topology/validate.hpp"
#include "mesh/web/paint.hpp"
#include "mesh/web/scene.hpp"
#include "mesh/web/session.hpp"
#include "tests/mesh/web/editing_in_browser.hpp"
#include "tests/mesh/web/session_selections.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;
using namespace requad::tests;
using web::Offer;
using web::Paint;
using web::Selection;
using web::Session;

namespace {

bool has_positions(const Session& session, const Positions& positions) {
  const std::vector<VertexId> all = session.mesh().vertices();
  return std::all_of(all.begin(), all.end(),
                     [&](VertexId v) { return same_bits(session.positions()[v.slot()], positions[v.slot()]); });
}

}  // namespace

TEST_CASE("features are steps: edits keep them, and undo gives the former ones back", "[session]") {
  Session session(surface_of(example_mesh("figure-17")));
  REQUIRE(session.features().empty());
  session.take_changes();
  const FeatureEdges sharp = session.sharp(40);
  REQUIRE(sharp.size() > 10);
  CHECK(session.sharp(100).empty());
  REQUIRE(session.set_features(sharp).empty());
  CHECK(session.features() == sharp);
  CHECK(session.take_changes().features);
  CHECK(session.describe().features == static_cast<int>(sharp.size()));
  CHECK_FALSE(session.set_features(sharp).empty());
  CHECK(session.steps().size() == 1);
  // By hand: one becomes an ordinary edge, and is one again after undo.
  const VertexId a = sharp.front()[0], b = sharp.front()[1];
  const auto refused = [&] {
    int count = 0;
    for (const Offer& offer : session.offers(an_edge(a, b)).list)
      count += offer.why == FeatureRefusal::breaks_feature.clause() ? 1 : 0;
    return count;
  };
  CHECK(refused() >= 2);
  REQUIRE(session.perform(an_edge(b, a), "make it no feature").empty());
  CHECK(session.features().size() == sharp.size() - 1);
  CHECK(refused() == 0);
  REQUIRE(session.perform(an_edge(a, b), "make it a feature").empty());
  CHECK(session.features() == sharp);
  // An edit that keeps them, then back and forth past changes of features.
  std::string made;
  const VertexId v = *session.irregular().begin();
  for (const Offer& offer : session.offers({Selection::Kind::vertex, v, {}, {}}).list) {
    if (offer.is_legal()) made = offer.name;
  }
  REQUIRE_FALSE(made.empty());
  REQUIRE(session.perform({Selection::Kind::vertex, v, {}, {}}, made).empty());
  REQUIRE(session.set_features({}).empty());
  const std::string script = session.script();
  while (session.undo()) {
  }
  CHECK(session.features().empty());
  REQUIRE(session.redo());
  CHECK(session.features() == sharp);
  while (session.redo()) {
  }
  CHECK(session.features().empty());
  CHECK(session.script() == script);
}

TEST_CASE("smoothing moves what is near, and no connectivity", "[session]") {
  Session session(surface_of(example_mesh("figure-16")));
  const QuadMesh before = session.mesh();
  const Positions positions = session.positions();
  const VertexId centre = *session.irregular().begin();
  REQUIRE(session.smooth(std::array{centre}, 2).empty());
  CHECK(session.mesh() == before);
  BreadthFirstDistances near;
  const auto always = [](VertexId) { return true; };
  near.measure(before, std::array{centre}, always, always, [](VertexId, int) { return false; });
  int moved = 0;
  for (const VertexId v : before.vertices()) {
    if (same_bits(session.positions()[v.slot()], positions[v.slot()])) continue;
    ++moved;
    CHECK(near.distance(v) <= 2);
  }
  CHECK(moved > 5);
  REQUIRE(session.smooth({}, 0).empty());
  CHECK(session.steps().size() == 2);
  CHECK(session.undo());
  CHECK(session.undo());
  CHECK(has_positions(session, positions));
  // A single quad has no vertex that may move.
  Session quad(Session::read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "quad.obj", false));
  CHECK(quad.smooth({}, 0) == "nothing moves: all these vertices are fixed");
  CHECK(quad.steps().empty());
}

TEST_CASE("a script is replayed on the mesh that was opened, and on no other", "[session]") {
  Session session(surface_of(example_mesh("figure-17")));
  REQUIRE(session.perform(a_pair(session.numbered(153), session.numbered(163)), "slide_first").empty());
  const std::string script = session.script(), made = session.export_obj();
  Session again(surface_of(example_mesh("figure-17")));
  REQUIRE(again.apply(script, "edits.txt").empty());
  CHECK(again.export_obj() == made);
  CHECK(again.script() == script);
  CHECK(std::vector<VertexId>(again.irregular().begin(), again.irregular().end()) == irregular_vertices(again.mesh()));
  CHECK(again.apply(script, "edits.txt") == "a script starts from the mesh as it was opened; undo all steps first");
  REQUIRE(again.undo());
  REQUIRE(again.redo());
  CHECK(again.export_obj() == made);
  Session other(surface_of(example_mesh("figure-16")));
  CHECK_THROWS_AS(other.apply(script, "edits.txt"), FileError);
  CHECK(other.steps().empty());
}

TEST_CASE("a script that is replayed ends a reduction", "[session]") {
  Session session(surface_of(example_mesh("figure-17")));
  const std::string script = session.script();  // without edits
  session.start_reduction(0, -1);
  REQUIRE(session.reduces());
  REQUIRE(session.apply(script, "empty.txt").empty());
  CHECK_FALSE(session.reduces());
}

TEST_CASE("a reduction makes the edits of requad-edit reduce, one step for each cancellation", "[session]") {
  const std::string input = busy_mesh();
  Session session(Session::read(slurp(input), input, false));
  const QuadMesh before = session.mesh();
  const Positions positions = session.positions();
  session.start_reduction(0, 0.05);
  std::size_t cancelled = 0;
  for (Session::Slice slice = session.reduce(); slice != Session::Slice::ended; slice = session.reduce()) {
    if (slice == Session::Slice::cancelled) ++cancelled;
    REQUIRE(session.steps().size() == cancelled);
    REQUIRE(validate(session.mesh()).empty());
  }
  CHECK(cancelled > 3);
  REQUIRE(session.reduces());
  session.finish_reduction();
  CHECK_FALSE(session.reduces());
  REQUIRE(call("edit", "reduce " + input + " --max-deviation 0.05 --force -o less.obj --script less.txt").code == 0);
  CHECK(session.export_obj() == slurp(scratch() / "less.obj"));
  CHECK(session.script() == slurp(scratch() / "less.txt"));
  std::vector<std::size_t> irregular{session.irregular().size()};
  while (session.undo()) irregular.push_back(session.irregular().size());
  CHECK(std::is_sorted(irregular.begin(), irregular.end()));
  CHECK(session.mesh() == before);
  CHECK(has_positions(session, positions));
  // It stops in time, and another step ends it.
  session.start_reduction(static_cast<int>(session.irregular().size()) - 2, -1);
  while (session.reduce() != Session::Slice::ended) {
  }
  CHECK(session.irregular().size() + 2 <= irregular.back());
  CHECK(session.irregular().size() > irregular.front());
  REQUIRE(session.undo());
  CHECK_FALSE(session.reduces());
}

TEST_CASE("a step is watched operation by operation", "[session]") {
  Session session(surface_of(example_mesh("figure-17"))), watched(surface_of(example_mesh("figure-17")));
  const Selection pair = a_pair(session.numbered(153), session.numbered(163));
  REQUIRE(session.perform(pair, "slide_first").empty());
  QuadMesh before = watched.mesh();
  std::size_t stages = 0;
  const auto watch = [&](std::span<const FaceId> quads) {
    ++stages;
    // Each quad whose corners differ is told.
    for (int f = 0; f < std::max(before.face_capacity(), watched.mesh().face_capacity()); ++f) {
      const FaceId face(f);
      const bool was = before.is_live(face), is = watched.mesh().is_live(face);
      if (was == is && (!was || before.corners(face) == watched.mesh().corners(face))) continue;
      CHECK(std::binary_search(quads.begin(), quads.end(), face));
    }
    before = watched.mesh();
  };
  REQUIRE(watched.perform(pair, "slide_first", watch).empty());
  CHECK(stages == watched.lines(watched.steps().back()).size());
  CHECK(before == watched.mesh());
  CHECK(watched.export_obj() == session.export_obj());
}

TEST_CASE("colours tell adjacent quads apart, join stripes, and mark inverted quads", "[session]") {
  // A torus of even size has a checkerboard of two colours, and stripes that join everywhere.
  const QuadMesh torus = tests::torus(6, 8);
  Positions flat;
  for (int v = 0; v < torus.vertex_capacity(); ++v) flat.emplace_back(v % 6, v / 6, 0);
  const std::vector<float> checks = web::paint_all(torus, flat, Paint::checkerboard);
  const std::vector<float> stripes = web::paint_all(torus, flat, Paint::stripes);
  int seen = 0;
  for (const HalfEdgeId h : torus.half_edges()) {
    const FaceId f = QuadMesh::face(h), g = QuadMesh::face(torus.twin(h));
    if (checks[f.slot()] < 0 || checks[g.slot()] < 0) continue;  // the plane folds where the torus closes
    ++seen;
    CHECK(checks[f.slot()] + checks[g.slot()] == 1);
    CHECK(stripes[f.slot()] == stripes[g.slot()]);
  }
  CHECK(seen > 80);
  const Surface surface = surface_of(example_mesh("figure-18"));
  const std::vector<float> colours = web::paint_all(surface.mesh, surface.positions, Paint::checkerboard);
  for (const HalfEdgeId h : surface.mesh.half_edges()) {
    if (surface.mesh.is_boundary(h)) continue;
    CHECK(colours[QuadMesh::face(h).slot()] != colours[QuadMesh::face(surface.mesh.twin(h)).slot()]);
  }
  const std::vector<float> quality = web::paint_all(surface.mesh, surface.positions, Paint::quality);
  const std::vector<float> plain = web::paint_all(surface.mesh, surface.positions, Paint::plain);
  for (const FaceId f : surface.mesh.faces()) {
    const double expected = scaled_jacobian(surface.mesh, surface.positions, f);
    CHECK(quality[f.slot()] == (expected <= 0 ? -1.0F : static_cast<float>(expected)));
    CHECK(plain[f.slot()] == (expected <= 0 ? -1.0F : 0.0F));
  }
}

TEST_CASE("the boundary is told loop by loop", "[session]") {
  const Surface surface = surface_of(example_mesh("figure-18"));
  const Session session(surface);
  std::set<std::pair<VertexId, VertexId>> expected, told;
  for (const HalfEdgeId h : surface.mesh.half_edges()) {
    if (surface.mesh.is_boundary(h)) expected.emplace(surface.mesh.origin(h), surface.mesh.target(h));
  }
  const auto loops = session.boundary();
  CHECK(static_cast<int>(loops.size()) == session.describe().boundary_loops);
  for (const auto& loop : loops) {
    CHECK(loop.front() == loop.back());
    for (std::size_t i = 1; i < loop.size(); ++i) told.emplace(loop[i - 1], loop[i]);
  }
  CHECK(told == expected);
}
