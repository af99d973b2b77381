// Groups, materials, texture coordinates, normals and tags through reading, editing and writing. The texture coordinates
// of the edited mesh are a linear function of the position and of the material, so that each corner can be judged alone.
#include <array>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "mesh/editing/carried_attributes.hpp"
#include "mesh/files/feature_edges.hpp"
#include "mesh/files/read_polygons.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;
using namespace requad::tests;

namespace {

// Three quads in a row, with everything that is kept, in the order in which it is written.
const std::string kRow = R"(mtllib a.mtl
v 0 0 0 1 0 0
v 1 0 0 0.50 0 0
v 2 0 0
v 3 0 0
v 0 1 0
v 1 1 0
v 2 1 0
v 3 1 0
vt 0 0
vt 1.0 0
vt 1 1 0
vt 0 1
vt 5 5
vn 0 0 1.0
o thing
g left part
usemtl stone  wall
s 1
f 1/1/1 2/2/1 6/3/1 5/4/1
g right
f 2/5 3/5 7/5 6/5
s off
f 3//1 4//1 8//1 7//1
l 1/1 2 3
p 4
t crease 2/1/0 1 5 2.500
t corner 1/1/0 0 9
)";

// The lines of a text that start with one of the keywords.
std::vector<std::string> lines_with(const std::string& text, const std::set<std::string>& keywords) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (keywords.count(line.substr(0, line.find(' '))) != 0) lines.push_back(line);
  }
  return lines;
}

// The texture coordinates of the test mesh at a point of a material.
Eigen::Vector3d uv_of(const Eigen::Vector3d& p, const std::string& material) {
  return {p.x() + 0.5 * p.z() + (material == "usemtl left" ? 0 : 100), p.y() - 0.25 * p.z(), 0};
}

// The block of Figure 16 with two materials, left and right of its middle, a seam between them, two groups, normals.
std::string dressed_block() {
  const Surface s = read_surface(REQUAD_SOURCE_DIR "/mesh/examples/figure-16.obj", false);
  std::string vertices, uvs, faces = "mtllib block.mtl\no block\n";
  for (const Eigen::Vector3d& p : s.positions) {
    std::ostringstream line;
    line.precision(17);
    line << "v " << p.x() << " " << p.y() << " " << p.z() << "\n";
    vertices += line.str();
  }
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : s.positions) middle += p / static_cast<double>(s.positions.size());
  int count = 0;
  std::string material_before, group_before;
  for (const FaceId f : s.mesh.faces()) {
    const Eigen::Vector3d centre = face_centre(s.mesh, s.positions, f), n = face_normal(s.mesh, s.positions, f);
    const std::string material = centre.x() < middle.x() ? "usemtl left" : "usemtl right";
    const std::string group = centre.y() < middle.y() ? "g low" : "g high";
    if (material != material_before) faces += material + "\n";
    if (group != group_before) faces += group + "\n";
    material_before = material;
    group_before = group;
    faces += "f";
    for (const VertexId v : s.mesh.corners(f)) {
      const Eigen::Vector3d uv = uv_of(s.positions[v.slot()], material);
      std::ostringstream line;
      line.precision(17);
      line << "vt " << uv.x() << " " << uv.y() << "\nvn " << n.x() << " " << n.y() << " " << n.z() << "\n";
      uvs += line.str();
      ++count;
      faces += " " + std::to_string(v.index() + 1) + "/" + std::to_string(count) + "/" + std::to_string(count);
    }
    faces += "\n";
  }
  return vertices + uvs + faces;
}

// Checks each corner of an edited block by its position and the material of its face. Returns the number of corners
// whose texture coordinates the input did not have.
int check_block(const std::string& text, int given) {
  const Surface s = to_quad_mesh(parse_obj(text, "edited"));
  const Attributes& a = s.attributes;
  REQUIRE(a.state_of_face.size() == static_cast<std::size_t>(s.mesh.face_count()));
  const double edge = diagnose(s.mesh, s.positions).edge_length.mean;
  int made = 0, wrong_uvs = 0, wrong_normals = 0, wrong_states = 0;
  for (const HalfEdgeId h : s.mesh.half_edges()) {
    const Attributes::State& state = a.states[static_cast<std::size_t>(a.state(QuadMesh::face(h).slot()))];
    const auto material =
        std::find_if(state.begin(), state.end(), [](const auto& line) { return line.starts_with("usemtl"); });
    wrong_states += material == state.end() || std::count(state.begin(), state.end(), "o block") != 1 ? 1 : 0;
    if (material == state.end()) continue;
    const int uv = a.uvs.at(h.slot()), normal = a.normals.at(h.slot());
    REQUIRE(uv >= 0);
    REQUIRE(normal >= 0);
    made += uv >= given ? 1 : 0;
    const Eigen::Vector3d expected = uv_of(s.positions[s.mesh.origin(h).slot()], *material);
    // Where a vertex left the surface, the nearest point on it counts.
    wrong_uvs += (a.uvs.numbers[static_cast<std::size_t>(uv)] - expected).norm() < 0.25 * edge ? 0 : 1;
    const Eigen::Vector3d n = a.normals.numbers[static_cast<std::size_t>(normal)];
    wrong_normals +=
        std::abs(n.norm() - 1) < 1e-6 && n.dot(face_normal(s.mesh, s.positions, QuadMesh::face(h))) > 0.5 ? 0 : 1;
  }
  CHECK(wrong_states == 0);
  CHECK(wrong_uvs == 0);
  CHECK(wrong_normals == 0);
  return made;
}

}  // namespace

TEST_CASE("what is read beside positions and faces is written again (files-6)", "[attributes]") {
  const Surface s = to_quad_mesh(parse_obj(kRow, "file"));
  CHECK(obj_text(s.mesh, s.positions, s.attributes) == kRow);
  CHECK(s.attributes.not_kept.empty());
  CHECK(texture_seams(s).size() == 2);
  // Without any, the text has vertices and faces alone.
  const Surface bare = to_quad_mesh(parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "file"));
  CHECK(bare.attributes.empty());
  CHECK(obj_text(bare.mesh, bare.positions, bare.attributes) == obj_text(bare.mesh, bare.positions));
}

TEST_CASE("what cannot be kept is counted", "[attributes]") {
  const PolygonMesh m = parse_obj(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf 1/7 2 3//2 4/-3\nf 4/1 3 2 1\nvp 1\ncurv 0 1 1 2\nl 1 9\nt hole "
      "1/0/0 0\n"
      "t crease 1 2\n",
      "file");
  const std::map<std::string, int> expected{{"'curv' lines", 1},
                                            {"'t crease' tags", 1},
                                            {"'t hole' tags", 1},
                                            {"'vp' lines", 1},
                                            {"indices of missing 'vn' lines", 1},
                                            {"indices of missing 'vt' lines", 2},
                                            {"lines with missing vertices", 1}};
  CHECK(m.attributes.not_kept == expected);
  CHECK(m.attributes.uvs.at(0) == -1);
  CHECK(m.attributes.uvs.at(4) == 0);
  CHECK(not_kept_text(m.attributes).starts_with("1 'curv' lines, 1 't crease' tags"));
}

TEST_CASE("an edit that changes nothing keeps everything, line by line (editing-15)", "[attributes][programs]") {
  spill(scratch() / "row.obj", kRow);
  CHECK(call("edit", "smooth row.obj --iterations 0 -o -").out == kRow);
  CHECK(call("edit", "smooth row.obj -o -").out == kRow);  // all vertices are on the boundary
  const Outcome both = call("edit", "smooth row.obj --keep-seams --no-keep-seams -o -");
  CHECK(both.code == 2);
  spill(scratch() / "bare.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  CHECK(call("edit", "smooth bare.obj --keep-seams -o -").code == 2);
}

TEST_CASE("subdividing keeps statements, and takes means of values, colours and tags", "[attributes]") {
  const Surface fine = to_quad_mesh(subdivide(parse_obj(kRow, "file")));
  const Surface back = to_quad_mesh(parse_obj(whole_obj_text(fine), "file"));
  CHECK(back.attributes.states == fine.attributes.states);
  CHECK(back.attributes.elements == fine.attributes.elements);
  const Attributes& a = back.attributes;
  CHECK(a.vertex_words[0] == "1 0 0");
  CHECK(a.vertex_words[8] == "0.75 0 0");  // the middle of the first edge
  CHECK(a.state(3) == a.state(0));
  CHECK(a.state(4) != a.state(0));
  // The first face: corners (0,0), (1,0), (1,1), (0,1); its centre is corner 2 of each of its quads.
  CHECK(a.uvs.numbers[static_cast<std::size_t>(a.uvs.at(2))] == Eigen::Vector3d(0.5, 0.5, 0));
  CHECK(a.uvs.at(2) == a.uvs.at(6));
  CHECK(a.uvs.numbers[static_cast<std::size_t>(a.uvs.at(1))] == Eigen::Vector3d(0.5, 0, 0));
  CHECK(a.uvs.at(16) == 4);  // all corners of the second face have (5,5)
  CHECK(a.uvs.at(18) == 4);
  const std::vector<std::string> tags = lines_with(whole_obj_text(fine), {"t"});
  REQUIRE(tags.size() == 3);
  CHECK(tags[0].starts_with("t crease 2/1/0 1 "));
  CHECK(tags[1].starts_with("t crease 2/1/0 "));
  CHECK(tags[1].ends_with(" 5 2.500"));
  CHECK(tags[2] == "t corner 1/1/0 0 9");
}

TEST_CASE("materials, groups, seams and normals survive edits (section 8)", "[attributes][programs]") {
  const std::string block = dressed_block();
  spill(scratch() / "block.obj", block);
  const Surface input = to_quad_mesh(parse_obj(block, "block"));
  const int given = static_cast<int>(input.attributes.uvs.words.size());
  REQUIRE(check_block(block, given) == 0);
  const FeatureEdges seam = texture_seams(input);
  REQUIRE(seam.size() > 8);

  const auto edited = [](const std::string& arguments) {
    const Outcome outcome = call("edit", arguments);
    INFO(arguments << "\n" << outcome.err);
    CHECK(outcome.code == 0);
    return slurp(scratch() / "edited.obj");
  };
  const std::string less = edited("reduce block.obj -o edited.obj --script edits.txt");
  CHECK(to_quad_mesh(parse_obj(less, "")).mesh.vertex_count() != input.mesh.vertex_count());
  CHECK(check_block(less, given) > 0);
  // The seam is where it was, with the same ends.
  CHECK(texture_seams(to_quad_mesh(parse_obj(less, ""))).size() == seam.size());
  // Values keep their lines, and faces that were not changed theirs.
  const std::string local = edited("reduce block.obj -o edited.obj --smooth 0 --final-smooth 0");
  CHECK(check_block(local, given) > 0);
  const auto uvs = lines_with(block, {"vt"}), uvs_after = lines_with(local, {"vt"});
  REQUIRE(uvs_after.size() > uvs.size());
  CHECK(std::equal(uvs.begin(), uvs.end(), uvs_after.begin()));
  const auto values_of = [](const std::string& face) {  // without the vertices, which get other numbers
    return std::regex_replace(face, std::regex(" [0-9]+/"), " ");
  };
  std::set<std::string> known;
  for (const std::string& face : lines_with(block, {"f"})) known.insert(values_of(face));
  int kept = 0;
  for (const std::string& face : lines_with(local, {"f"})) kept += known.count(values_of(face)) != 0 ? 1 : 0;
  CHECK(kept > 20);

  spill(scratch() / "less.obj", less);
  const std::string back = edited("apply less.obj edits.txt --undo -o edited.obj");
  CHECK(lines_with(back, {"v"}) == lines_with(obj_text(input.mesh, input.positions), {"v"}));
  check_block(back, given);
  const std::string smooth = edited("smooth block.obj --project -o edited.obj");
  CHECK(check_block(smooth, given) > 0);
  const std::string free = edited("smooth block.obj --project --no-keep-seams -o edited.obj");
  CHECK(check_block(free, given) > 0);
}

TEST_CASE("a texture for each face keeps no edge from being edited", "[attributes][programs]") {
  // Each face of the block has the whole texture, as some modellers write by default.
  std::string text = lines_with(dressed_block(), {"mtllib"}).front() + "\n";
  const Surface s = read_surface(REQUAD_SOURCE_DIR "/mesh/examples/figure-16.obj", false);
  std::istringstream in(obj_text(s.mesh, s.positions));
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string keyword, a, b, c, d;
    words >> keyword >> a >> b >> c >> d;
    text += keyword == "f" ? "f " + a + "/1 " + b + "/2 " + c + "/3 " + d + "/4\n" : line + "\n";
  }
  spill(scratch() / "each.obj", text + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n");
  const Outcome outcome = call("edit", "reduce each.obj -o each-less.obj --json each.json");
  CHECK(outcome.code == 0);
  const Surface less = read_surface((scratch() / "each-less.obj").string(), false);
  CHECK(irregular_vertices(less.mesh).size() < irregular_vertices(s.mesh).size());
  CHECK(less.attributes.uvs.words.size() == 4);
  for (std::size_t corner = 0; corner < less.attributes.uvs.at_corner.size(); ++corner)
    CHECK(less.attributes.uvs.at(corner) == static_cast<int>(corner % 4));
  // On request the edges are kept, and nothing can be cancelled.
  CHECK(call("edit", "reduce each.obj --keep-seams -o each-kept.obj").code == 0);
  CHECK(read_surface((scratch() / "each-kept.obj").string(), false).mesh == s.mesh);
}

TEST_CASE("a real mesh with groups and texture coordinates comes back", "[attributes][real]") {
  const auto path = real_mesh("mh_base");
  if (!path) return;
  CHECK(call("edit", "smooth '" + *path + "' --iterations 0 -o mh.obj").code == 0);
  const std::string in = slurp(*path), out = slurp(scratch() / "mh.obj");
  CHECK(lines_with(out, {"f", "g", "s"}) == lines_with(in, {"f", "g", "s"}));
  CHECK(lines_with(out, {"vt"}) == lines_with(in, {"vt"}));
}
