// Files: what is read, and what is refused. A refusal names the line and the reason.
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "mesh/files/read_polygons.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/files/welding.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/mesh/files/file_texts.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;
using namespace requad::tests;

namespace {

std::string of_obj(const std::string& text) { return complaint(parse_obj, text); }
std::string of_off(const std::string& text) { return complaint(parse_off, text); }
// The message by which a text is refused on its way to a quad mesh; "" if there is none.
std::string of_quads(const std::string& text) {
  return complaint([](const std::string& t, const std::string& name) { to_quad_mesh(parse_obj(t, name)); }, text);
}

std::vector<std::vector<int>> faces_of(const PolygonMesh& m) {
  std::vector<std::vector<int>> faces;
  for (std::size_t f = 0; f < m.face_count(); ++f) faces.emplace_back(m.face(f).begin(), m.face(f).end());
  return faces;
}

// An OBJ text: vertices without any geometry, and these faces, counted from 1.
std::string obj(int vertices, const std::vector<std::vector<int>>& faces) {
  std::string text;
  for (int v = 0; v < vertices; ++v) text += "v " + std::to_string(v) + " 0 0\n";
  for (const auto& face : faces) {
    text += "f";
    for (const int v : face) text += " " + std::to_string(v);
    text += "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("OBJ: everything that a file may contain is read (files-1)", "[files]") {
  const std::string text =
      "\xEF\xBB\xBF# a comment\r\n"
      "mtllib some.mtl\r\n"
      "o thing\n"
      "v 0 0 0 # at the end of a line\n"
      "  v\t+1 0e0 -0\n"
      "v 1.5 1 0 1.0\n"       // weight
      "v 0 1 0 0.5 0.25 1\n"  // colour
      "\n"
      "vt 0 0\nvn 0 0 1\ng one two\ns off\nusemtl stone\n"
      "f 1/1/1 2//1 3/7 4\n"  // texture coordinates and normals are not even counted
      "v 2 0 0\rv 2 1 0\r"    // lines that end as on old systems
      "f -5 -2 \\\n -1 -4\n"  // -1 is vertex 6, the last so far
      "l 1 2\n"
      "f 1 2 7";  // a vertex that comes later, and no end of the line
  const PolygonMesh m = parse_obj(text + "\nv 0 0 5\n", "file");
  CHECK(faces_of(m) == std::vector<std::vector<int>>{{0, 1, 2, 3}, {1, 4, 5, 2}, {0, 1, 6}});
  CHECK(m.lines == std::vector<int>{14, 17, 20});
  REQUIRE(m.positions.size() == 7);
  CHECK(m.positions[1] == Eigen::Vector3d(1, 0, 0));
  CHECK(std::signbit(m.positions[1].z()));
  CHECK(m.positions[3] == Eigen::Vector3d(0, 1, 0));
  CHECK(of_obj(text) == "20: vertex 7 does not exist; there are 6, counted from 1");
}

TEST_CASE("OFF: everything that a file may contain is read (files-1)", "[files]") {
  const PolygonMesh m = parse_off(
      "# first\nCOFF\n\n 5 2 0 # counts\n0 0 0 255 0 0 1\n1 0 0\n1 1 0\n0 1 0\n2 2 2\n4 0 1 2 3 0.5 0.5 0.5\r\n\n3 0 3 "
      "4",
      "file");
  CHECK(faces_of(m) == std::vector<std::vector<int>>{{0, 1, 2, 3}, {0, 3, 4}});
  CHECK(m.lines == std::vector<int>{10, 12});
  CHECK(m.first_index == 0);
  CHECK(faces_of(parse_off("OFF 3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "file")).size() == 1);
}

TEST_CASE("OFF: line ends may stand anywhere, and keywords and counts may be incomplete (files-1)", "[files]") {
  const auto off = [](const std::string& text) { return parse_off(text, "file"); };
  const std::vector<std::vector<int>> triangle{{0, 1, 2}}, two{{0, 1, 2}, {2, 1, 3}};
  const std::string v = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  CHECK(faces_of(off("OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2")) == triangle);
  CHECK(faces_of(off("3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")) == triangle);  // no keyword
  CHECK(faces_of(off("OFF\n4 # vertices\n2\n5\n" + v + "3\n0\n1 # here too\n2\n3 2\n1 3")) == two);
  CHECK(faces_of(off("OFF\n4 2 5\n0\n0 0\n1 0 0 0 1 0\n1 1 0\n3 0 1 2\n3 2 1 3\n")) == two);
  CHECK(faces_of(off("OFF\n4 2 5\n" + v + "3 0 1 2 3 2 1 3\n")) == two);  // two faces on a line
  CHECK(faces_of(off("OFF\n4 2 5\n" + v + "3 0 1 2 255 0 0\n3 2 1 3 0.5 0.5 0.5 1\n")) == two);
  CHECK(faces_of(off("OFF\n4 1 5\n0 0 0 1 0 0\n1 0 0 1 0 0\n0 1 0 1 nan 0\n1 1 0 0 1 0\n4 0 1 3 2\n"))[0].size() == 4);
  // Mixtures of colours, normals and texture coordinates, one vertex to a line and in one piece.
  for (const std::string keyword : {"C", "N", "ST", "CN", "STC", "STN", "STCN"}) {
    for (const std::string colour : {" 1 0 0 1", " 255 0 0"}) {
      const auto has = [&keyword](const char* part) { return keyword.find(part) != std::string::npos; };
      const std::string more =
          std::string(has("N") ? " 0 0 1" : "") + (has("C") ? colour : "") + (has("ST") ? " .5 .5" : "");
      for (const std::string end : {"\n", " "}) {
        if (end == " " && has("C") && colour == " 255 0 0") continue;  // three numbers are told by the line alone
        std::string text = keyword + "OFF\n3 1 3\n";
        for (const std::string p : {"0 0 0", "1 0 0", "0 1 0"}) text += p + more + end;
        INFO(text);
        const PolygonMesh m = off(text + "3 0 1 2\n");
        CHECK(faces_of(m) == triangle);
        CHECK(m.positions == Positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        CHECK(m.attributes.not_kept.count("colours of vertices") == (has("C") ? 1 : 0));
      }
    }
  }
}

TEST_CASE("OBJ: old words, tiny numbers and colours that are no numbers are read (files-1)", "[files]") {
  const PolygonMesh m =
      parse_obj("v 1e-400 -1e-330 0.0\nv 1 0 0 nan inf -nan\nv 1 1 0\nv 0 1 1e-310\nfo 1 2 3 4\n", "file");
  CHECK(m.positions[0].isZero(0));
  CHECK(std::signbit(m.positions[0].y()));
  CHECK(m.positions[3].z() == 1e-310);
  CHECK(m.face_count() == 1);
  CHECK(of_obj("v 0 0 1" + std::string(400, '0') + "\n").ends_with("is not a finite number"));
  CHECK(of_obj("v 0 0 0." + std::string(400, '0') + "1\n") == "2: the file ends without a face");
  CHECK(of_obj("v 0 0 0." + std::string(400, '0') + "1e900\n").ends_with("is not a finite number"));
  CHECK(of_obj("v 0 0 1e-99999999999999999999\n") == "2: the file ends without a face");
}

TEST_CASE("files that are no text are refused by name", "[files]") {
  const auto refusal = [](const std::string& name, const std::string& text) -> std::string {
    spill(scratch() / name, text);
    try {
      read_polygon_mesh((scratch() / name).string());
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  };
  using namespace std::string_literals;
  CHECK(refusal("utf16.obj", "\xFF\xFEv\0 \0"s).ends_with("it is UTF-16; expected ASCII or UTF-8"));
  CHECK(refusal("utf16be.obj", "\xFE\xFF\0v\0 "s).ends_with("it is UTF-16; expected ASCII or UTF-8"));
  CHECK(refusal("binary.off", "OFF BINARY\n\0\0\0\4"s).ends_with("it is a binary OFF file; expected the text format"));
  CHECK(refusal("zero.obj", "v 0 0\0 0"s).ends_with("it is no text: a zero byte is in it"));
}

TEST_CASE("vertices at one place are counted and welded", "[files]") {
  // Two quads side by side, each with its own copies of the common corners; one copy has -0.
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 1 1 0\nv 9 9 9\nv 1 -0 0\nv 2 1 0\nf 1 2 5 4\nf 8 3 9 6\nl 8 6\n";
  PolygonMesh m = parse_obj(text, "file");
  CHECK(coincident_vertices(m.positions) == 2);
  CHECK(to_quad_mesh(m).mesh.vertex_count() == 8);
  weld(m);
  const Surface s = to_quad_mesh(m);
  CHECK(s.mesh.vertex_count() == 6);
  CHECK(s.dropped == 1);
  CHECK(s.from_file == std::vector<int>{0, 1, 2, 3, 4, 4, -1, 1, 5});
  CHECK(m.attributes.elements[0].words[0].vertex == 1);
  // All vertices are written by subdivide, the welded and the unused ones too.
  const Surface fine = to_quad_mesh(subdivide(m));
  const PolygonMesh back = parse_obj(whole_obj_text(fine), "file");
  REQUIRE(back.positions.size() == 9 + 7 + 2);
  for (std::size_t v = 0; v < 9; ++v) CHECK(back.positions[v] == m.positions[v]);
  CHECK(to_quad_mesh(back).mesh == fine.mesh);
  PolygonMesh flat = parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 1 0\nf 1 2 3 4\n", "file");
  CHECK_THROWS_WITH(weld(flat), "file:5: two corners of this face are at one place, so it cannot be welded");
}

TEST_CASE("OBJ: a refusal names the line and the reason", "[files]") {
  const std::string v = kFourVertices;
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "1: the file ends without a vertex or face"},
      {"# nothing\n\n", "3: the file ends without a vertex or face"},
      {v, "5: the file ends without a face"},
      {"v 0 0\n", "1: the line ends where a coordinate is expected"},
      {"v 0 0 zero\n", "1: 'zero' is not a number"},
      {"v 0 0 1.2.3\n", "1: '1.2.3' is not a number"},
      {"v 0 0 1,5\n", "1: '1,5' is not a number"},  // whatever the locale
      {"v 0 0 +-1\n", "1: '+-1' is not a number"},
      {"v 0 0 0x10\n", "1: '0x10' is not a number"},
      {"v 0 0 nan\n", "1: 'nan' is not a finite number"},
      {"v 0 0 -inf\n", "1: '-inf' is not a finite number"},
      {"v 0 0 1e999\n", "1: '1e999' is not a finite number"},
      {"v 0 0 1e300\n", "1: a coordinate is larger than 1e70"},
      {"v 0 0 0 red\n", "1: 'red' is not a number"},
      {v + "f 1 2\n", "5: a face has 2 corners; expected 3 or more"},
      {v + "f\n", "5: a face has 0 corners; expected 3 or more"},
      {v + "f 1 2 5\n", "5: vertex 5 does not exist; there are 4, counted from 1"},
      {v + "f 1 2 0\n", "5: vertex 0 does not exist; OBJ counts from 1"},
      {v + "f 1 2 -5\n", "5: vertex -5 does not exist; there are 4 before this line"},
      {v + "f 1 2 99999999999\n", "5: vertex 99999999999 does not exist; there are 4 before this line"},
      {v + "f 1 2 99999999999999999999\n", "5: '99999999999999999999' is too large"},
      {v + "f 1 2 x\n", "5: 'x' is not an integer"},
      {v + "f 1 2 3.5\n", "5: '3.5' is not a corner v, v/vt, v//vn or v/vt/vn"},
      {v + "f 1 2 3/1/1/1\n", "5: '3/1/1/1' is not a corner v, v/vt, v//vn or v/vt/vn"},
      {v + "f 1 2 3/a\n", "5: 'a' is not an integer"},
      {v + "f 1 2 3 1\n", "5: a vertex occurs twice in this face"},
      {v + "f 1 2 3 -3\n", "5: a vertex occurs twice in this face"},
      {obj(10, {{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 4}}), "11: a vertex occurs twice in this face"},
      {v + "f 1 \\\n 2 \\\n z\n", "7: 'z' is not an integer"},
      {v + "\x01\x02\n", "5: '?\?' does not start a line of OBJ"},
      {"<html>\n", "1: '<html>' does not start a line of OBJ"},
      {"OFF\n4 1 4\n", "1: this is OFF, not OBJ"},
      {"v 0 0 " + std::string(100, 'y') + "\n", "1: '" + std::string(40, 'y') + "...' is not a number"}};
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK(of_obj(text) == expected);
  }
}

TEST_CASE("OFF: a refusal names the line and the reason", "[files]") {
  const std::string v = "0 0 0\n1 0 0\n0 1 0\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "1: nothing where OFF is expected"},
      {"3 1 0\n" + v, "5: the file ends after 0 of 1 faces"},  // the keyword is optional
      {"v 0 0 0\n", "1: 'v' where OFF is expected"},
      {"OFF\n", "2: the file ends where the numbers of vertices and faces are expected"},
      {"OFF BINARY\n", "1: this is a binary OFF file; expected the text format"},
      {"4OFF\n3 1 0\n", "1: '4OFF' is not a surface in three dimensions"},
      {"OFF\n3\n", "3: the file ends where the number of faces is expected"},
      {"OFF\n3 1 0 9\n", "2: '9' after the numbers of vertices, faces and edges"},
      {"OFF\n1000000000 1 0\n" + v, "2: 1000000000 vertices and 1 faces are promised; 19 characters follow"},
      {"OFF\n3 1000000000 0\n" + v, "2: 3 vertices and 1000000000 faces are promised; 19 characters follow"},
      {"OFF\n-3 1 0\n" + v, "2: -3 vertices and 1 faces are promised; 19 characters follow"},
      {"OFF\n3 0 0\n" + v, "6: the file ends without a face"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0         \n\n\n", "7: the file ends after 2 of 3 vertices"},
      {"OFF\n3 2 0\n" + v + "3 0 1 2\n", "7: the file ends after 1 of 2 faces"},
      {"OFF\n3 1 0\n" + v + "3 0 1 2\n3 2 1 0\n", "7: more text after the last of 1 faces"},
      {"OFF\n3 1 0\n" + v + "3 0 1 3\n", "6: vertex 3 does not exist; there are 3, counted from 0"},
      {"OFF\n3 1 0\n" + v + "3 0 1 -1\n", "6: vertex -1 does not exist; there are 3, counted from 0"},
      {"OFF\n3 1 0\n" + v + "2 0 1    \n", "6: a face has 2 corners; expected 3 or more"},
      {"OFF\n3 1 0\n" + v + "1000000000 0 1 2\n", "6: a face with 1000000000 corners is promised; 7 characters follow"},
      {"OFF\n3 1 0\n" + v + "3 0 1 1\n", "6: a vertex occurs twice in this face"},
      {"OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "4: the line ends where a coordinate is expected"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n", "5: 'nan' is not a finite number"}};
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK(of_off(text) == expected);
  }
}

TEST_CASE("polygons that are no quad mesh are refused with the line and the reason", "[files]") {
  const std::vector<std::pair<std::string, std::string>> cases{
      {obj(5, {{1, 2, 3, 4}, {1, 2, 5}}),
       "7: a face has 3 corners; expected a quad (subdividing makes quads of any polygons)"},
      {obj(8, {{1, 2, 3, 4}, {2, 1, 5, 6}, {1, 2, 7, 8}}),
       "11: edge 1-2 has 3 faces, the first in line 9; expected at most 2"},
      {obj(6, {{1, 2, 3, 4}, {2, 5, 6, 3}, {1, 2, 3, 4}}), "9: this face stands in line 7 already"},
      {obj(4, {{1, 2, 3, 4}, {3, 4, 1, 2}}), "6: this face stands in line 5 already"},
      // A strip of three quads, of which the middle one is turned over.
      {obj(8, {{1, 2, 6, 5}, {2, 6, 7, 3}, {3, 4, 8, 7}}),
       "10: this face and that of line 9 are not oriented alike at edge 2-6; turning 1 of the 3 faces round would do"},
      // The same strip, closed with half a turn to a Moebius band.
      {obj(6, {{1, 2, 5, 4}, {2, 3, 6, 5}, {3, 4, 1, 6}}),
       "9: the surface is one-sided, like a Moebius band, and has no orientation; seen at edge 3-6"},
      {obj(7, {{1, 2, 3, 4}, {1, 5, 6, 7}}), "9: vertex 1 is not manifold: its faces form more than one fan"},
      // Each edge has two faces, in opposite directions, but vertex 1 has two fans.
      {obj(7, {{1, 2, 3, 4}, {1, 4, 3, 2}, {1, 5, 6, 7}, {1, 7, 6, 5}}),
       "10: vertex 1 is not manifold: its faces form more than one fan"}};
  for (const auto& [text, expected] : cases) {
    INFO(text);
    CHECK(of_quads(text) == expected);
  }
  // For a Moebius band of triangles the message names an edge of the file, and not one that the subdivision made.
  spill(scratch() / "band.obj", obj(5, {{1, 2, 3}, {2, 3, 4}, {3, 4, 5}, {4, 5, 1}, {5, 1, 2}}));
  try {
    read_surface((scratch() / "band.obj").string(), true);
    FAIL("a Moebius band was taken");
  } catch (const FileError& error) {
    const std::string message = error.what();
    CHECK(message.find("band.obj:9: the surface is one-sided") != std::string::npos);
    CHECK(message.find("seen at edge 4-5") != std::string::npos);
  }
}

TEST_CASE("a damaged file is read or refused in one line (files-3)", "[files]") {
  const std::string good_obj = kFourVertices + "v 2 0 0\nv 2 1 0 # six\nf 1/1 2/2/2 3//3 4\r\nf -5 -2 \\\n-1 3\n";
  const std::string good_off = "OFF\n6 2 7\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n4 0 1 2 3\n4 1 4 5 2\n";
  const std::string bytes = "0123456789-+.eE/\\#fv lnaOF \t\r\n\v\x80\xFF";
  REQUIRE(of_obj(good_obj).empty());
  REQUIRE(of_off(good_off).empty());
  std::mt19937 random(3);
  int refused = 0, taken = 0;
  for (int trial = 0; trial < 40000; ++trial) {
    std::string text = trial % 2 == 0 ? good_obj : good_off;
    for (int change = 0; change <= trial % 3; ++change) {
      const std::size_t at = random() % text.size();
      if (random() % 4 == 0)
        text.erase(at, 1 + random() % 5);
      else if (random() % 2 == 0)
        text.insert(at, 1, bytes[random() % bytes.size()]);
      else
        text[at] = bytes[random() % bytes.size()];
    }
    const auto both = [trial](const std::string& t, const std::string& name) {
      const PolygonMesh m = trial % 2 == 0 ? parse_obj(t, name) : parse_off(t, name);
      const std::string problem = manifold_problem(m);
      const Surface s = to_quad_mesh(problem.empty() ? subdivide(m) : m);
      if (!validate(s.mesh).empty()) throw std::logic_error("not valid");
    };
    ++(complaint(both, text).empty() ? taken : refused);
  }
  CHECK(refused > 5000);
  CHECK(taken > 3000);
}

TEST_CASE("there is a reason for everything that QuadMesh refuses", "[files]") {
  // Random quads on few vertices: nearly all are refused, and every reason occurs. from_faces() decides independently.
  std::mt19937 random(1);
  std::map<std::string, int> reasons;
  int taken = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const int vertices = 6 + trial % 7;
    PolygonMesh m;
    m.name = "file";
    m.positions.resize(static_cast<std::size_t>(vertices), Eigen::Vector3d::Zero());
    std::vector<int> all(static_cast<std::size_t>(vertices));
    for (int v = 0; v < vertices; ++v) all[static_cast<std::size_t>(v)] = v;
    for (int f = 0; f < 2 + trial % 3; ++f) {
      std::shuffle(all.begin(), all.end(), random);
      m.add_face(std::span<const int>(all).first(4), f + 1);
    }
    std::string message;
    try {
      to_quad_mesh(m);
    } catch (const FileError& error) {
      message = error.what();
    }
    CHECK(message == manifold_problem(m));
    ++(message.empty() ? taken : reasons[message.substr(message.find_last_of(": ") + 1)]);
  }
  CHECK(taken > 20);
  CHECK(reasons.size() >= 4);
}
