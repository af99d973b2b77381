// requad-edit from outside, and requad-enumerate signature FILE.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::tests;
using nlohmann::json;

namespace {

// A cube with corners at 1 and -1, and the same cube as triangles.
const std::string kCorners = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const std::string kCube = kCorners + "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
const std::string kTriangles = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

void write_inputs() {
  spill(scratch() / "cube.obj", kCube);
  spill(scratch() / "tetrahedron.off", kTriangles);
  spill(scratch() / "bad.obj", kCorners + "f 1 2 3 nine\n");
  spill(scratch() / "edges.txt", "1 2\n3 4\n");
  spill(scratch() / "bad-edges.txt", "1 2\n1 7\n");
}

json parsed(const Outcome& outcome) {
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  return json::parse(outcome.out);
}

}  // namespace

TEST_CASE("requad-edit info", "[programs]") {
  write_inputs();
  const json cube = parsed(call("edit", "info cube.obj --json - --feature-angle 60"));
  CHECK(cube["vertices"] == 8);
  CHECK(cube["faces"] == 6);
  CHECK(cube["boundary_loops"] == 0);
  CHECK(cube["genus"] == 0);
  CHECK(cube["valences"] == json{{"3", 8}});
  CHECK(cube["interior_irregular"] == 8);
  CHECK(cube["feature_edges"] == 12);
  CHECK(cube["feature_corners"] == 8);
  CHECK(cube["scaled_jacobian"]["mean"] == Approx(1));

  const json quads = parsed(call("edit", "--json - info --subdivide tetrahedron.off"));
  CHECK(quads["vertices"] == 4 + 6 + 4);
  CHECK(quads["faces"] == 12);
  CHECK(quads["feature_edges"].is_null());

  const json listed = parsed(call("edit", "info cube.obj --features edges.txt --json -"));
  CHECK(listed["feature_edges"] == 2);
  CHECK(listed["feature_corners"] == 4);

  const Outcome text = call("edit", "info cube.obj");
  CHECK(text.code == 0);
  CHECK(text.out.find("interior valences: v3:8; 8 irregular") != std::string::npos);
  CHECK(call("edit", "info cube.obj --quiet").out.empty());
  CHECK(call("edit", "info --help").out.find("requad-edit smooth") == std::string::npos);
}

TEST_CASE("requad-edit smooth and subdivide", "[programs]") {
  write_inputs();
  // Smoothing does not change a cube. If all its edges are features, no vertex may move.
  const Outcome still = call("edit", "smooth cube.obj --feature-angle 60 -o still.obj");
  CHECK(still.code == 0);
  CHECK(still.out.rfind("0 vertices moved", 0) == 0);
  CHECK(slurp(scratch() / "still.obj") == kCube);
  const json moved = parsed(call(
      "edit", "smooth cube.obj --iterations 2 --weights chord --no-guard --pull 0.5 --project -o moved.obj --json -"));
  CHECK(moved["moved"] == 8);
  CHECK(moved["largest_move"] > 0);
  CHECK(moved["largest_move"] <= 0.5 + 1e-12);
  CHECK(call("edit", "smooth cube.obj --iterations 0 -o -").out == kCube);

  CHECK(call("edit", "subdivide tetrahedron.off -o quads.obj").code == 0);
  CHECK(parsed(call("edit", "info quads.obj --json -"))["valences"] == json{{"3", 8}, {"4", 6}});
  const Outcome again = call("edit", "subdivide cube.obj -o -");
  CHECK(again.out.rfind(kCorners, 0) == 0);
}

TEST_CASE("requad-edit: one line for bad input, exit 2, nothing written", "[programs]") {
  write_inputs();
  for (const std::string arguments : {"",
                                      "dance",
                                      "info",
                                      "info cube.obj cube.obj",
                                      "info missing.obj",
                                      "info bad.obj",
                                      "info tetrahedron.off",
                                      "info cube.obj --iterations 3",
                                      "info cube.obj --feature-angle x",
                                      "info cube.obj --feature-angle 181",
                                      "info cube.obj --feature-angle -1",
                                      "info cube.obj --feature-angle nan",
                                      "info cube.obj --feature-angle 30 --features edges.txt",
                                      "info cube.obj --features bad-edges.txt",
                                      "info cube.obj --features missing.txt",
                                      "info cube.obj --json /no/such/folder/x",
                                      "info cube.stl",
                                      "smooth cube.obj",
                                      "smooth cube.obj -o out.off",
                                      "smooth cube.obj -o out.obj --weights heavy",
                                      "smooth cube.obj -o out.obj --iterations -1",
                                      "smooth cube.obj -o out.obj --pull -0.5",
                                      "smooth cube.obj -o out.obj --pull inf",
                                      "smooth cube.obj -o - --json -",
                                      "smooth bad.obj -o out.obj",
                                      "smooth cube.obj -o out.obj --threads 0",
                                      "subdivide cube.obj",
                                      "subdivide -o out.obj",
                                      "subdivide bad.obj -o out.obj",
                                      "subdivide cube.obj -o /no/such/folder/out.obj"}) {
    INFO(arguments);
    const Outcome outcome = call("edit", arguments);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.rfind("requad-edit: ", 0) == 0);
    CHECK(tests::line_count(outcome.err) == 1);
  }
  CHECK_FALSE(std::filesystem::exists(scratch() / "out.obj"));
  CHECK(call("edit", "info bad.obj").err == "requad-edit: bad.obj:9: 'nine' is not an integer\n");
  CHECK(call("edit", "info cube.obj --features bad-edges.txt").err ==
        "requad-edit: bad-edges.txt:2: no edge joins the vertices 1 and 7\n");
}

TEST_CASE("requad-enumerate signature of a file", "[programs]") {
  write_inputs();
  // Two files of one mesh, a file of another mesh, and the search, which finds the cube: it is the only sphere with
  // eight v3s and 8 vertices.
  spill(scratch() / "renamed.obj", kCorners + "f 3 2 1 4\nf 8 5 6 7\nf 5 1 2 6\nf 6 2 3 7\nf 7 3 4 8\nf 8 4 1 5\n");
  const std::string cube = call("enumerate", "signature cube.obj").out;
  CHECK(tests::line_count(cube) == 1);
  CHECK(call("enumerate", "signature renamed.obj").out == cube);
  CHECK(call("enumerate", "signature tetrahedron.off --subdivide").out != cube);
  const json spheres =
      json::parse(call("enumerate", "sphere --irregular 3,3,3,3,3,3,3,3 --vertices 8..8 --list --json -").out);
  CHECK(spheres["spheres"][0].get<std::string>() + "\n" == cube);
  const json named = parsed(call("enumerate", "signature cube.obj --json -"));
  CHECK(named["canonical"].get<std::string>() + "\n" == cube);
  CHECK(named["chiral"] == false);

  spill(scratch() / "two.obj", kCorners + "f 1 2 3 4\nf 5 6 7 8\n");
  for (const std::string arguments :
       {"signature", "signature missing.obj", "signature two.obj", "signature tetrahedron.off",
        "signature cube.obj cube.obj", "signature cube.obj --from-signature x", "signature cube.obj -o out.obj"}) {
    INFO(arguments);
    const Outcome outcome = call("enumerate", arguments);
    CHECK(outcome.code == 2);
    CHECK(tests::line_count(outcome.err) == 1);
  }
}
