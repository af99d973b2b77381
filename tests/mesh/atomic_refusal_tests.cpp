// Atomic operations that are refused, atomic operations near features, and requad-edit atomic from outside.
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "mesh/files/write_obj.hpp"
#include "mesh/irregular/atomic_operations.hpp"
#include "tests/mesh/neighbourhoods.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;
using requad::tests::neighbourhood;
using requad::tests::vertex_of;

TEST_CASE("atomic operations are refused with the reason", "[atomic]") {
  // Operations beside the boundary.
  Region grid = tests::grid(3, 3);
  Editor on_grid(grid.mesh);
  const VertexId corner(0), inner(5);  // (0,0) and (1,1)
  CHECK(atomic_operations(on_grid, corner).empty());
  for (const AtomicChoice& choice : atomic_operations(on_grid, inner)) {
    const HalfEdgeId along = choice.operation.along;
    const bool at_boundary =
        grid.mesh.is_boundary(grid.mesh.target(along)) || grid.mesh.is_boundary(grid.mesh.origin(along));
    if (at_boundary) CHECK(choice.refusal == EditRefusal::touches_boundary);
  }
  const AtomicName flip = *parse_atomic_name("generate-3355 flip left");
  CHECK(plan(on_grid, {flip, HalfEdgeId(1000)}).refusal == Refusal::dead_element);
  CHECK(plan(on_grid, {flip, HalfEdgeId()}).refusal == Refusal::dead_element);
  const HalfEdgeId middle = grid.mesh.find_half_edge(inner, VertexId(6));
  REQUIRE(middle.valid());
  CHECK(plan(on_grid, {flip, middle}).refusal == EditRefusal::touches_boundary);

  // The vertices do not have the valences that the name requires.
  Region region = neighbourhood(3);
  QuadMesh& m = region.mesh;
  const QuadMesh before = m;
  Editor editor(m);
  const VertexId v = vertex_of(m, 3);
  const HalfEdgeId along = m.out(v);
  CHECK(plan(editor, {*parse_atomic_name("move-v5 flip left"), along}).refusal == EditRefusal::wrong_valences);
  CHECK(plan(editor, {*parse_atomic_name("generate-3355 flip left"), along}).refusal == EditRefusal::wrong_valences);
  CHECK(plan(editor, {*parse_atomic_name("lower split left 3"), along}).refusal == EditRefusal::wrong_valences);
  CHECK(plan(editor, {*parse_atomic_name("lower split left 2"), along}).refusal == Refusal::none);
  CHECK(plan(editor, {{AtomicKind::move_v3, {TransportStep::Kind::split, Hand::left}, 0}, along}).refusal ==
        EditRefusal::no_such_step);
  // With a v3 at the far corner of a face, a v3 cannot become a v5 there.
  REQUIRE(perform(editor, {*parse_atomic_name("move-v3 flip left"), along}).refusal == Refusal::none);
  const HalfEdgeId back = m.find_half_edge(before.target(along), v);
  REQUIRE(back.valid());
  bool in_the_way = false;
  for (const AtomicChoice& choice : atomic_operations(editor, m.origin(back)))
    in_the_way = in_the_way || choice.refusal == EditRefusal::irregular_in_the_way;
  CHECK(in_the_way);
  editor.roll_back();
  CHECK(m == before);
}

TEST_CASE("atomic operations keep features, or say that they cannot", "[atomic]") {
  Region region = neighbourhood(3);
  QuadMesh& m = region.mesh;
  const VertexId v = vertex_of(m, 3);
  const HalfEdgeId along = m.out(v);
  const VertexId w = m.target(along);
  const VertexId c = m.target(m.next(along));
  const auto refusal_of = [&](const FeatureSet& features, const std::string& name) {
    const Editor editor(m, &features);
    return plan(editor, {*parse_atomic_name(name), along}).refusal;
  };
  // The flip on the left turns the edge w - c; on the right it does not.
  FeatureSet opposite;
  opposite.insert(w, c);
  CHECK(refusal_of(opposite, "move-v3 flip left") == FeatureRefusal::breaks_feature);
  CHECK(refusal_of(opposite, "move-v3 flip right") == Refusal::none);
  // A collapse removes v, or c if v is on a feature, or neither if both are.
  FeatureSet own;
  own.insert(v, w);
  CHECK(refusal_of(own, "move-v3 collapse left") == FeatureRefusal::breaks_feature);
  FeatureSet both = own;
  both.insert(w, c);
  for (const FeatureSet& features : {own, both}) {
    QuadMesh copy = m;
    Editor editor(copy, &features);
    int collapses = 0;
    for (const AtomicChoice& choice : atomic_operations(editor, along)) {
      if (to_string(choice.operation.name) != "move-v3 collapse left") continue;
      ++collapses;
      CHECK(choice.operation.swapped == (features.size() == 1));
      REQUIRE(choice.refusal == (features.size() == 1 ? Refusal::none : FeatureRefusal::breaks_feature));
      const AtomicReport report = perform(editor, choice.operation);
      CHECK(copy.adjacent(v, w));
      if (report.refusal != Refusal::none) continue;
      CHECK_FALSE(copy.is_live(c));
      CHECK(perform(editor, report.inverse).refusal == Refusal::none);
      CHECK(copy == m);
    }
    CHECK(collapses == 1);
  }
}

TEST_CASE("requad-edit atomic lists, makes and refuses", "[atomic][programs]") {
  using nlohmann::json;
  const Region region = neighbourhood(3);
  tests::spill(tests::scratch() / "v3.obj", obj_text(region));
  const VertexId v = vertex_of(region.mesh, 3);
  const VertexId w = region.mesh.target(region.mesh.out(v));
  const std::string at = "atomic v3.obj " + std::to_string(v.index() + 1);
  const std::string outer = std::to_string(region.mesh.origin(region.root).index() + 1);
  const std::string along = at + " " + std::to_string(w.index() + 1);

  const tests::Outcome listed = tests::call("edit", at + " --json -");
  REQUIRE(listed.code == 0);
  const json operations = json::parse(listed.out)["operations"];
  CHECK(operations.size() == 12 + 3);
  std::set<std::string> names;
  for (const json& operation : operations) {
    names.insert(operation["operation"]);
    CHECK(operation["from"] == v.index() + 1);
    CHECK(operation["legal"] == true);
    CHECK(parse_atomic_name(operation["inverse"].get<std::string>()));
    CHECK(operation["valences"].size() == 4);
  }
  CHECK(names == std::set<std::string>{"move-v3 collapse left", "move-v3 collapse right", "move-v3 flip left",
                                       "move-v3 flip right", "raise collapse left"});
  CHECK(json::parse(tests::call("edit", along + " --json -").out)["operations"].size() == 4 + 2);
  CHECK(tests::call("edit", at).out.find("v3 -> gone") != std::string::npos);

  const tests::Outcome made = tests::call("edit", along + " --make 'move-v3 flip left' -o moved.obj --json -");
  REQUIRE(made.code == 0);
  const json report = json::parse(made.out);
  CHECK(report["inverse"] == "remove-35-v3 flip right");
  CHECK(report["before"]["interior_irregular"] == 1);
  CHECK(report["after"]["interior_irregular"] == 3);
  const std::string valences = tests::call("edit", "info moved.obj").out;
  CHECK(valences.find("v3:2") != std::string::npos);
  CHECK(valences.find("v5:1") != std::string::npos);

  for (const auto& [arguments, code, why] : std::vector<std::tuple<std::string, int, std::string>>{
           {along + " --make 'move-v5 flip left' -o no.obj", 1, "the valences that this needs"},
           {"atomic v3.obj " + outer, 1, "a boundary vertex would change its valence"},
           {at + " --make 'move-v3 flip left' -o no.obj", 2, "along several edges"},
           {at + " --make 'move-35 flip left' -o no.obj", 2, "there is no 'move-35 flip left' here"},
           {along + " --make 'dance' -o no.obj", 2, "no atomic operation"},
           {along + " --make 'move-v3 flip left'", 2, "-o is missing"},
           {at + " " + outer, 2, "no edge joins"},
           {at + " 999999", 2, "there is no vertex 999999"},
           {"atomic v3.obj", 2, "atomic: expected IN V [W]"}}) {
    INFO(arguments);
    const tests::Outcome outcome = tests::call("edit", arguments);
    CHECK(outcome.code == code);
    CHECK(outcome.err.find(why) != std::string::npos);
    CHECK(tests::line_count(outcome.err) == 1);
  }
  CHECK_FALSE(std::filesystem::exists(tests::scratch() / "no.obj"));
}
