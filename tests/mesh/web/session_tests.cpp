// The editing session behind the editor in the browser, by its laws (mesh/web/session.hpp), on the examples' meshes.
#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <set>

#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/topology/validate.hpp"
#include "mesh/web/scene.hpp"
#include "mesh/web/session.hpp"
#include "tests/mesh/web/session_selections.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/mesh/regions.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;
using namespace requad::tests;
using web::Offer;
using web::Selection;
using web::Session;
using SelectionKind = Selection::Kind;

namespace {

// Selections of each kind: at every irregular vertex of a kind, and at some others.
std::vector<Selection> some_selections(const Session& session) {
  const QuadMesh& m = session.mesh();
  std::vector<Selection> all;
  const std::vector<VertexId> irregular(session.irregular().begin(), session.irregular().end());
  for (std::size_t i = 0; i < irregular.size() && i < 6; ++i) {
    all.push_back(one_vertex(irregular[i]));
    for (std::size_t j = 0; j < irregular.size() && j < 6; ++j) {
      if (i != j) all.push_back(a_pair(irregular[i], irregular[j]));
    }
    const HalfEdgeId h = m.out(irregular[i]);
    all.push_back(an_edge(m.origin(h), m.target(h)));
    all.push_back(an_edge(m.target(h), m.origin(h)));
    all.push_back(a_quad(QuadMesh::face(h)));
  }
  const std::vector<VertexId> vertices = m.vertices();
  for (std::size_t i = 0; i < vertices.size(); i += 1 + vertices.size() / 5) {
    all.push_back(one_vertex(vertices[i]));
    all.push_back(an_edge(vertices[i], m.target(m.out(vertices[i]))));
  }
  return all;
}

// By id, the valence of each vertex and the corners of each quad.
struct Connectivity {
  std::map<VertexId, int> valences;
  std::map<FaceId, std::array<VertexId, 4>> corners;
};
Connectivity connectivity(const QuadMesh& m) {
  Connectivity result;
  for (const VertexId v : m.vertices()) result.valences[v] = m.valence(v);
  for (const FaceId f : m.faces()) result.corners[f] = m.corners(f);
  return result;
}
// The keys of `before` that have another value after, or none.
template <class Key, class Value>
std::vector<Key> different(const std::map<Key, Value>& before, const std::map<Key, Value>& after) {
  std::vector<Key> keys;
  for (const auto& [key, value] : before) {
    const auto now = after.find(key);
    if (now == after.end() || now->second != value) keys.push_back(key);
  }
  return keys;
}

bool same_live_positions(const QuadMesh& m, const Positions& a, const Positions& b) {
  const std::vector<VertexId> vertices = m.vertices();
  return std::all_of(vertices.begin(), vertices.end(), [&](VertexId v) { return same_bits(a[v.slot()], b[v.slot()]); });
}

const Offer& offer_called(const web::Offers& offers, const std::string& name) {
  const auto found =
      std::find_if(offers.list.begin(), offers.list.end(), [&](const Offer& o) { return o.name == name; });
  REQUIRE(found != offers.list.end());
  return *found;
}

}  // namespace

TEST_CASE("law web-1: an offer shows exactly what is then done", "[session]") {
  for (const char* name : {"figure-16", "figure-17", "figure-18"}) {
    Session session(surface_of(example_mesh(name)));
    int made = 0;
    std::map<SelectionKind, int> legal;
    for (const Selection& selection : some_selections(session)) {
      const QuadMesh before = session.mesh();
      const Positions positions = session.positions();
      const web::Offers offers = session.offers(selection);  // a copy, since steps follow
      REQUIRE(session.mesh() == before);
      REQUIRE(same_live_positions(before, positions, session.positions()));
      const Connectivity was = connectivity(before);
      std::set<std::string> names;
      for (const Offer& offer : offers.list) {
        CAPTURE(name, static_cast<int>(selection.kind), offer.name, offer.why);
        CHECK(names.insert(offer.name).second);
        const std::string why = session.perform(selection, offer.name);
        REQUIRE(why == offer.why);
        if (!offer.is_legal()) {
          REQUIRE(session.mesh() == before);
          continue;
        }
        ++made;
        ++legal[selection.kind];
        REQUIRE(validate(session.mesh()).empty());
        const Connectivity is = connectivity(session.mesh());
        REQUIRE(offer.vertices == different(was.valences, is.valences));
        REQUIRE(offer.quads == different(was.corners, is.corners));
        REQUIRE(session.mesh().face_count() ==
                before.face_count() + offer.counts.faces_made - offer.counts.faces_deleted);
        if (selection.kind == SelectionKind::pair || selection.kind == SelectionKind::vertex)
          REQUIRE_FALSE(offer.effect.empty());
        const std::vector<VertexId> irregular = irregular_vertices(session.mesh());
        REQUIRE(std::vector<VertexId>(session.irregular().begin(), session.irregular().end()) == irregular);
        REQUIRE(session.describe().inverted == diagnose(session.mesh(), session.positions()).inverted);
        REQUIRE(session.undo());
        REQUIRE(session.mesh() == before);
        REQUIRE(same_live_positions(before, positions, session.positions()));
      }
    }
    CHECK(made > 100);
    CHECK(legal.size() == 4);
  }
}

TEST_CASE("quick offers are the first of all offers, and every offer can be made after them", "[session]") {
  Session session(surface_of(example_mesh("figure-17")));
  int later = 0;
  for (const Selection& selection : some_selections(session)) {
    const web::Offers quick = session.quick_offers(selection);  // copies
    const web::Offers all = session.offers(selection);
    CHECK_FALSE(all.more);
    CHECK(quick.more == (quick.list.size() < all.list.size()));
    CHECK(session.quick_offers(selection).list.size() == all.list.size());
    REQUIRE(quick.list.size() <= all.list.size());
    for (std::size_t i = 0; i < quick.list.size(); ++i) {
      CHECK(quick.list[i].name == all.list[i].name);
      CHECK(quick.list[i].why == all.list[i].why);
    }
    for (std::size_t i = quick.list.size(); i < all.list.size(); ++i) {
      if (!all.list[i].is_legal()) continue;
      ++later;
      session.quick_offers(one_vertex(*session.irregular().begin()));  // those of the selection are forgotten
      session.quick_offers(selection);
      REQUIRE(session.perform(selection, all.list[i].name).empty());
      REQUIRE(session.undo());
    }
  }
  CHECK(later > 5);
}

TEST_CASE("law web-2: undo and redo restore every id and bit, without limit", "[session]") {
  Session session(surface_of(example_mesh("figure-17")));
  std::mt19937 random(2011);
  std::vector<QuadMesh> meshes{session.mesh()};
  std::vector<Positions> positions{session.positions()};
  std::vector<std::string> scripts{session.script()};
  while (meshes.size() < 40) {
    const std::vector<VertexId> vertices = session.mesh().vertices();
    const VertexId v = vertices[random() % vertices.size()];
    const web::Offers offers = session.offers(one_vertex(v));
    if (offers.list.empty()) continue;
    if (!session.perform(one_vertex(v), offers.list[random() % offers.list.size()].name).empty()) continue;
    meshes.push_back(session.mesh());
    positions.push_back(session.positions());
    scripts.push_back(session.script());
  }
  const auto is_at = [&](std::size_t i) {
    CAPTURE(i);
    CHECK(session.steps().size() == i);
    CHECK(session.undone().size() == meshes.size() - 1 - i);
    CHECK(session.mesh() == meshes[i]);
    CHECK(same_live_positions(meshes[i], positions[i], session.positions()));
    CHECK(session.script() == scripts[i]);
  };
  for (std::size_t i = meshes.size() - 1; i > 0; --i) {
    is_at(i);
    CHECK(session.undo());
  }
  is_at(0);
  CHECK_FALSE(session.undo());
  for (std::size_t i = 1; i < meshes.size(); ++i) {
    CHECK(session.redo());
    is_at(i);
  }
  CHECK_FALSE(session.redo());
  // Another edit in place of the undone ones ends them.
  CHECK(session.undo());
  CHECK(session.undo());
  const web::Offers offers = session.offers(a_quad(session.mesh().faces()[40]));
  REQUIRE(offers.list.front().is_legal());
  CHECK(session.perform(a_quad(session.mesh().faces()[40]), offers.list.front().name).empty());
  CHECK(session.undone().empty());
  CHECK(session.steps().size() == meshes.size() - 2);
}

TEST_CASE("law web-3: steps are those of requad-edit, which replays the script", "[session]") {
  const std::string input = example_mesh("figure-17");
  for (const auto& [command, name] : std::map<std::string, std::string>{
           {"move IN 153 163 --step slide_first", "slide_first"}, {"cancel IN 153 163", "cancel"}}) {
    CAPTURE(command);
    Session session(surface_of(input));
    const Selection selection = a_pair(session.numbered(153), session.numbered(163));
    REQUIRE(session.perform(selection, name).empty());
    std::string arguments = command;
    arguments.replace(arguments.find("IN"), 2, input);
    REQUIRE(call("edit", arguments + " --force -o made.obj --script made.txt").code == 0);
    if (name == "slide_first") {
      CHECK(session.export_obj() == slurp(scratch() / "made.obj"));
      CHECK(session.script() == slurp(scratch() / "made.txt"));
    }
    // Further steps, of other kinds.
    const FaceId f = session.mesh().faces()[7];
    REQUIRE(session.perform(a_quad(f), session.offers(a_quad(f)).list.front().name).empty());
    const VertexId v = *session.irregular().begin();
    const web::Offers atomic = session.offers(one_vertex(v));
    const auto first =
        std::find_if(atomic.list.begin(), atomic.list.end(), [](const Offer& o) { return o.is_legal(); });
    REQUIRE(first != atomic.list.end());
    REQUIRE(session.perform(one_vertex(v), first->name).empty());
    spill(scratch() / "session.txt", session.script());
    REQUIRE(call("edit", "apply " + input + " session.txt --force -o replayed.obj").code == 0);
    CHECK(slurp(scratch() / "replayed.obj") == session.export_obj());
  }
}

TEST_CASE("the four moves of a pair have their extents and arrows", "[session]") {
  for (const auto& [l1, l2] : {std::pair(3, 3), std::pair(5, 5), std::pair(3, 5)}) {
    const PairShape shape{l1, l2, 2, 3};
    Session session(surface_of(pair_region(shape, std::vector<int>(static_cast<std::size_t>(shape.side_count()), 3))));
    REQUIRE(session.irregular().size() == 2);
    const VertexId a = *session.irregular().begin(), b = *session.irregular().rbegin();
    const web::Offers offers = session.offers(a_pair(a, b));
    CHECK(offers.why.empty());
    for (const char* name : {"slide_first", "slide_second", "open", "close"}) {
      CAPTURE(l1, l2, name);
      const Offer& offer = offer_called(offers, name);
      CHECK(offer.is_legal());
      CHECK(offer.effect.find(l1 == l2 ? ") becomes (" : ") stays") != std::string::npos);
      REQUIRE(offer.arrows.size() == 2);
      for (const web::Arrow& arrow : offer.arrows) CHECK((arrow.to - arrow.from).norm() > 0);
      CHECK(same_bits(offer.arrows[0].from, session.positions()[a.slot()]));
      CHECK(same_bits(offer.arrows[1].from, session.positions()[b.slot()]));
    }
    const Session::Rectangle rectangle = session.rectangle(a, b);
    CHECK(rectangle.quads.size() == 6);
    CHECK(rectangle.rim.size() == 11);
    CHECK(session.separatrices(a).size() == static_cast<std::size_t>(session.mesh().valence(a)));
  }
}

TEST_CASE("what cannot be done is refused in words, with what would help", "[session]") {
  Session session(surface_of(pair_region({3, 3, 1, 2}, {1, 1})));
  const VertexId a = *session.irregular().begin(), b = *session.irregular().rbegin();
  const web::Offers merge = session.offers(a_pair(a, b));
  CHECK(offer_called(merge, "merge").why ==
        "the pair is an odd number of edges apart, and parity never changes (Theorems 7.2, 7.3)");
  CHECK(offer_called(merge, "close").why == "a boundary vertex would change its valence");
  CHECK(session.offers(one_vertex(a)).hint.find("Theorem 7.1") != std::string::npos);
  VertexId boundary;
  for (const VertexId v : session.mesh().vertices()) {
    if (session.mesh().is_boundary(v)) boundary = v;
  }
  const web::Offers at_boundary = session.offers(one_vertex(boundary));
  CHECK(at_boundary.why == "a boundary vertex would change its valence");
  CHECK_FALSE(at_boundary.hint.empty());
  CHECK(session.offers(a_pair(a, boundary)).why == "the vertices do not have the valences that this needs");
  const HalfEdgeId h = session.mesh().out(boundary);
  for (const Offer& offer : session.offers(an_edge(session.mesh().target(h), boundary)).list)
    CHECK(offer.why == "a boundary edge cannot be flipped");
  CHECK(session.perform(a_pair(a, b), "no such move") == "this is not among the edits of the selection");
  CHECK(session.perform(a_pair(a, VertexId(1'000'000)), "open") == "no such element");
  CHECK(session.steps().empty());
  // A lone 3-5 pair.
  Session lone(surface_of(pair_region({3, 5, 1, 2}, {2, 2, 2, 2})));
  const web::Offers cancel = lone.offers(a_pair(*lone.irregular().begin(), *lone.irregular().rbegin()));
  CHECK(offer_called(cancel, "cancel").why ==
        "a 3-5 pair cannot be cancelled without a third irregular vertex (Theorem 7.4)");
}

TEST_CASE("files are opened with the errors of the programs", "[session]") {
  const auto error = [](const std::string& text, const std::string& name) {
    try {
      Session::read(text, name, false);
    } catch (const FileError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const auto& [name, text] : std::map<std::string, std::string>{{"triangle.obj", triangle},
                                                                     {"word.obj", "v 0 0 zero\n"},
                                                                     {"none.obj", ""},
                                                                     {"short.off", "OFF\n4 1 0\n0 0 0\n"},
                                                                     {"binary.off", "OFF BINARY\n"},
                                                                     {"mesh.stl", "solid"},
                                                                     {"zero.obj", std::string("v 0 0\0 0", 8)}}) {
    CAPTURE(name);
    spill(scratch() / name, text);
    const std::string told = call("edit", "info " + name).err;
    REQUIRE_FALSE(error(text, name).empty());
    CHECK(told == "requad-edit: " + error(text, name) + "\n");
  }
  CHECK(Session::read(triangle, "triangle.obj", true).mesh.face_count() == 3);
  CHECK(Session::read("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "quad.off", false).mesh.face_count() == 1);
}

TEST_CASE("the session describes the mesh, and tells what changed", "[session]") {
  Session session(surface_of(example_mesh("figure-17")));
  const web::Description d = session.describe();
  CHECK(d.vertices == session.mesh().vertex_count());
  CHECK(d.genus == 0);
  CHECK(d.boundary_loops == 0);
  CHECK(d.index_sum == 8);  // discrete Gauss-Bonnet on a sphere: 4 chi
  CHECK(d.least_irregular() == 8);
  int irregular = 0;
  for (const auto& [valence, count] : d.irregular) irregular += count;
  CHECK(irregular == static_cast<int>(irregular_vertices(session.mesh()).size()));
  CHECK(session.take_changes().everything);
  CHECK_FALSE(session.take_changes().everything);
  // Each quad whose corners changed or moved is told, and the number of those told does not depend on the mesh.
  const VertexId a = session.numbered(153), b = session.numbered(163);
  CHECK(session.number(a) == 153);
  const auto nearest = session.nearest_irregular(a, 3);
  CHECK(std::find(nearest.begin(), nearest.end(), b) != nearest.end());
  for (const auto& change :
       std::vector<std::function<bool()>>{[&] { return session.perform(a_pair(a, b), "slide_first").empty(); },
                                          [&] { return session.undo(); }, [&] { return session.redo(); }}) {
    const QuadMesh before = session.mesh();
    const Positions positions = session.positions();
    REQUIRE(change());
    const web::Changes changes = session.take_changes();
    CHECK_FALSE(changes.everything);
    std::vector<FaceId> expected;
    for (int f = 0; f < std::max(before.face_capacity(), session.mesh().face_capacity()); ++f) {
      const FaceId face(f);
      const bool was = before.is_live(face), is = session.mesh().is_live(face);
      bool same = was == is;
      if (was && is) {
        same = before.corners(face) == session.mesh().corners(face);
        for (const VertexId v : before.corners(face))
          same = same && same_bits(positions[v.slot()], session.positions()[v.slot()]);
      }
      if (!same) expected.push_back(face);
    }
    CHECK(std::includes(changes.quads.begin(), changes.quads.end(), expected.begin(), expected.end()));
    CHECK(changes.quads.size() < expected.size() + 60);
  }
}

TEST_CASE("a ray points at a corner, an edge or the quad", "[session]") {
  Session session(Session::read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "quad.obj", false));
  const auto at = [&session](double x, double y) { return session.pointed_at(FaceId(0), {x, y, 5}, {0, 0, -2}); };
  CHECK(at(0.9, 0.1).kind == SelectionKind::vertex);
  CHECK(at(0.9, 0.1).a == VertexId(1));
  CHECK(at(0.5, 0.05).kind == SelectionKind::edge);
  CHECK(at(0.5, 0.05).a == VertexId(0));
  CHECK(at(0.5, 0.05).b == VertexId(1));
  CHECK(at(0.5, 0.5).kind == SelectionKind::quad);
  CHECK(at(0.5, 0.5).quad == FaceId(0));
}

TEST_CASE("law web-4: the scene that is updated is the one that is made anew", "[session]") {
  Session session(surface_of(example_mesh("figure-18")));
  session.take_changes();
  web::Scene scene(session.mesh(), session.positions());
  CHECK(scene.radius() > 0);
  std::mt19937 random(5);
  int steps = 0;
  while (steps < 150) {
    const std::vector<FaceId> faces = session.mesh().faces();
    const Selection at = a_quad(faces[random() % faces.size()]);
    const Selection corner = one_vertex(session.mesh().corners(at.quad)[0]);
    const Selection& selection = random() % 3 == 0 ? at : corner;
    const web::Offers& offers = session.offers(selection);
    if (offers.list.empty()) continue;
    const std::string name = offers.list[random() % offers.list.size()].name;
    if (!session.perform(selection, name).empty()) continue;
    if (random() % 4 == 0) REQUIRE(session.undo());
    ++steps;
    scene.update(session.mesh(), session.positions(), session.take_changes().quads);
    const web::Scene fresh(session.mesh(), session.positions());
    const std::size_t quads = static_cast<std::size_t>(std::min(scene.quad_capacity(), fresh.quad_capacity()));
    REQUIRE(scene.quad_capacity() >= session.mesh().face_capacity());
    REQUIRE(std::equal(scene.corners().begin(),
                       scene.corners().begin() + static_cast<std::ptrdiff_t>(web::Scene::kFloats * quads),
                       fresh.corners().begin()));
    REQUIRE(std::equal(scene.triangles().begin(), scene.triangles().begin() + static_cast<std::ptrdiff_t>(6 * quads),
                       fresh.triangles().begin()));
  }
}
