// Files: nothing is lost between a file and a mesh. Also subdivided polygons, feature files and real meshes.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <map>
#include <random>

#include "mesh/files/feature_edges.hpp"
#include "mesh/files/read_polygons.hpp"
#include "mesh/files/surface.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/text/portable_charconv.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/mesh/files/file_texts.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;
using namespace requad::tests;

TEST_CASE("vertices without faces are dropped, the others keep their order", "[files]") {
  const Surface s = to_quad_mesh(parse_obj("v 9 9 9\n" + kFourVertices + "v 8 8 8\nf 3 4 5 2\n", "file"));
  CHECK(s.dropped == 2);
  CHECK(s.file_vertex == std::vector<int>{1, 2, 3, 4});
  CHECK(s.from_file == std::vector<int>{-1, 0, 1, 2, 3, -1});
  CHECK(s.positions.size() == 4);
  CHECK(s.mesh.corners(FaceId(0))[0] == VertexId(1));
  CHECK(validate(s.mesh).empty());
}

TEST_CASE("what was read is written to the same bits, in the same order (files-5)", "[files]") {
  // The bits are random, but form numbers within the bounds.
  std::mt19937_64 random(2);
  const QuadMesh m = torus(7, 5);
  Positions positions;
  while (positions.size() < 35) {
    Eigen::Vector3d p;
    for (double& x : p) {
      do x = std::bit_cast<double>(random());
      while (!std::isfinite(x) || std::abs(x) > 1e70);
    }
    positions.push_back(p);
  }
  positions[0] = {-0.0, 5e-324, 0.1 + 0.2};
  const std::string text = obj_text(m, positions);
  const Surface back = to_quad_mesh(parse_obj(text, "file"));
  CHECK(back.mesh == m);
  REQUIRE(back.positions.size() == positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    for (int k = 0; k < 3; ++k) {
      CHECK(std::bit_cast<std::uint64_t>(back.positions[v][k]) == std::bit_cast<std::uint64_t>(positions[v][k]));
    }
  }
  CHECK(obj_text(back.mesh, back.positions) == text);
}

TEST_CASE("numbers are written and read alike where the standard library cannot", "[files]") {
  const auto written = [](auto value) {
    std::array<char, 32> buffer;
    return std::string(buffer.data(), portable::to_chars(buffer.data(), buffer.data() + buffer.size(), value));
  };
  const auto standard = [](auto value) {
    std::array<char, 32> buffer;
    return std::string(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
  };
  std::vector<double> values{0,       -0.0,
                             1,       -1,
                             0.1,     0.5,
                             10,      100000,
                             1234567, 1e-4,
                             1e-5,    0.0001234,
                             1e5,     1e6,
                             1e21,    1e22,
                             1e70,    123456789012345680.0,
                             5e-324,  2.2250738585072014e-308,
                             1e-70};
  std::mt19937_64 random(3);
  while (values.size() < 20'000) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) values.push_back(value);
    values.push_back(std::uniform_real_distribution<>(-100, 100)(random));
    values.push_back(std::round(1e6 * values.back()) / 1e6);
  }
  int differences = 0;
  for (const double value : values) {
    const std::string text = written(value);
    double back = 1;
    REQUIRE(portable::from_chars(text.data(), text.data() + text.size(), back).ec == std::errc());
    REQUIRE(bits_of(back) == bits_of(value));
    CAPTURE(text, standard(value));
    REQUIRE(text.size() == standard(value).size());
    differences += text == standard(value) ? 0 : 1;
    const auto single = static_cast<float>(value);
    if (std::isfinite(single)) REQUIRE(written(single).size() == standard(single).size());
  }
  CHECK(differences <= 2);  // next to powers of two, where another text of the same length can be nearer
  for (const std::string text :
       {"1",   "-1.5e+3x", "1e",  "1e+",     ".5",    "5.",      ".",      "-",     "",      "+1", " 1",  "0x10",
        "inf", "-INF",     "nan", "infinit", "1e999", "-1e-999", "1e-320", "00012", "1.5.2", "e5", "-.e1"}) {
    CAPTURE(text);
    double a = 7, b = 7;
    const auto mine = portable::from_chars(text.data(), text.data() + text.size(), a);
    const auto theirs = std::from_chars(text.data(), text.data() + text.size(), b);
    CHECK(mine.ec == theirs.ec);
    CHECK(mine.ptr == theirs.ptr);
    if (!std::isnan(b)) CHECK(bits_of(a) == bits_of(b));
  }
}

TEST_CASE("subdivision has V + E + F vertices, old ones first, and a face for each corner", "[files]") {
  // A triangle, a quad and a pentagon in a row, and a vertex without a face.
  const PolygonMesh m = parse_obj(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nv -1 0.5 0\nv 7 7 7\n"
      "f 1 4 8\nf 1 2 3 4\nf 2 5 6 7 3\n",
      "file");
  const PolygonMesh s = subdivide(m);
  CHECK(s.positions.size() == 9 + 10 + 3);
  CHECK(s.face_count() == 12);
  CHECK(std::equal(m.positions.begin(), m.positions.end(), s.positions.begin()));
  CHECK(s.positions[9] == Eigen::Vector3d(0, 0.5, 0));  // the first edge of the first face
  CHECK(s.positions[19] == (m.positions[0] + m.positions[3] + m.positions[7]) / 3);
  CHECK(s.lines == std::vector<int>{10, 10, 10, 11, 11, 11, 11, 12, 12, 12, 12, 12});
  const Surface quads = to_quad_mesh(s);
  CHECK(validate(quads.mesh).empty());
  CHECK(euler_characteristic(quads.mesh) == 1);
  CHECK(quads.dropped == 1);
}

TEST_CASE("files that cannot be read, and names", "[files]") {
  const auto refused = [](const std::string& path) {
    try {
      read_polygon_mesh(path);
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refused("/no/such/file.obj") == "/no/such/file.obj: cannot be read: No such file or directory");
  std::filesystem::create_directory(scratch() / "folder.off");
  CHECK(refused((scratch() / "folder.off").string()).ends_with("folder.off: cannot be read: it is a folder"));
  CHECK(refused("mesh.stl") == "mesh.stl: expected a name that ends in .obj or .off");
  CHECK(refused("") == ": expected a name that ends in .obj or .off");
  spill(scratch() / "upper.OBJ", kFourVertices + "f 1 2 3 4\n");
  CHECK(read_polygon_mesh((scratch() / "upper.OBJ").string()).face_count() == 1);
}

TEST_CASE("feature files", "[files]") {
  // A vertex without a face, and then the vertices 1..12 of a grid of 3 x 2 quads.
  Region g = grid(3, 2);
  std::string text = "v 0 0 0\n";
  for (int v = 0; v < g.mesh.vertex_count(); ++v)
    text += "v " + std::to_string(v % 4) + " " + std::to_string(v / 4) + " 0\n";
  for (const auto& f : g.mesh.compact_faces()) {
    text += "f";
    for (const int v : f) text += " " + std::to_string(v + 2);
    text += "\n";
  }
  const Surface s = to_quad_mesh(parse_obj(text, "file"));
  const auto name = [&s](VertexId v) { return std::to_string(s.file_vertex[v.slot()] + 1); };
  std::vector<HalfEdgeId> inner = s.mesh.half_edges();
  std::erase_if(inner, [&s](HalfEdgeId h) { return s.mesh.is_boundary(h); });
  const VertexId a = s.mesh.origin(inner[0]), b = s.mesh.target(inner[0]);
  const std::array<VertexId, 2> edge{std::min(a, b), std::max(a, b)};

  const auto parse = [&s](const std::string& t) { return parse_feature_edges(t, "file", s); };
  CHECK(parse("").empty());
  CHECK(parse("# none\n" + name(a) + " " + name(b) + "\n" + name(b) + " " + name(a) + "\n") == FeatureEdges{edge});
  CHECK(parse(text + "l " + name(a) + "/3 " + name(b) + "/4\n") == FeatureEdges{edge});
  CHECK(parse(name(a) + " " + std::to_string(s.file_vertex[b.slot()] - 13)) == FeatureEdges{edge});  // backwards
  const HalfEdgeId rim = s.mesh.out(VertexId(0));
  CHECK(parse(name(s.mesh.origin(rim)) + " " + name(s.mesh.target(rim))).empty());  // a boundary edge is one anyway

  const auto refused = [&parse](const std::string& t) {
    return complaint([&parse](const std::string& u, const std::string&) { parse(u); }, t);
  };
  CHECK(refused("2 3 4\n") == "1: more than two vertices; expected an edge, or a chain after `l`");
  CHECK(refused("\n2\n") == "2: fewer than two vertices; expected an edge");
  CHECK(refused("l\n") == "1: fewer than two vertices; expected an edge");
  CHECK(refused("2 2\n") == "1: no edge joins the vertices 2 and 2");
  CHECK(refused("2 14\n") == "1: vertex 14 does not exist; there are 13, counted from 1");
  CHECK(refused("2 0\n") == "1: vertex 0 does not exist; there are 13, counted from 1");
  CHECK(refused("1 2\n") == "1: vertex 1 is in no face");
  CHECK(refused("2 x\n") == "1: 'x' is not an integer");
  CHECK(refused("2 3.5\n") == "1: '3.5' is not a vertex");
  CHECK(refused("?\n") == "1: '?' is not a vertex");

  // If the mesh is subdivided, an edge of the file stands for its two halves.
  spill(scratch() / "grid.obj", text);
  const Surface halves = read_surface((scratch() / "grid.obj").string(), true);
  const FeatureEdges two = parse_feature_edges(name(a) + " " + name(b), "file", halves);
  CHECK(two.size() == 2);
  CHECK(complaint([&](const std::string& t, const std::string& n) { parse_feature_edges(t, n, halves); }, "2 13\n") ==
        "1: no edge joins the vertices 2 and 13");
}

TEST_CASE("real meshes are as the table of their collection says", "[files][real]") {
  // Genus, loops and irregular vertices are from the table of the collection's README.
  struct Row {
    const char* name;
    int vertices, faces, genus, loops;
    std::map<int, int> irregular;
    int inverted;  // -1: the table does not say
  };
  const std::vector<Row> rows{{"spot", 2930, 2928, 0, 0, {{3, 56}, {5, 40}, {6, 4}}, -1},
                              {"fandisk_bommes", 766, 764, 0, 0, {{3, 19}, {5, 11}}, -1},
                              {"hole_capsule", 89, 76, 0, 3, {{3, 2}}, -1},
                              {"gargoyle_quadriflow", 4117, 4115, 0, 0, {{3, 94}, {5, 86}}, -1},
                              {"armadillo_gel", 5570, 5568, 0, 0, {{3, 82}, {5, 65}, {6, 3}, {7, 1}}, -1},
                              {"bigguy", 1452, 1450, 0, 0, {{3, 108}, {5, 76}, {6, 12}}, -1},
                              {"blub", 7106, 7104, 0, 0, {{3, 26}, {5, 8}, {6, 2}, {7, 2}}, -1},
                              {"bob", 5344, 5344, 1, 0, {{3, 10}, {5, 10}}, -1},
                              {"bunny_qex", 2073, 2071, 0, 0, {{3, 45}, {5, 35}, {6, 1}}, 12},
                              {"botijo_miq", 1048, 1056, 5, 0, {{2, 1}, {3, 21}, {5, 49}, {6, 3}}, -1},
                              {"anet_complete01", 860, 768, 0, 6, {{6, 8}}, -1},
                              {"pawn", 601, 588, 0, 1, {{3, 12}, {12, 1}}, -1}};
  for (const Row& row : rows) {
    const std::optional<std::string> path = real_mesh(row.name);
    if (!path) continue;
    INFO(row.name);
    const Surface s = read_surface(*path, false);
    CHECK(validate(s.mesh).empty());
    const Diagnosis d = diagnose(s.mesh, s.positions);
    CHECK(d.vertices == row.vertices);
    CHECK(d.faces == row.faces);
    CHECK(d.genus == row.genus);
    CHECK(d.boundary_loops == row.loops);
    std::map<int, int> irregular = d.valences;
    irregular.erase(4);
    CHECK(irregular == row.irregular);
    if (row.inverted >= 0) CHECK(d.inverted == row.inverted);

    const Surface back = to_quad_mesh(parse_obj(obj_text(s.mesh, s.positions), "file"));
    CHECK(back.mesh == s.mesh);
    CHECK(back.positions == s.positions);
  }
  for (const auto& [name, vertices, triangles] :
       {std::tuple{"tri_bunny", 3485, 6966}, std::tuple{"tri_spot", 2930, 5856}}) {
    const std::optional<std::string> path = real_mesh(name);
    if (!path) continue;
    const Surface s = read_surface(*path, true);
    CHECK(s.mesh.vertex_count() == vertices + triangles * 3 / 2 + triangles);
    CHECK(s.mesh.face_count() == 3 * triangles);
    CHECK(validate(s.mesh).empty());
  }
}
