// Figures of meshes in space: their edits keep the shape and end where the paper's do, and their meshes are those of
// mesh/examples, which a script makes again.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "figures/panels/edit_sequence.hpp"
#include "figures/panels/space_panel.hpp"
#include "figures/pictures/catalogue.hpp"
#include "figures/pictures/examples.hpp"
#include "figures/pictures/paper_pictures.hpp"
#include "mesh/files/read_polygons.hpp"
#include "mesh/geometry/diagnosis.hpp"
#include "mesh/geometry/hausdorff_distance.hpp"
#include "mesh/pictures/page.hpp"
#include "mesh/topology/validate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"

using namespace requad;
using namespace requad::figures;

namespace {

std::vector<Words> words_of(const std::string& id) {
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.id != id) continue;
    Canvas canvas({}, 1);
    entry.make({}).paint(canvas);
    std::vector<Words> words;
    for (const Item& item : canvas.drawing().items) {
      if (const auto* w = std::get_if<Words>(&item)) words.push_back(*w);
    }
    return words;
  }
  throw std::logic_error("no figure " + id);
}

std::string text_of(const std::string& id) {
  std::string text;
  for (const Words& w : words_of(id)) text += w.text + " ";
  return text;
}

// What every edit of a figure has to keep.
void check_shape(const Stage& before, const Stage& after) {
  CHECK(mesh::validate(after.mesh).empty());
  CHECK(mesh::diagnose(after.mesh, after.positions).inverted <= mesh::diagnose(before.mesh, before.positions).inverted);
  const double diagonal = mesh::bounding_box_diagonal(before.mesh, before.positions);
  CHECK(mesh::hausdorff_distance({after.mesh, after.positions}, {before.mesh, before.positions}) < 0.02 * diagonal);
  for (const auto& [a, b] : before.features) {
    CHECK(after.mesh.adjacent(a, b));
    CHECK(after.positions[a.slot()] == before.positions[a.slot()]);
  }
}

std::filesystem::path example(const std::string& file) {
  return std::filesystem::path(REQUAD_SOURCE_DIR) / "mesh" / "examples" / file;
}

}  // namespace

TEST_CASE("the script of the examples makes Figures 1, 15 and 19 again", "[figures][examples]") {
  if (std::system("python3 --version >/dev/null 2>&1") != 0) {
    WARN("skipped: there is no python3");
    return;
  }
  const std::string made = tests::scratch().string();
  REQUIRE(std::system(("python3 '" + example("models").string() + "' '" + made + "'").c_str()) == 0);
  for (const std::string name : {"figure-1.obj", "figure-15.obj", "figure-19.obj"}) {
    INFO(name);
    const mesh::Surface now = mesh::read_surface(made + "/" + name, false);
    const mesh::Surface kept = mesh::read_surface(example(name).string(), false);
    CHECK(now.mesh == kept.mesh);
    REQUIRE(now.positions.size() == kept.positions.size());
    for (std::size_t i = 0; i < now.positions.size(); ++i)
      REQUIRE((now.positions[i] - kept.positions[i]).norm() <
              1e-4);  // mathematical functions differ in their last bits
  }
  CHECK(tests::slurp(example("figure-19.obj")) == examples::rabbit);
}

TEST_CASE("reductions in figures: what must stay is left, and the shape is kept", "[figures][examples]") {
  EditSequence roof(examples::roof);
  const Stage designed = roof.stage();
  CHECK(designed.irregular() == 183);
  CHECK(roof.reduce().empty());
  const Stage reduced = roof.stage();
  check_shape(designed, reduced);
  // By discrete Gauss-Bonnet: an annulus whose outer rim has four corners.
  CHECK(reduced.irregular() == 4);
  CHECK(reduced.count(5) == 4);

  EditSequence rabbit(examples::rabbit);
  const Stage start = rabbit.stage();
  const std::vector<Stage> stages = rabbit.reduce({200, 30, 1});
  REQUIRE(stages.size() == 2);  // one is never reached: eight v3s must stay on a sphere
  CHECK(stages[0].irregular() <= 200);
  CHECK(stages[0].irregular() > 150);
  CHECK(stages[1].irregular() <= 30);
  for (const Stage& stage : stages) check_shape(start, stage);
  check_shape(start, rabbit.stage());
  CHECK(rabbit.stage().irregular() == 8);
  CHECK(rabbit.stage().count(3) == 8);
}

TEST_CASE("Figure 15: a v12 is parted, and four v3s are left in aligned pairs", "[figures][examples]") {
  EditSequence edits(examples::dome);
  const Stage start = edits.stage();
  CHECK(start.count(12) == 1);
  CHECK(start.count(3) == 12);
  edits.part();
  // Parting keeps the sum of 4 - l(v), which is 4 in a disc without corners.
  CHECK(edits.stage().count(3) == 4 + edits.stage().count(5));
  CHECK(edits.stage().irregular() == edits.stage().count(3) + edits.stage().count(5));
  check_shape(start, edits.stage());
  edits.reduce();
  CHECK(edits.stage().irregular() == 4);
  CHECK(edits.stage().count(3) == 4);
  check_shape(start, edits.stage());
  CHECK(text_of("15").find("(3) aligned: 4 v3") != std::string::npos);
}

TEST_CASE("Figures 16-18 repair what the examples' script repairs", "[figures][examples]") {
  struct Case {
    const char* obj;
    double feature_angle;
    std::vector<int> irregular;  // before and after each step
    std::function<void(EditSequence&, int step)> edit;
  };
  const std::vector<Case> cases{
      {examples::rounded_block,
       0,
       {10, 12, 8},
       [](EditSequence& e, int step) {
         if (step == 1) e.make("move-v3 collapse left", e.vertex(389), e.vertex(99));
         if (step == 2) e.cancel(e.vertex(388), e.vertex(97), {e.vertex(93), e.vertex(91)});
       }},
      {examples::cylinder,
       40,
       {10, 12, 8},
       [](EditSequence& e, int step) {
         if (step == 1) e.make("move-v3 flip left", e.vertex(366), e.vertex(149));
         if (step == 2) e.cancel(e.vertex(148), e.vertex(195), {e.vertex(153), e.vertex(163)});
       }},
  };
  for (const Case& c : cases) {
    EditSequence edits(c.obj, c.feature_angle);
    const Stage start = edits.stage();
    for (int step = 0; step < 3; ++step) {
      c.edit(edits, step);
      CHECK(edits.stage().irregular() == c.irregular[static_cast<std::size_t>(step)]);
      check_shape(start, edits.stage());
    }
    CHECK(edits.stage().count(3) == 8);
  }
  EditSequence edits(examples::sharp_block, 40);
  const Stage start = edits.stage();
  const mesh::VertexId on_edge = edits.vertex(222);
  CHECK(start.mesh.valence(on_edge) == 3);
  edits.move("from 360 to 350", on_edge, edits.vertex(360));
  CHECK(edits.stage().mesh.valence(on_edge) == 4);
  check_shape(start, edits.stage());
  edits.reduce();
  CHECK(edits.stage().irregular() == 8);
  check_shape(start, edits.stage());
}

TEST_CASE("an edit of a figure that is refused is a mistake", "[figures][examples]") {
  EditSequence edits(examples::cylinder, 40);
  CHECK_THROWS_AS(edits.make("move-v3 flip left", edits.vertex(1), edits.vertex(2)), std::logic_error);
  CHECK_THROWS_AS(edits.move("nothing", edits.vertex(153), edits.vertex(163)), std::logic_error);
  CHECK_THROWS_AS(edits.cancel(edits.vertex(366), edits.vertex(153), {edits.vertex(163)}), std::logic_error);
}

TEST_CASE("Figure 9: each of three pairs has four pairs of arrows, numbered", "[figures]") {
  std::map<std::string, int> labels;
  for (const Words& w : words_of("9")) ++labels[w.text];
  for (const char* number : {"1", "2", "3", "4"}) CHECK(labels[number] == 3 * 2);
  CHECK(labels.size() == 4 + 3);
}

TEST_CASE("stages of a mesh that the user names, and curves", "[figures][programs]") {
  const auto call = [](const std::string& arguments) { return tests::call("figures", arguments); };
  const std::string dome = "'" + example("figure-15.obj").string() + "'";
  CHECK(call("--figure 19 --mesh " + dome + " --format svg -o named").code == 0);
  CHECK(std::filesystem::exists(tests::scratch() / "named" / "figure-19-figure-15.svg"));
  CHECK(call("--figure 18 --mesh " + dome).err.find("--mesh has no effect") != std::string::npos);
  CHECK(call("--figure 19 --mesh none.obj").code == 2);
  tests::spill(tests::scratch() / "triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(call("--figure 19 --mesh triangle.obj").err.find("triangle.obj") != std::string::npos);

  tests::spill(tests::scratch() / "curves.json", R"({"curves": {"one": [[0, 30], [0.01, 8]], "two": [[0, 20]]}})");
  const std::vector<Curve> curves = parse_curves(tests::slurp(tests::scratch() / "curves.json"));
  REQUIRE(curves.size() == 2);
  CHECK(curves[0].points == std::vector<Point>{{0, 30}, {0.01, 8}});
  CHECK(call("--figure deviation --curve curves.json --format svg --real-text -o curves.svg").code == 0);
  const std::string svg = tests::slurp(tests::scratch() / "curves.svg");
  CHECK(svg.find(">two<") != std::string::npos);
  tests::spill(tests::scratch() / "bad.json", R"({"curves": [1]})");
  for (const char* file : {"bad.json", "triangle.obj", "none.json"}) {
    const tests::Outcome outcome = call(std::string("--figure deviation --curve ") + file);
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find(file) != std::string::npos);
  }
}

TEST_CASE("the tables of bench/shape agree with what it measured", "[figures]") {
  if (std::system("python3 --version >/dev/null 2>&1") != 0) {
    WARN("skipped: there is no python3");
    return;
  }
  CHECK(std::system("python3 '" REQUAD_SOURCE_DIR "/bench/shape' --check") == 0);
}
