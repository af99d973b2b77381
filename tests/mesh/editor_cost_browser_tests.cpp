// What the editor's page costs. A test counts bytes, which are the same on every machine. Times are measured by the hidden
// test [editor-speed], which prints them: requad-mesh-tests "[editor-speed]".
#include <cmath>
#include <sstream>

#include "mesh/files/write_obj.hpp"
#include "tests/mesh/editing_in_browser.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mesh/meshes.hpp"

using namespace requad;
using namespace requad::tests;
using nlohmann::json;
using web::Selection;
using web::Session;

namespace {

// Writes a torus of quads in space with two v3s and two v5s that a flip makes, and returns the file's name.
std::string torus_file(int columns, int rows) {
  constexpr double kTurn = 2 * 3.14159265358979323846;
  const mesh::QuadMesh torus = tests::torus(columns, rows);
  mesh::Positions positions;
  for (int v = 0; v < torus.vertex_capacity(); ++v) {
    const double a = kTurn * (v % columns) / columns, b = kTurn * (v / columns) / rows;
    const double r = static_cast<double>(columns) / rows + std::cos(b);  // so that quads are nearly squares
    positions.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
  }
  Session session(Session::read(mesh::obj_text(torus, positions), "torus.obj", false));
  const Selection at{Selection::Kind::vertex, mesh::VertexId(10 * columns + 10), {}, {}};
  const web::Offers offers = session.offers(at);
  REQUIRE(offers.list.front().name.rfind("generate-3355", 0) == 0);
  REQUIRE(session.perform(at, offers.list.front().name).empty());
  const std::string name = "torus-" + std::to_string(columns * rows) + ".obj";
  spill(scratch() / name, session.export_obj());
  return (scratch() / name).string();
}

// Opens a file, and returns the milliseconds that it takes in the page.
double open_in_page(Editing& editing, const std::string& path) {
  editing.evaluate(
      "window.times = {}; (() => { const old = open; open = (...all) => { const t = performance.now(); old(...all);"
      " view.render(); times.open = performance.now() - t; }; })()");
  editing.browser.choose_file("#file", path);
  REQUIRE(editing.browser.wait("window.times.open"));
  editing.settle();
  return editing.evaluate("times.open");
}

// Chooses the first two irregular vertices and makes their first move. Returns the milliseconds of the preview, of the move
// and of a picture from elsewhere, and the bytes that the move uploads.
json move_in_page(Editing& editing) {
  return editing.evaluate(
      "(() => { const [a, b] = editor.state.status.irregular.map((v) => v.id); const result = {};"
      " let t = performance.now(); choose({kind: 'pair', a, b}); showEffect(editor.state.legal[0]); "
      "editor.view.render();"
      " result.preview = performance.now() - t; const before = editor.view.uploaded; t = performance.now();"
      " perform(editor.state.legal[0]); editor.view.render(); result.move = performance.now() - t;"
      " result.bytes = editor.view.uploaded - before; t = performance.now(); editor.view.turn(0.1, 0);"
      " editor.view.render(); result.turn = performance.now() - t; goTo(0); return result; })()");
}

// Moves a pair and undoes that, so many times. Returns the memory in the end.
json move_often(Editing& editing, int times) {
  return editing.evaluate(
      "(async () => { const [a, b] = editor.state.status.irregular.map((v) => v.id);"
      " for (let i = 0; i < " +
      std::to_string(times) +
      "; ++i) { choose({kind: 'pair', a, b}); perform(editor.state.legal[i % editor.state.legal.length]); goTo(0);"
      "  if (i % 20 === 0) await new Promise(requestAnimationFrame); }"
      " editor.view.render(); return {program: editor.library.module.HEAPU8.length,"
      "  geometries: editor.view.renderer.info.memory.geometries, history: editor.state.history.length}; })()");
}

}  // namespace

TEST_CASE("in a browser, a move uploads what it changes, however large the mesh is", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  editing.evaluate("document.getElementById('animate').checked = false");
  std::vector<json> uploaded;
  for (const auto& [columns, rows] : {std::pair(200, 50), std::pair(640, 160)}) {
    open_in_page(editing, torus_file(columns, rows));
    REQUIRE(editing.evaluate("editor.state.status.quads").get<int>() >= columns * rows);
    uploaded.push_back(move_in_page(editing)["bytes"]);
  }
  CHECK(uploaded[0] == uploaded[1]);
  CHECK(uploaded[0].get<int>() > 0);
  CHECK(uploaded[0].get<int>() < 100'000);
  // Nothing grows.
  editing.open(model("figure-17.obj"));
  const json after_some = move_often(editing, 20);
  CHECK(move_often(editing, 60) == after_some);
  CHECK(editing.browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, how fast the editor is", "[.][editor-speed]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  editing.evaluate("document.getElementById('animate').checked = false");
  std::ostringstream told;
  const auto measure = [&](const std::string& name, const std::string& path) {
    const double opened = open_in_page(editing, path);
    move_in_page(editing);  // the first one warms up
    const json move = move_in_page(editing);
    told << name << ": opens in " << opened << " ms; preview " << move["preview"] << " ms, move " << move["move"]
         << " ms, turn " << move["turn"] << " ms, " << move["bytes"] << " bytes uploaded by the move\n";
  };
  if (const auto spot = real_mesh("spot.obj")) measure("spot", *spot);
  measure("10k quads", torus_file(200, 50));
  measure("100k quads", torus_file(640, 160));
  editing.open(model("figure-17.obj"));
  told << "memory after 100 moves and undos: " << move_often(editing, 100).dump() << "\n";
  told << "after 1000 more: " << move_often(editing, 1000).dump() << "\n";
  WARN(told.str());
}
