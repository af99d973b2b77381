// Edit scripts from outside: requad-edit apply, and the scripts that other commands write.
#include <algorithm>
#include <random>

#include <nlohmann/json.hpp>

#include "mesh/editing/element_map.hpp"
#include "mesh/files/feature_edges.hpp"
#include "mesh/files/read_polygons.hpp"
#include "mesh/files/write_obj.hpp"
#include "tests/mesh/editing/workshop.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::mesh;
using requad::tests::call;
using requad::tests::crooked_torus;
using requad::tests::line_count;
using requad::tests::lines_of;
using requad::tests::Outcome;
using requad::tests::replaced;
using requad::tests::scratch;
using requad::tests::slurp;
using requad::tests::spill;
using requad::tests::Workshop;

TEST_CASE("requad-edit apply replays, undoes and maps", "[programs][script]") {
  using nlohmann::json;
  std::mt19937 random(3);
  Workshop w(crooked_torus(6, 5));
  w.edit(300, random);
  const std::string in = obj_text(w.input.mesh, w.input.positions), out = obj_text(w.m, w.positions);
  // The file starts with an unused vertex, which is dropped. So the file and the mesh number vertices differently.
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

  // Bad input ends with exit code 2 and one line, and nothing is written.
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

  // Features that the script would break end with exit code 1, and the message names the line.
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

TEST_CASE("requad-edit --script: the scripts of editing commands can be applied and undone",
          "[programs][script][real]") {
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
    // The map forth and the map back are inverse to each other, except for elements that were removed.
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
  // A script on standard output replaces the report.
  const std::string cancel = "cancel " + *path + pair + " -o made.obj";
  const auto shown = call("edit", cancel + " --script -");
  CHECK(shown.code == 0);
  CHECK(parse_script(shown.out, "stdout").before == digest(input.mesh, input.positions));
  CHECK(call("edit", cancel + " --script - --map -").code == 2);
  CHECK(call("edit", "moves " + *path + pair + " --script x.txt").code == 2);
}

TEST_CASE("apply takes a mesh whose coordinates another program has rounded (editing-16)", "[scripts][programs]") {
  const std::string example = REQUAD_SOURCE_DIR "/mesh/examples/figure-16.obj";
  const auto rounded_to = [](const std::string& text, int digits) {
    std::istringstream in(text);
    std::ostringstream out;
    out.precision(digits);
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      std::string keyword;
      double x = 0, y = 0, z = 0;
      if (line.starts_with("v ") && words >> keyword >> x >> y >> z) {
        out << "v " << x << " " << y << " " << z << "\n";
      } else {
        out << line << "\n";
      }
    }
    return out.str();
  };
  REQUIRE(call("edit", "reduce '" + example + "' -o less.obj --script edits.txt").code == 0);
  const std::string original = slurp(example), less = slurp(scratch() / "less.obj");
  const Surface before = read_surface(example, false);
  spill(scratch() / "rounded.obj", rounded_to(less, 7));
  const Outcome back = call("edit", "apply rounded.obj edits.txt --undo -o back.obj --json undo.json");
  CHECK(back.err.empty());
  REQUIRE(back.code == 0);
  CHECK(back.out.find("rounded, by at most") != std::string::npos);
  CHECK(nlohmann::json::parse(slurp(scratch() / "undo.json"))["rounded_by"] > 0);
  const Surface after = read_surface((scratch() / "back.obj").string(), false);
  CHECK(after.mesh == before.mesh);
  for (std::size_t v = 0; v < before.positions.size(); ++v)
    CHECK((after.positions[v] - before.positions[v]).norm() < 1e-5);
  // Forwards too. Without rounding, the last bit comes back.
  spill(scratch() / "start.obj", rounded_to(original, 7));
  CHECK(call("edit", "apply start.obj edits.txt -o again.obj").code == 0);
  CHECK(read_surface((scratch() / "again.obj").string(), false).mesh ==
        read_surface((scratch() / "less.obj").string(), false).mesh);
  REQUIRE(call("edit", "apply less.obj edits.txt --undo -o exact.obj").code == 0);
  CHECK(read_surface((scratch() / "exact.obj").string(), false).positions == before.positions);

  // Too coarse, or one vertex somewhere else: the difference is told. Other faces are another mesh.
  const auto refusal = [](const std::string& text) {
    spill(scratch() / "other.obj", text);
    const Outcome outcome = call("edit", "apply other.obj edits.txt --undo -o no.obj");
    CHECK(outcome.code == 2);
    CHECK(line_count(outcome.err) == 1);
    return outcome.err;
  };
  const std::string coarse = refusal(rounded_to(less, 3));
  CHECK(coarse.find("from where the script has it; at most") != std::string::npos);
  CHECK(coarse.find("edits.txt: vertex ") != std::string::npos);
  std::string turned = less;  // the first face starts at another corner
  const std::size_t face = turned.find("\nf ") + 3, first_end = turned.find(' ', face), end = turned.find('\n', face);
  turned = turned.substr(0, face) + turned.substr(first_end + 1, end - first_end - 1) + " " +
           turned.substr(face, first_end - face) + turned.substr(end);
  CHECK(refusal(turned).find("belongs to another mesh") != std::string::npos);
  // A script without the fingerprints of the faces is exact.
  std::string older = slurp(scratch() / "edits.txt");
  const std::size_t line = older.find("mesh "), stop = older.find('\n', line);
  older = older.substr(0, stop - 2 * 17) + older.substr(stop);
  spill(scratch() / "edits.txt", older);
  CHECK(refusal(rounded_to(less, 7)).find("belongs to another mesh") != std::string::npos);
  CHECK(call("edit", "apply less.obj edits.txt --undo -o exact.obj").code == 0);
}
