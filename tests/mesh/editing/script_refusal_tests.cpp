// Edit scripts that are refused. The message names the place and the reason, and nothing is changed.
#include <algorithm>
#include <random>

#include "mesh/editing/script.hpp"
#include "mesh/files/write_obj.hpp"
#include "tests/mesh/editing/workshop.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"

using namespace requad;
using namespace requad::mesh;
using requad::tests::crooked_torus;
using requad::tests::lines_of;
using requad::tests::read_back;
using requad::tests::replaced;
using requad::tests::same_positions;
using requad::tests::Workshop;

namespace {

// Parses a script and replays it on a copy of the surface. Returns the message of a refusal; "" if there is none.
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

}  // namespace

TEST_CASE("Law editing-14: scripts that are refused, and where", "[script]") {
  const Surface surface = crooked_torus(4, 4);
  Workshop w(surface);
  // The script has a split, which makes vertex 16 and face 16; a vertex that moves; a collapse, which removes a vertex;
  // and a flip.
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
  REQUIRE(lines.size() == 9);  // two for the head; split, place; place; collapse, place; flip; end
  CHECK(lines[2].rfind("split 0 ", 0) == 0);
  CHECK(lines[3].rfind("place " + std::to_string(v.index()) + " ", 0) == 0);
  CHECK(lines[4].rfind("place 5 1 2 -0 from ", 0) == 0);
  CHECK(lines[5].rfind("collapse 40 removes ", 0) == 0);
  CHECK(lines[7] == "flip_ccw 25");

  // Comments, blank lines and line ends do not count.
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

  // A script that is cut short at any place before the end of its last line is refused.
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

  // Another mesh is refused: other sizes, other positions, or another order of the faces. So is a result that is not
  // the script's.
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
  // The inverse refuses the result unless it has its earlier ids.
  Workshop compact(made);
  CHECK_THROWS_AS(replay(compact.editor, inverse(parse_script(good, "script"))), FileError);
  CHECK(compact.m == made.mesh);

  // A face collapses twice, and a split makes it again. The numbers agree with the mesh, but the mesh does not.
  Script twice = parse_script(good, "script");
  twice.changes[3].vertex = twice.changes[0].vertex;
  Surface result = made;
  twice.changes.push_back(twice.changes[3]);
  CHECK_THROWS_AS(restore_ids(twice, result), FileError);
}

TEST_CASE("Law editing-14: a mesh whose free ids have another order is refused", "[script]") {
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

TEST_CASE("a script that would change features or boundaries is refused", "[script]") {
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
    // The flip keeps the other edges of a. Vertex b stays in its place, since it is on a feature.
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
