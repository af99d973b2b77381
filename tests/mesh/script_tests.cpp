// Edit scripts: random ones on every real mesh, written, replayed and undone to the last bit; maps of elements against
// bookkeeping by hand; what is refused; requad-edit apply from outside.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "mesh/editing/affected_region.hpp"
#include "mesh/editing/element_map.hpp"
#include "mesh/editing/script.hpp"
#include "mesh/files/feature_edges.hpp"
#include "mesh/files/read_polygons.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/support.hpp"

using namespace requad;
using namespace requad::mesh;
using requad::tests::call;
using requad::tests::scratch;
using requad::tests::slurp;
using requad::tests::spill;

namespace {

Surface read_back(const std::string& text) { return to_quad_mesh(parse_obj(text, "read back")); }

bool same_positions(const QuadMesh& m, const Positions& a, const Positions& b) {
  const auto vertices = m.vertices();
  return std::all_of(vertices.begin(), vertices.end(), [&](VertexId v) { return same_bits(a[v.slot()], b[v.slot()]); });
}

// A surface with an editor on a copy of it.
struct Workshop {
  Surface input;
  QuadMesh m;
  Positions positions;
  FeatureSet features;
  Editor editor;

  explicit Workshop(Surface surface)
      : input(std::move(surface)), m(input.mesh), positions(input.positions), editor(m, &features, &positions) {}
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  // Legal operations at random; every twentieth is followed by a vertex that is placed, sometimes at -0, every
  // hundredth by smoothing.
  void edit(int operations, std::mt19937& random) {
    for (int done = 0; done < operations;) {
      if (editor.run(tests::random_operation(m, random)).refusal != Refusal::none) continue;
      ++done;
      const auto live = [&] {
        while (true) {
          const VertexId v(static_cast<int>(random() % static_cast<unsigned>(m.vertex_capacity())));
          if (m.is_live(v)) return v;
        }
      };
      if (done % 20 == 0) {
        const VertexId v = live();
        if (!editor.is_fixed(v)) editor.place(v, {positions[v.slot()].x() / 3, -0.0, positions[v.slot()].y()});
      }
      if (done % 100 == 0) {
        const std::array some{live(), live(), live()};
        editor.smooth(some, {});
      }
    }
  }
  Script record() const { return record_script(input.mesh, input.positions, editor); }
};

// A torus that is a little crooked, and no symmetry to it.
Surface crooked_torus(int columns, int rows) {
  std::mt19937 random(7);
  const QuadMesh m = tests::torus(columns, rows);
  return read_back(obj_text(m, tests::random_positions(m, random)));
}

// What is said of a script that is parsed, and replayed on a copy of the surface; "" if nothing is.
std::string complaint(const Surface& surface, const std::string& text) {
  Workshop again(surface);
  const auto untouched = [&] {
    CHECK(again.m == surface.mesh);
    CHECK(same_positions(again.m, again.positions, surface.positions));
    CHECK(again.editor.edits().empty());
  };
  try {
    const Replay result = replay(again.editor, parse_script(text, "script"));
    CHECK(result.refusal == Refusal::none);
  } catch (const FileError& error) {
    untouched();
    const std::string message = error.what();
    CHECK(message.find('\n') == std::string::npos);
    REQUIRE(message.rfind("script:", 0) == 0);
    return message.substr(7);
  }
  return "";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

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

TEST_CASE("A map follows elements through ids that are used again", "[script]") {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    Workshop w(crooked_torus(5, 4));
    // By hand: after each operation an id that is no longer, or newly, live has lost its element.
    std::vector<int> vertex(20), face(20);
    for (int i = 0; i < 20; ++i) vertex[static_cast<std::size_t>(i)] = face[static_cast<std::size_t>(i)] = i;
    // What each id goes back to: a vertex to the one it was split off, a face to the one it was opened beside.
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

    // Undoing from the file maps back what there is to map, and nothing else.
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

TEST_CASE("Law editing-14: scripts that are refused, and where", "[script]") {
  const Surface surface = crooked_torus(4, 4);
  Workshop w(surface);
  // A split, which makes vertex 16 and face 16, a vertex that moves, a collapse that removes vertex 0 or another, a
  // flip.
  const VertexId v = surface.mesh.origin(HalfEdgeId(0));
  REQUIRE(
      w.editor.run({BasicOperation::Kind::split, HalfEdgeId(0), QuadMesh::previous(surface.mesh.ccw(HalfEdgeId(0))), 2})
          .refusal == Refusal::none);
  w.editor.place(VertexId(5), {1, 2, -0.0});
  REQUIRE(w.editor.run({BasicOperation::Kind::collapse, HalfEdgeId(40), {}, 0}).refusal == Refusal::none);
  REQUIRE(w.editor.run({BasicOperation::Kind::flip_ccw, HalfEdgeId(25), {}, 0}).refusal == Refusal::none);
  const std::string good = to_string(w.record());
  REQUIRE(complaint(surface, good).empty());
  const std::vector<std::string> lines = lines_of(good);
  REQUIRE(lines.size() == 9);  // two before; split, place of v; place; collapse, place; flip; end
  CHECK(lines[2].rfind("split 0 ", 0) == 0);
  CHECK(lines[3].rfind("place " + std::to_string(v.index()) + " ", 0) == 0);
  CHECK(lines[4].rfind("place 5 1 2 -0 from ", 0) == 0);
  CHECK(lines[5].rfind("collapse 40 removes ", 0) == 0);
  CHECK(lines[7] == "flip_ccw 25");

  // What does not count.
  std::string other = "\xEF\xBB\xBF# one\r\n\r\n";
  for (const std::string& line : lines) other += line + "  # why\r\n\r\n";
  CHECK(complaint(surface, other).empty());

  const auto after = [&](const std::string& what, const std::string& by) {
    return complaint(surface, replaced(good, what, by));
  };
  const std::string mesh_line = lines[1], end_line = lines[8];
  CHECK(complaint(surface, "") == "1: nothing where requad-script is expected");
  CHECK(complaint(surface, "# only this\n") == "2: nothing where requad-script is expected");
  CHECK(after("requad-script", "OFF") == "1: 'OFF' where 'requad-script' is expected");
  CHECK(after("requad-script 1", "requad-script") == "1: the line ends where the version is expected");
  CHECK(after("requad-script 1", "requad-script 2") == "1: version 2; expected 1");
  CHECK(after("requad-script 1", "requad-script 1 2") == "1: '2' where the line must end");
  CHECK(after(mesh_line + "\n", "") == "2: 'split' where 'mesh' is expected");
  CHECK(after("mesh 16", "mesh -1") == "2: the number of vertices: -1 is not in 0..268435454");
  CHECK(after("mesh 16 16", "mesh 16 99999999999") == "2: the number of faces: 99999999999 is not in 0..268435454");
  CHECK(after("mesh 16 16", "mesh 16 99999999999999999999") == "2: '99999999999999999999' is too large");
  CHECK(after(mesh_line, "mesh 16 16 123") == "2: '123' is not a fingerprint of 16 hexadecimal digits");
  CHECK(after(mesh_line, "mesh 16 16 -123456789abcdef") ==
        "2: '-123456789abcdef' is not a fingerprint of 16 hexadecimal digits");
  CHECK(after("flip_ccw 25", "flip 25") == "8: 'flip' does not start a line of a script");
  CHECK(after("flip_ccw 25", "flip_ccw") == "8: the line ends where a half-edge is expected");
  CHECK(after("flip_ccw 25", "flip_ccw x") == "8: 'x' is not an integer");
  CHECK(after("flip_ccw 25", "flip_ccw 25 26") == "8: '26' where the line must end");
  CHECK(after("flip_ccw 25", "flip_ccw -1") == "8: a half-edge: -1 is not in 0..67");
  CHECK(after("flip_ccw 25", "flip_ccw 68") == "8: a half-edge: 68 is not in 0..67");
  CHECK(after("flip_ccw 25", "flip_ccw 2000000000") == "8: a half-edge: 2000000000 is not in 0..67");
  CHECK(after("flip_ccw 25", "flip_ccw 41") == "8: no such element");  // of the face that collapsed
  CHECK(after("place 5", "place 17") == "5: a vertex: 17 is not in 0..16");
  CHECK(after("place 5 1", "place 5 nan") == "5: 'nan' is not a finite number");
  CHECK(after("place 5 1", "place 5 inf") == "5: 'inf' is not a finite number");
  CHECK(after("place 5 1", "place 5 1e400") == "5: '1e400' is not a finite number");
  CHECK(after("place 5 1", "place 5 1e71") == "5: a coordinate is larger than 1e70");
  CHECK(after("place 5 1", "place 5 1,5") == "5: '1,5' is not a number");
  CHECK(after("place 5 1 2 -0 from", "place 5 1 2 from") == "5: 'from' is not a number");
  CHECK(after("place 5 1 2 -0 from", "place 5 1 2 -0 to") == "5: 'to' where 'from' is expected");
  CHECK(after("place 5 1 2 -0 from", "place 6 1 2 -0 from") == "5: vertex 6 is not where the script says");
  CHECK(after("removes", "makes") == "6: 'makes' where 'removes' is expected");
  CHECK(after("collapse 40 removes", "collapse 41 removes").rfind("6: the corner is 1 here, not 0", 0) == 0);
  CHECK(after("collapse 40 removes", "collapse 44 removes").rfind("6: the collapse does not remove vertex ", 0) == 0);
  CHECK(after("makes 16", "makes 17") == "3: the new vertex is 16 here, not 17");
  CHECK(after("makes 16", "makes 15") == "3: the new vertex is 16 here, not 15");
  CHECK(after("undo collapse 66", "undo collapse 70") == "3: the new half-edge is 66 here, not 70");
  CHECK(after(" undo collapse 66", "") == "3: the line ends where 'undo' is expected");
  const std::string no_fan =
      complaint(surface, replaced(good, lines[2].substr(0, lines[2].find(" makes")), "split 0 1 2"));
  CHECK(no_fan == "3: the two edges do not bound a sector of one vertex");

  const BasicOperation undo = w.editor.edits()[2].inverse;
  BasicOperation wrong = undo;
  std::swap(wrong.h, wrong.last);
  CHECK(after(to_string(undo), to_string(wrong)) == "6: the operation is undone by " + to_string(undo));

  // Cut short at any place, from the last line's end on.
  for (std::size_t length = 0; length + 1 < good.size(); ++length) {
    INFO("the first " << length << " characters");
    CHECK_FALSE(complaint(surface, good.substr(0, length)).empty());
  }
  CHECK(complaint(surface, good.substr(0, good.find("end "))) == "9: the script ends where 'end' is expected");
  CHECK(complaint(surface, good + "flip_ccw 25\n") == "10: more text after the end");
  CHECK(after("flip_ccw 25\n", "") == " the script does not lead to the mesh that it says");
  CHECK(after(end_line, "end 17 16 0123456789abcdef") ==
        "9: the lines before lead to 16 vertices and 16 faces; expected what they lead to");
  CHECK(after(end_line, "end 16 16 0123456789abcdef") == " the script does not lead to the mesh that it says");

  // Another mesh: other sizes, other positions, the faces in another order; and a result that is none.
  CHECK(complaint(crooked_torus(5, 4), good) ==
        " the script belongs to another mesh, of 16 vertices and 16 faces; this one has 20 vertices and 20 faces");
  Surface moved = surface;
  moved.positions[3].z() = -moved.positions[3].z();
  const std::string as_many = " the script belongs to another mesh, with as many vertices and faces as this one";
  CHECK(complaint(moved, good) == as_many);
  std::vector<std::array<int, 4>> faces = surface.mesh.compact_faces();
  std::swap(faces[1], faces[2]);
  Surface other_order = surface;
  other_order.mesh = QuadMesh::from_faces(16, faces);
  CHECK(complaint(other_order, good) == as_many);
  const Surface made = read_back(obj_text(w.m, w.positions));
  const std::string other_end = " this mesh is the other end of the script, done or undone already";
  CHECK(complaint(made, good) == other_end);
  Surface no_result = surface;
  CHECK_THROWS_WITH(restore_ids(parse_script(good, "script"), no_result), "script:" + other_end);
  no_result = moved;
  CHECK_THROWS_WITH(restore_ids(parse_script(good, "script"), no_result), "script:" + as_many);
  CHECK(no_result.mesh == surface.mesh);
  // Without the ids that it had, the result is not what the inverse goes on from.
  Workshop compact(made);
  CHECK_THROWS_AS(replay(compact.editor, inverse(parse_script(good, "script"))), FileError);
  CHECK(compact.m == made.mesh);

  // A face collapses twice, and a split makes it again: the numbers agree, the mesh does not.
  Script twice = parse_script(good, "script");
  twice.changes[3].vertex = twice.changes[0].vertex;
  Surface result = made;
  twice.changes.push_back(twice.changes[3]);
  CHECK_THROWS_AS(restore_ids(twice, result), FileError);
}

TEST_CASE("Law editing-14: free ids in another order are another mesh to a script", "[script]") {
  Workshop w(crooked_torus(4, 4));
  for (const int h : {4 * 5 + 1, 4 * 2})
    REQUIRE(w.editor.run({BasicOperation::Kind::collapse, HalfEdgeId(h), {}, 0}).refusal == Refusal::none);
  const VertexId first = w.editor.edits()[0].removed_vertex(), second = w.editor.edits()[1].removed_vertex();
  const QuadMesh compact = QuadMesh::from_faces(14, w.m.compact_faces());
  for (const bool in_order : {true, false}) {
    Surface result = w.input;
    result.mesh = compact.with_free_ids({FaceId(5), FaceId(2)}, {in_order ? first : second, in_order ? second : first});
    result.positions = w.positions;
    Workshop back(result);
    if (in_order) {
      CHECK(replay(back.editor, inverse(w.record())).refusal == Refusal::none);
      CHECK(back.m == w.input.mesh);
    } else {
      CHECK_THROWS_WITH(replay(back.editor, inverse(w.record())),
                        ":0: the split does not make vertex " + std::to_string(second.index()));
      CHECK(back.m == result.mesh);
    }
  }
}

TEST_CASE("Law editing-14: a broken script changes nothing, however it is broken", "[script]") {
  const Surface surface = crooked_torus(4, 5);
  std::mt19937 random(5);
  Workshop w(surface);
  w.edit(60, random);
  const std::string good = to_string(w.record());
  const Surface result = read_back(obj_text(w.m, w.positions));
  const std::string letters = "0123456789-. \nemsplitcollapse#\\";
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string bad = good;
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t at = random() % bad.size();
      switch (random() % 4) {
        case 0: bad[at] = letters[random() % letters.size()]; break;
        case 1: bad.erase(at, 1 + random() % 8); break;
        case 2: bad.insert(at, bad.substr(random() % bad.size(), random() % 40)); break;
        default: bad[at] = static_cast<char>(random() % 256); break;
      }
    }
    INFO("round " << round);
    refused += complaint(surface, bad).empty() ? 0 : 1;
    try {
      const Script script = parse_script(bad, "script");
      Surface output = result;
      restore_ids(script, output);
      Workshop back(output);
      const Replay undone = replay(back.editor, inverse(script));
      CHECK(undone.refusal == Refusal::none);
      CHECK(back.m == surface.mesh);
      CHECK(same_positions(surface.mesh, back.positions, surface.positions));
    } catch (const FileError&) {
    }
  }
  CHECK(refused > 2000);
}

TEST_CASE("Features and boundaries stand against a script", "[script]") {
  const Region region = tests::grid(4, 4);
  Positions positions;
  for (int v = 0; v < 25; ++v) positions.push_back({v / 5 * 1.0, v % 5 * 1.0, 0});
  const Surface surface = read_back(obj_text(region.mesh, positions));
  Workshop w(surface);
  const VertexId a(12), b(13);
  w.editor.place(VertexId(6), {1, 1, 0.25});
  w.editor.place(b, {2, 3, 0.5});
  const HalfEdgeId h = surface.mesh.find_half_edge(a, b);
  REQUIRE(w.editor.run({BasicOperation::Kind::flip_cw, h, {}, 0}).refusal == Refusal::none);
  const Script script = parse_script(to_string(w.record()), "script");
  for (const bool edge : {false, true}) {
    Workshop again(surface);
    again.features.insert(edge ? a : b, edge ? VertexId(11) : VertexId(14));
    if (edge) again.features.insert(a, VertexId(7));
    const Replay result = replay(again.editor, script);
    // The flip leaves a's other edges; that b is on a feature keeps it where it is.
    CHECK(result.refusal == (edge ? Refusal::none : FeatureRefusal::moves_feature));
    CHECK(result.line == (edge ? 0 : 4));
    CHECK((again.m == surface.mesh) == !edge);
    CHECK(same_positions(surface.mesh, again.positions, surface.positions) == !edge);
    CHECK(again.editor.edits().empty() == !edge);
  }
  Workshop flip_only(surface);
  flip_only.editor.run({BasicOperation::Kind::flip_cw, h, {}, 0});
  Workshop again(surface);
  again.features.insert(a, b);
  const Replay result = replay(again.editor, parse_script(to_string(flip_only.record()), "script"));
  CHECK(result.refusal == FeatureRefusal::breaks_feature);
  CHECK(result.line == 3);
  CHECK(again.m == surface.mesh);

  const std::string text = to_string(script);
  CHECK(complaint(surface, replaced(text, "place 13", "place 0")) == "4: vertex 0 lies on the boundary");
}

TEST_CASE("requad-edit apply: replays, undoes, maps", "[programs][script]") {
  using nlohmann::json;
  std::mt19937 random(3);
  Workshop w(crooked_torus(6, 5));
  w.edit(300, random);
  const std::string in = obj_text(w.input.mesh, w.input.positions), out = obj_text(w.m, w.positions);
  // An unused vertex in front, which is dropped, so that vertices of the file and of the mesh are not the same.
  const auto shifted = [](const std::string& text) {
    std::string result = "v 9 9 9\n";
    for (const std::string& line : lines_of(text)) {
      if (line[0] == 'v') result += line + '\n';
      if (line[0] != 'f') continue;
      std::istringstream words(line.substr(1));
      result += 'f';
      for (int corner = 0; words >> corner;) result += ' ' + std::to_string(corner + 1);
      result += '\n';
    }
    return result;
  };
  const std::string script = to_string(w.record());
  const auto remove_all = [] {
    for (const char* name : {"made.obj", "map.json"}) std::filesystem::remove(scratch() / name);
  };
  const auto none_written = [] {
    return !std::filesystem::exists(scratch() / "made.obj") && !std::filesystem::exists(scratch() / "map.json");
  };
  spill(scratch() / "in.obj", in);
  spill(scratch() / "shifted.obj", shifted(in));
  spill(scratch() / "edits.txt", script);

  REQUIRE(call("edit", "apply in.obj edits.txt -o made.obj --map map.json").code == 0);
  CHECK(slurp(scratch() / "made.obj") == out);
  const json map = json::parse(slurp(scratch() / "map.json"));
  const ElementMap expected = element_map(w.input.mesh, w.editor);
  const auto check_map = [](const json& of, const std::string& kind, const FileIndexMap& indices, std::size_t unused) {
    const json &numbers = of[kind], &made = of["new_" + kind], &from = of["new_" + kind + "_from"];
    REQUIRE(numbers.size() == indices.now.size() + unused);
    for (std::size_t i = 0; i < indices.now.size(); ++i)
      CHECK(numbers[i + unused] == (indices.now[i] < 0 ? json() : json(indices.now[i] + 1)));
    for (std::size_t i = 0; i < unused; ++i) CHECK(numbers[i].is_null());
    REQUIRE(made.size() == indices.made.size());
    for (std::size_t i = 0; i < made.size(); ++i) CHECK(made[i] == indices.made[i] + 1);
    REQUIRE(from.size() == made.size());
    for (std::size_t i = 0; i < from.size(); ++i)
      CHECK(from[i] == static_cast<std::size_t>(indices.made_from[i]) + 1 + unused);
  };
  check_map(map, "vertices", expected.vertices, 0);
  check_map(map, "faces", expected.faces, 0);
  CHECK(call("edit", "apply shifted.obj edits.txt -o - --map map.json").out == out);
  const json of_shifted = json::parse(slurp(scratch() / "map.json"));
  check_map(of_shifted, "vertices", expected.vertices, 1);

  CHECK(call("edit", "apply made.obj edits.txt --undo -o back.obj --map map.json").code == 0);
  json undone = json::parse(slurp(scratch() / "map.json"));
  CHECK(slurp(scratch() / "back.obj") == in);
  spill(scratch() / "shifted.obj", shifted(out));
  CHECK(call("edit", "apply shifted.obj edits.txt --undo -o - --map map.json").out == in);
  undone["vertices"].insert(undone["vertices"].begin(), json());
  for (json& from : undone["new_vertices_from"]) from = from.get<int>() + 1;
  CHECK(json::parse(slurp(scratch() / "map.json")) == undone);

  // Bad input: exit 2, one line, nothing written.
  remove_all();
  spill(scratch() / "short.txt", script.substr(0, script.size() / 2));
  spill(scratch() / "broken.txt", replaced(script, "flip_ccw ", "flip_up "));
  spill(scratch() / "beyond.txt", replaced(script, "flip_cw ", "flip_cw 99999"));
  spill(scratch() / "cube.obj",
        "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  for (const std::string arguments :
       {"apply", "apply in.obj -o made.obj", "apply in.obj edits.txt", "apply in.obj missing.txt -o made.obj",
        "apply in.obj short.txt -o made.obj --map map.json", "apply in.obj broken.txt -o made.obj --map map.json",
        "apply in.obj beyond.txt -o made.obj --map map.json", "apply in.obj in.obj -o made.obj",
        "apply cube.obj edits.txt -o made.obj --map map.json",
        "apply in.obj edits.txt --undo -o made.obj --map map.json", "apply in.obj edits.txt -o - --map -",
        "apply in.obj edits.txt -o made.obj --script x.txt", "apply in.obj edits.txt -o made.obj --smooth 3",
        "apply in.obj edits.txt edits.txt -o made.obj", "apply in.obj edits.txt -o made.off"}) {
    INFO(arguments);
    const auto outcome = call("edit", arguments);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(tests::line_count(outcome.err) == 1);
    CHECK(none_written());
  }
  CHECK(call("edit", "apply in.obj beyond.txt -o made.obj").err.rfind("requad-edit: beyond.txt:", 0) == 0);

  // Features that the script does not know: exit 1, with its line.
  std::string edges;
  for (const HalfEdgeId h : w.input.mesh.half_edges()) {
    edges += std::to_string(w.input.mesh.origin(h).index() + 1) + " " +
             std::to_string(w.input.mesh.target(h).index() + 1) + "\n";
  }
  spill(scratch() / "all-edges.txt", edges);
  const auto held = call("edit", "apply in.obj edits.txt --features all-edges.txt -o made.obj --map map.json");
  CHECK(held.code == 1);
  CHECK(held.err.rfind("requad-edit: apply: edits.txt:", 0) == 0);
  CHECK(held.err.find(": a ") != std::string::npos);
  CHECK(tests::line_count(held.err) == 1);
  CHECK(none_written());
}

TEST_CASE("requad-edit --script: what editing commands write can be applied and undone", "[programs][script][real]") {
  using nlohmann::json;
  const auto path = tests::real_mesh("spot");
  if (!path) return;
  const Surface input = read_surface(*path, false);
  const std::string in = obj_text(input.mesh, input.positions);
  std::map<int, int> number;
  for (const VertexId v : input.mesh.vertices()) number.emplace(input.mesh.valence(v), input.file_vertex[v.slot()] + 1);
  const std::string pair = " " + std::to_string(number.at(3)) + " " + std::to_string(number.at(5));
  for (const std::string& command : {"cancel " + *path + pair, "part " + *path, "reduce " + *path + " --until 60",
                                     "smooth " + *path + " --iterations 2"}) {
    INFO(command);
    const bool smooths = command.rfind("smooth", 0) == 0;
    const auto made = call("edit", command + " -o made.obj --script edits.txt" + (smooths ? "" : " --map map.json"));
    REQUIRE(made.code == 0);
    REQUIRE(call("edit", "apply " + *path + " edits.txt -o again.obj --map again.json").code == 0);
    CHECK(slurp(scratch() / "again.obj") == slurp(scratch() / "made.obj"));
    if (!smooths) CHECK(slurp(scratch() / "again.json") == slurp(scratch() / "map.json"));
    REQUIRE(call("edit", "apply made.obj edits.txt --undo -o back.obj --map back.json").code == 0);
    CHECK(slurp(scratch() / "back.obj") == in);
    // There and back is the identity where it leads anywhere.
    const json there = json::parse(slurp(scratch() / "again.json")), back = json::parse(slurp(scratch() / "back.json"));
    for (const char* kind : {"vertices", "faces"}) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < there[kind].size(); ++i) {
        if (there[kind][i].is_null()) continue;
        ++kept;
        CHECK(back[kind][there[kind][i].get<std::size_t>() - 1] == i + 1);
      }
      CHECK(kept + there[std::string("new_") + kind].size() == back[kind].size());
      CHECK(kept + back[std::string("new_") + kind].size() == there[kind].size());
    }
  }
  // The script on standard output takes the place of the report.
  const std::string cancel = "cancel " + *path + pair + " -o made.obj";
  const auto shown = call("edit", cancel + " --script -");
  CHECK(shown.code == 0);
  CHECK(parse_script(shown.out, "stdout").before == digest(input.mesh, input.positions));
  CHECK(call("edit", cancel + " --script - --map -").code == 2);
  CHECK(call("edit", "moves " + *path + pair + " --script x.txt").code == 2);
}
