// What the editor's page costs. A test counts bytes, which are the same on every machine. Times are measured by the hidden
// test [editor-speed], which prints them: requad-web-tests "[editor-speed]".
#include <cmath>
#include <filesystem>
#include <sstream>

#include "tests/mesh/web/editing_in_browser.hpp"
#include "tests/support/catch.hpp"

using namespace requad;
using namespace requad::tests;
using nlohmann::json;
using web::Selection;
using web::Session;

namespace {

// Writes a wavy sheet of quads with two v3s and two v5s, which a flip makes far from the boundary, and returns the path.
// Round these, sheets of all sizes are alike.
std::string sheet_file(int columns, int rows) {
  std::ostringstream text;
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x)
      text << "v " << x << ' ' << y << ' ' << 2 * std::sin(0.2 * x) * std::cos(0.2 * y) << '\n';
  }
  const int width = columns + 1;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const int v = y * width + x + 1;
      text << "f " << v << ' ' << v + 1 << ' ' << v + 1 + width << ' ' << v + width << '\n';
    }
  }
  Session session(Session::read(text.str(), "sheet.obj", false));
  const Selection at{Selection::Kind::vertex, mesh::VertexId(30 * width + 30), {}, {}};
  const web::Offers offers = session.offers(at);
  REQUIRE(offers.list.front().name.rfind("generate-3355", 0) == 0);
  REQUIRE(session.perform(at, offers.list.front().name).empty());
  const std::string name = "sheet-" + std::to_string(columns * rows) + ".obj";
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

// Chooses the first two irregular vertices and makes their first move. Returns the milliseconds of the preview, of the
// offers that take longer, of the move and of a picture from elsewhere, and the bytes that the move uploads.
json move_in_page(Editing& editing) {
  return editing.evaluate(
      "(() => { const [a, b] = editor.state.status.irregular.map((v) => v.id); const result = {};"
      " let t = performance.now(); choose({kind: 'pair', a, b}); showEffect(editor.state.legal[0]); "
      "editor.view.render();"
      " result.preview = performance.now() - t; t = performance.now(); takeOffers(); editor.view.render();"
      " result.others = performance.now() - t; const before = editor.view.uploaded; t = performance.now();"
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
  for (const auto& [columns, rows] : {std::pair(100, 100), std::pair(320, 320)}) {
    open_in_page(editing, sheet_file(columns, rows));
    REQUIRE(editing.evaluate("editor.state.status.quads").get<int>() >= columns * rows);
    uploaded.push_back(move_in_page(editing)["bytes"]);
  }
  CHECK(uploaded[0] == uploaded[1]);
  CHECK(uploaded[0].get<int>() > 0);
  CHECK(uploaded[0].get<int>() < 100'000);
  // Nothing grows.
  editing.open(example_mesh("figure-17"));
  const json after_some = move_often(editing, 20);
  CHECK(move_often(editing, 60) == after_some);
  CHECK(editing.browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, no shader is compiled anew when something else is chosen", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  editing.open(busy_mesh());
  const auto choose_all = [&] {
    return editing.evaluate(
        "(() => { const ids = editor.state.status.irregular.map((v) => v.id); let legal = 0;"
        " for (const id of ids.slice(1, 6)) { choose({kind: 'pair', a: ids[0], b: id}); takeOffers();"
        "  for (const offer of editor.state.legal) { showEffect(offer); editor.view.render(); ++legal; }"
        "  choose(vertexOf(id)); editor.view.render(); choose(null); editor.view.render(); } return legal; })()");
  };
  REQUIRE(choose_all().get<int>() > 5);
  editing.evaluate(
      "window.compiled = 0; (() => { const gl = editor.view.renderer.getContext(), compile = gl.compileShader.bind(gl);"
      " gl.compileShader = (shader) => { ++window.compiled; compile(shader); }; })()");
  choose_all();
  CHECK(editing.evaluate("window.compiled") == 0);
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
    told << name << ": opens in " << opened << " ms; preview " << move["preview"] << " ms, other offers "
         << move["others"] << " ms, move " << move["move"] << " ms, turn " << move["turn"] << " ms, " << move["bytes"]
         << " bytes uploaded by the move\n";
  };
  if (const auto spot = real_mesh("spot")) measure("spot", std::filesystem::canonical(*spot).string());
  measure("10k quads", sheet_file(100, 100));
  measure("100k quads", sheet_file(320, 320));
  editing.open(example_mesh("figure-17"));
  told << "memory after 100 moves and undos: " << move_often(editing, 100).dump() << "\n";
  told << "after 1000 more: " << move_often(editing, 1000).dump() << "\n";
  WARN(told.str());
}
