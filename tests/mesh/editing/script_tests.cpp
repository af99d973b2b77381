// Edit scripts: random scripts on every real mesh are written, replayed and undone to the last bit. Maps of elements
// are compared with records that the test keeps by itself.
#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "mesh/editing/element_map.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/files/feature_edges.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/mesh/editing/workshop.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;
using requad::tests::crooked_torus;
using requad::tests::read_back;
using requad::tests::same_positions;
using requad::tests::Workshop;

TEST_CASE(
    "Laws editing-11 to editing-13: 10,000 random operations on each real mesh, replayed and undone to the last bit",
    "[script][real]") {
  struct Case {
    const char* name;
    double feature_angle;  // 0: no features
  };
  for (const auto& [name, angle] : {Case{"spot", 0},
                                    {"fandisk_bommes", 40},
                                    {"hole_capsule", 0},
                                    {"gargoyle_quadriflow", 0},
                                    {"armadillo_gel", 60},
                                    {"bigguy", 0},
                                    {"blub", 0},
                                    {"bob", 0},
                                    {"bunny_qex", 0},
                                    {"botijo_miq", 50},
                                    {"anet_complete01", 0},
                                    {"pawn", 40},
                                    {"tri_bunny", 30},
                                    {"tri_spot", 0}}) {
    INFO(name);
    const auto path = tests::real_mesh(name);
    if (!path) continue;
    Workshop made(read_surface(*path, std::string(name).rfind("tri_", 0) == 0));
    const Surface& input = made.input;
    if (angle > 0) {
      for (const auto& [a, b] : sharp_edges(input.mesh, input.positions, angle)) made.features.insert(a, b);
      REQUIRE(made.features.size() > 0);
    }
    std::mt19937 random(20111);
    made.edit(10'000, random);
    REQUIRE(validate(made.m).empty());

    // editing-11
    const std::string text = to_string(made.record());
    const Script script = parse_script(text, name);
    CHECK(to_string(script) == text);
    std::map<BasicOperation::Kind, int> kinds;
    for (const Change& c : script.changes) {
      if (c.operation) ++kinds[c.operation->kind];
    }
    CHECK(kinds.size() == 4);

    // editing-12
    Workshop again(input);
    again.features = made.features;
    REQUIRE(replay(again.editor, script).refusal == Refusal::none);
    CHECK(again.m == made.m);
    CHECK(same_positions(made.m, again.positions, made.positions));
    CHECK(to_string(again.record()) == text);

    // editing-13, from memory
    REQUIRE(replay(again.editor, inverse(script)).refusal == Refusal::none);
    CHECK(again.m == input.mesh);
    CHECK(same_positions(input.mesh, again.positions, input.positions));

    // editing-13, from the file
    Surface output = read_back(obj_text(made.m, made.positions));
    restore_ids(script, output);
    CHECK(validate(output.mesh).empty());
    CHECK(output.mesh == made.m);
    CHECK(same_positions(made.m, output.positions, made.positions));
    Workshop back(output);
    back.features = made.features;
    REQUIRE(replay(back.editor, inverse(script)).refusal == Refusal::none);
    CHECK(back.m == input.mesh);
    CHECK(same_positions(input.mesh, back.positions, input.positions));
    CHECK(obj_text(back.m, back.positions) == obj_text(input.mesh, input.positions));
  }
}

TEST_CASE("a map follows elements through ids that are used again", "[script]") {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    Workshop w(crooked_torus(5, 4));
    // The test's record: if an operation removes or makes an id, the id loses its earlier element.
    std::vector<int> vertex(20), face(20);
    for (int i = 0; i < 20; ++i) vertex[static_cast<std::size_t>(i)] = face[static_cast<std::size_t>(i)] = i;
    // The origin of each id: for a vertex, the one that it was split off; for a face, the one beside which it opened.
    std::map<int, int> vertex_from, face_from;
    for (int i = 0; i < 20; ++i) vertex_from[i] = face_from[i] = i;
    int reused = 0;
    for (int i = 0; i < 400; ++i) {
      const QuadMesh before = w.m;
      const BasicOperation operation = tests::random_operation(w.m, random);
      if (w.editor.run(operation).refusal != Refusal::none) continue;
      for (const VertexId v : w.m.vertices()) {
        if (!before.is_live(v)) vertex_from[v.index()] = vertex_from.at(before.origin(operation.h).index());
      }
      for (const FaceId f : w.m.faces()) {
        if (!before.is_live(f)) face_from[f.index()] = face_from.at(QuadMesh::face(operation.h).index());
      }
      for (int id = 0; id < 20; ++id) {
        if (before.is_live(VertexId(id)) != w.m.is_live(VertexId(id))) {
          reused += w.m.is_live(VertexId(id)) ? 1 : 0;
          vertex[static_cast<std::size_t>(id)] = -1;
        }
        if (before.is_live(FaceId(id)) != w.m.is_live(FaceId(id))) face[static_cast<std::size_t>(id)] = -1;
      }
    }
    REQUIRE(reused > 0);
    const ElementMap map = element_map(w.input.mesh, w.editor);
    const auto check = [](const FileIndexMap& indices, const std::vector<int>& kept, const auto& live,
                          const std::map<int, int>& from) {
      REQUIRE(indices.now.size() == kept.size());
      REQUIRE(indices.made_from.size() == indices.made.size());
      for (std::size_t i = 0; i < indices.made.size(); ++i)
        CHECK(indices.made_from[i] == from.at(live[static_cast<std::size_t>(indices.made[i])].index()));
      std::set<int> all(indices.made.begin(), indices.made.end());
      for (std::size_t id = 0; id < kept.size(); ++id) {
        CHECK((indices.now[id] < 0) == (kept[id] < 0));
        if (indices.now[id] < 0) continue;
        CHECK(live[static_cast<std::size_t>(indices.now[id])].slot() == id);
        CHECK(all.insert(indices.now[id]).second);
      }
      CHECK(all.size() == live.size());
    };
    check(map.vertices, vertex, w.m.vertices(), vertex_from);
    check(map.faces, face, w.m.faces(), face_from);

    // Undoing from the file maps exactly the remaining elements back.
    const Script script = w.record();
    Surface output = read_back(obj_text(w.m, w.positions));
    restore_ids(script, output);
    Workshop back(output);
    REQUIRE(replay(back.editor, inverse(script)).refusal == Refusal::none);
    const ElementMap undone = element_map(back.input.mesh, back.editor);
    for (std::size_t id = 0; id < 20; ++id) {
      const int index = map.vertices.now[id];
      const auto to = [&](std::size_t slot) {
        return slot < undone.vertices.now.size() ? undone.vertices.now[slot] : -1;
      };
      CHECK(to(id) == (index < 0 ? -1 : static_cast<int>(id)));
    }
    CHECK(undone.vertices.made.size() ==
          static_cast<std::size_t>(std::count(map.vertices.now.begin(), map.vertices.now.end(), -1)));
    CHECK(undone.faces.made.size() ==
          static_cast<std::size_t>(std::count(map.faces.now.begin(), map.faces.now.end(), -1)));
  }
}
