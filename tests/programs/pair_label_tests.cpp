// The extents (d1, d2) that requad-edit prints are those of the paper's side-length equations. Tests compare them with
// labels that are read off the same mesh. They check these labels by the equations and the lengths of the mesh's sides.
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "enumerate/generators.hpp"
#include "enumerate/labels.hpp"
#include "mesh/files/polygon_mesh.hpp"
#include "mesh/files/write_obj.hpp"
#include "mesh/topology/separatrix.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::tests;

using theory::PairType;

namespace {

struct Sample {
  PairType type;
  theory::StripParameters parameters;
};
// All of these have d1 != d2 and room for moves.
const std::vector<Sample>& samples() {
  static const std::vector<Sample> all{
      {theory::kDigon, {2, 1, theory::to_vector({3, 2})}},
      {theory::kDigon, {1, 4, theory::to_vector({2, 3})}},
      {theory::kDigon, {3, 1, theory::to_vector({4, 4})}},
      {theory::kHexagon, {1, 2, theory::to_vector({1, 1, 2, 1, 1, 1})}},
      {theory::kHexagon, {2, 3, theory::to_vector({1, 2, 2, 1, 3, 1})}},
      {theory::kHexagon, {4, 2, theory::to_vector({3, 2, 3, 3, 2, 3})}},
      {theory::kQuad, {2, 1, theory::to_vector({1, 2, 3, 1})}},
      {theory::kQuad, {1, 3, theory::to_vector({2, 1, 1, 2})}},
      {theory::kQuad, {3, 2, theory::to_vector({3, 3, 3, 3})}},
  };
  return all;
}

// The mesh of a file, rooted at a corner.
mesh::Region region_in(const std::string& file) {
  mesh::Region region{mesh::read_surface((scratch() / file).string(), false).mesh, {}};
  for (const mesh::HalfEdgeId h : region.mesh.half_edges()) {
    if (region.mesh.is_boundary(h) && mesh::turn(region.mesh, region.mesh.origin(h)) == 1) region.root = h;
  }
  REQUIRE(mesh::region_problem(region).empty());
  return region;
}

std::string text_of(std::int64_t d1, std::int64_t d2) {
  return "(" + std::to_string(d1) + "," + std::to_string(d2) + ")";
}

// The labels "(d1,d2)" of the pair in a region: one for a rectangle, two for a segment.
std::set<std::string> labels_of(const mesh::Region& region, PairType type) {
  const enumerate::Reading reading = enumerate::read(region, type);
  CHECK(reading.problem.empty());
  const std::vector<int> sides = mesh::side_lengths(region);
  std::set<std::string> labels;
  for (const enumerate::LabelledFrame& f : reading.frames) {
    const theory::IntegerVector expected = theory::region_sides(type, f.labelling);
    CHECK(std::equal(sides.begin(), sides.end(), expected.begin(), expected.end()));
    labels.insert(text_of(f.labelling.d1(), f.labelling.d2()));
  }
  return labels;
}

// The numbers of the pair in the file, as " A B".
std::string pair_in(const mesh::Region& region) {
  std::string text;
  for (const mesh::VertexId v : mesh::irregular_vertices(region.mesh)) text += " " + std::to_string(v.index() + 1);
  return text;
}

nlohmann::json json_of(const std::string& arguments) {
  const Outcome outcome = call("edit", arguments + " --json -");
  INFO(arguments << "\n" << outcome.err);
  REQUIRE(outcome.code == 0);
  return nlohmann::json::parse(outcome.out);
}

// What --json says of a move, compared with the meshes before and after it. Vertices are numbered from 1.
void check_details(const nlohmann::json& move, const mesh::QuadMesh& before, const mesh::QuadMesh& after) {
  CHECK(text_of(move["from"]["d1"], move["from"]["d2"]) + " becomes " + text_of(move["to"]["d1"], move["to"]["d2"]) ==
        move["effect"]);
  const int made = move["faces_made"], deleted = move["faces_deleted"], gained = move["faces"];
  CHECK(made - deleted == gained);
  CHECK(after.face_count() - before.face_count() == gained);
  const auto valence = [](const mesh::QuadMesh& m, const nlohmann::json& number) {
    return m.valence(mesh::VertexId(number.get<int>() - 1));
  };
  std::set<int> numbers;
  for (const nlohmann::json& vertex : move["vertices"]) {
    numbers.insert(vertex["after"].get<int>());
    const int was = valence(before, vertex["before"]), is = valence(after, vertex["after"]);
    CHECK((is == was || is == 2 || is == 6));  // merged, if it is another one
  }
  std::set<int> irregular;
  for (const mesh::VertexId v : mesh::irregular_vertices(after)) irregular.insert(v.index() + 1);
  CHECK(numbers == irregular);
}

}  // namespace

TEST_CASE("requad-edit moves and move print the d1 and d2 of the side-length equations", "[programs]") {
  for (const Sample& sample : samples()) {
    theory::Configuration c;
    c.parameters = sample.parameters;
    spill(scratch() / "pair.obj", mesh::obj_text(enumerate::glue_region(sample.type, c)));
    const mesh::Region before = region_in("pair.obj");
    const std::string label = text_of(c.d1(), c.d2());
    INFO(sample.type.name() << " " << label);
    CHECK(labels_of(before, sample.type) == std::set{label});

    int legal = 0;
    const nlohmann::json listing = json_of("moves pair.obj" + pair_in(before));
    std::set<std::string> names;
    for (const nlohmann::json& move : listing["moves"]) {
      CHECK(names.insert(move["name"]).second);
      if (!move["legal"].get<bool>()) continue;
      ++legal;
      const std::string effect = move["effect"], name = move["name"];
      INFO(name << ": " << effect);
      const std::string separator = " becomes ";
      const std::size_t at = effect.find(separator);
      REQUIRE(at != std::string::npos);
      CHECK(effect.substr(0, at) == label);
      const nlohmann::json made =
          json_of("move pair.obj" + pair_in(before) + " --step " + name + " --smooth 0 -o moved.obj");
      CHECK(made["effect"] == effect);
      const mesh::Region after = region_in("moved.obj");
      CHECK(labels_of(after, sample.type).count(effect.substr(at + separator.size())) == 1);
      check_details(move, before.mesh, after.mesh);
    }
    CHECK(legal >= 1);
  }
}

TEST_CASE("requad-edit align and merge print the d1 and d2 of the side-length equations", "[programs]") {
  int aligned = 0;
  for (const Sample& sample : samples()) {
    if (sample.type == theory::kQuad) continue;
    theory::Configuration c;
    c.parameters = sample.parameters;
    spill(scratch() / "pair.obj", mesh::obj_text(enumerate::glue_region(sample.type, c)));
    INFO(sample.type.name() << " " << text_of(c.d1(), c.d2()));
    const std::string pair = pair_in(region_in("pair.obj"));
    const nlohmann::json result = json_of("align pair.obj" + pair + " --smooth 0 --allow-inverted -o aligned.obj");
    const std::string label = text_of(result["d1"], result["d2"]);
    INFO(label);
    CHECK(labels_of(region_in("aligned.obj"), sample.type).count(label) == 1);
    ++aligned;
    if ((c.d1() + c.d2()) % 2 != 0) continue;
    const nlohmann::json merged = json_of("merge pair.obj" + pair + " --smooth 0 --allow-inverted -o merged.obj");
    CHECK(text_of(merged["d1"], merged["d2"]) == "(0,0)");
    CHECK(labels_of(region_in("merged.obj"), sample.type) == std::set<std::string>{"(0,0)"});
  }
  CHECK(aligned == 6);
}
