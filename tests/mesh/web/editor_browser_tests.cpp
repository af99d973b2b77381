// The editor in a browser: the page requad-editor.html, opened as a file, operated by real keys, mouse, touch and
// dropped files: opening, choosing, editing, saving. editor_tool_browser_tests.cpp has the rest.
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "tests/mesh/web/editing_in_browser.hpp"
#include "tests/support/catch.hpp"

using namespace requad;
using namespace requad::tests;
using nlohmann::json;
using web::Session;

TEST_CASE("in a browser, the editor opens files in three ways and says why not", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  Browser& browser = editing.browser;
  CHECK(editing.text("welcome").find("drop one here") != std::string::npos);
  // An example, by the keyboard.
  browser.evaluate("document.getElementById('examples').focus()");
  browser.press("ArrowDown");
  browser.press("Enter");
  CHECK(browser.wait("editor.state.name === 'figure-16.obj'"));
  CHECK(editing.exported("obj") ==
        Session(Session::read(slurp(example_mesh("figure-16")), "figure-16.obj", false)).export_obj());
  // A file by the dialog; a file that is dropped.
  editing.open(example_mesh("figure-17"));
  CHECK(editing.text("facts").find("366 vertices, 364 quads, genus 0") != std::string::npos);
  CHECK(editing.text("facts").find("9 v3, 1 v5 (10; the topology needs 8)") != std::string::npos);
  spill(scratch() / "quad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  browser.drop_file((scratch() / "quad.off").string(), 300, 300);
  CHECK(browser.wait("editor.state.name === 'quad.off'"));
  CHECK(editing.text("facts").find("1 quad, genus 0, 1 boundary loop") != std::string::npos);
  // Errors have name, line and reason, and the mesh that was open stays.
  spill(scratch() / "bad.obj", "v 0 0 0\nv 1 zero 0\n");
  browser.drop_file((scratch() / "bad.obj").string(), 300, 300);
  CHECK(browser.wait("document.getElementById('error').textContent === \"bad.obj:2: 'zero' is not a number\""));
  CHECK(editing.evaluate("editor.state.status.quads") == 1);
  // Other polygons are offered to be subdivided.
  spill(scratch() / "triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  browser.drop_file((scratch() / "triangle.obj").string(), 300, 300);
  CHECK(browser.wait("document.getElementById('question').open"));
  browser.click("document.getElementById('subdivide')");
  CHECK(browser.wait("editor.state.name === 'triangle.obj'"));
  CHECK(editing.evaluate("editor.state.status.quads") == 3);
  CHECK(browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, edits that are not saved are not lost by opening another mesh", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  const auto asks = [&] { return editing.evaluate("window.onbeforeunload !== null") == true; };
  editing.open(example_mesh("figure-17"));
  CHECK_FALSE(asks());
  editing.choose("153 163");
  editing.evaluate("document.getElementById('animate').checked = false");
  editing.browser.press("1");
  REQUIRE(editing.browser.wait("editor.state.status.done === 1"));
  CHECK(asks());
  const std::string edited = editing.exported("obj");
  editing.open(example_mesh("figure-16"));
  CHECK_FALSE(asks());
  CHECK(editing.text("back") == "Back to figure-17.obj with its 1 step");
  editing.press("back");
  CHECK(editing.exported("obj") == edited);
  CHECK(editing.evaluate("document.getElementById('back').hidden") == true);  // figure-16 had no edits
  CHECK(asks());
  editing.press("undo");
  CHECK_FALSE(asks());
  CHECK(editing.browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, of two markers that touch the one under the pointer is chosen", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  for (const bool phone : {false, true}) {
    Editing editing(*page, phone ? 390 : 1280, phone ? 844 : 900, phone);
    editing.open(example_mesh("figure-17"));
    int beside = 0;
    for (int turn = 0; turn < 6; ++turn) {
      editing.evaluate("void editor.view.turn(0.1, 0.05)");
      editing.settle();
      for (const auto& [one, other] : {std::pair(153, 163), std::pair(163, 153)}) {
        const auto at = editing.place(editing.at(one)), there = editing.place(editing.at(other));
        beside += std::hypot(at[0] - there[0], at[1] - there[1]) < 20 ? 1 : 0;
        editing.press("clear");
        editing.click_point(editing.at(one));
        CHECK(editing.text("subject").find("Vertex " + std::to_string(one) + " ") == 0);
      }
    }
    CHECK(beside > 0);
  }
}

TEST_CASE("in a browser, a pair is chosen by clicks, and an arrow shows and makes its move", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  Browser& browser = editing.browser;
  editing.open(example_mesh("figure-17"));
  const std::string untouched = editing.exported("obj");
  editing.click_point(editing.at(366));
  CHECK(editing.text("subject") == "Vertex 366 (v3).");
  editing.check_offers();
  editing.click_point(editing.at(163));
  CHECK(editing.text("subject") == "The pair 366 (v3) and 163 (v5).");
  editing.check_offers();
  browser.press("c");
  editing.settle();
  // Each arrow that can be hit tints what its move would change, and nothing else.
  const json legal = editing.evaluate("editor.state.legal");
  std::optional<std::size_t> hit;
  int hits = 0;
  for (std::size_t i = 0; i < legal.size(); ++i) {
    if (legal[i]["arrows"].empty()) continue;
    // The head of the arrow at the first vertex.
    const std::string tip = "editor.view.arrows.children.find((a) => a.userData.tag === " + std::to_string(i) +
                            ").children[1].getWorldPosition(new THREE.Vector3()).toArray()";
    const auto [x, y] = editing.place(tip);
    browser.hover(x, y);
    if (!browser.wait("editor.state.shown && editor.state.shown === editor.state.legal[" + std::to_string(i) + "]", 5))
      continue;
    // One after which there is still a pair.
    const json& after = legal[i]["after"];
    if (after[0] >= 0 && after[1] >= 0 && after[0] != after[1]) hit = i;
    ++hits;
    editing.settle();
    json tinted = editing.evaluate("editor.view.tinted.filter((f) => editor.view.tint.array[4 * f] === 3)");
    std::sort(tinted.begin(), tinted.end());
    CHECK(tinted == legal[i]["quads"]);
  }
  REQUIRE(hits >= 3);
  REQUIRE(hit);
  // A click on an arrow makes the move.
  const json chosen = editing.selection();
  const auto [x, y] =
      editing.place("editor.view.arrows.children.find((a) => a.userData.tag === " + std::to_string(*hit) +
                    ").children[1].getWorldPosition(new THREE.Vector3()).toArray()");
  browser.click_at(x, y);
  editing.settle();
  REQUIRE(editing.evaluate("editor.state.status.done") == 1);
  editing.follow(chosen, legal[*hit]["name"]);
  // The pair is chosen where it is now, and goes on by a button.
  REQUIRE(editing.selection()["kind"] == "pair");
  editing.check_offers();
  const json second = editing.selection();
  const std::string name = editing.evaluate("editor.state.legal[0].name");
  browser.click("document.querySelector('#offers button')");
  REQUIRE(browser.wait("editor.state.status.done === 2"));
  editing.follow(second, name);
  // Undone to the byte, by the button and by the key; redone; a step of the history.
  const std::string edited = editing.exported("obj");
  browser.click("document.getElementById('undo')");
  browser.press("Control+z");
  CHECK(editing.exported("obj") == untouched);
  CHECK(editing.evaluate("document.getElementById('undo').disabled") == true);
  browser.press("Control+y");
  browser.click("document.getElementById('redo')");
  CHECK(editing.exported("obj") == edited);
  browser.click("document.querySelectorAll('#history button')[0]");
  CHECK(editing.exported("obj") == untouched);
  CHECK(editing.evaluate("document.querySelectorAll('#history .undone').length") == 2);
  browser.click("document.querySelectorAll('#history button')[2]");
  CHECK(editing.exported("obj") == edited);
  CHECK(browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, files are saved that the programs accept", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  Browser& browser = editing.browser;
  browser.save_to(scratch().string());
  const std::string input = example_mesh("figure-16");
  editing.open(input);
  // An edit of each kind of selection.
  for (const std::string numbers : {"93 91", "389"}) {
    editing.choose(numbers);
    editing.check_offers();
    const json chosen = editing.selection();
    const std::string name = editing.evaluate("editor.state.legal[0].name");
    browser.click("document.querySelector('#offers button')");
    editing.settle();
    editing.follow(chosen, name);
  }
  browser.press("Escape");
  CHECK(editing.selection().is_null());
  browser.press("0");
  editing.settle();
  // An edge and a quad, by their middles.
  for (const std::string weights : {"[0.5, 0.5, 0, 0]", "[0.25, 0.25, 0.25, 0.25]"}) {
    editing.click_point(
        "(() => { const all = editor.library.corners(editor.view.capacity); let best = null, most = -2;"
        " for (let f = 0; f < editor.state.status.quads; ++f) {"
        "  const toward = editor.view.camera.position.clone().sub(editor.view.centre).normalize();"
        "  const n = all.subarray(28 * f + 3, 28 * f + 6), dot = n[0] * toward.x + n[1] * toward.y + n[2] * toward.z;"
        "  if (dot > most) { most = dot; best = f; } }"
        " const p = [0, 0, 0]; " +
        weights +
        ".forEach((w, k) => { for (let i = 0; i < 3; ++i)"
        " p[i] += w * all[28 * best + 7 * k + i]; }); return p; })()");
    CHECK(editing.selection()["kind"] == (weights == "[0.5, 0.5, 0, 0]" ? "edge" : "quad"));
    editing.check_offers();
    const json chosen = editing.selection();
    const std::string name = editing.evaluate("editor.state.legal[0].name");
    browser.press("1");
    editing.settle();
    editing.follow(chosen, name);
  }
  browser.click("document.getElementById('export-obj')");
  browser.click("document.getElementById('export-script')");
  const auto saved = [](const std::string& name) {
    const std::filesystem::path path = scratch() / name;
    for (int i = 0; i < 100 && !std::filesystem::exists(path); ++i) shell("sleep 0.05");
    return slurp(path);
  };
  const std::string mesh_file = saved("figure-16-edited.obj"), script = saved("figure-16-edits.txt");
  CHECK(mesh_file == editing.exported("obj"));
  CHECK(script == editing.exported("script"));
  REQUIRE(call("edit", "apply " + input + " figure-16-edits.txt -o replayed.obj --force").code == 0);
  CHECK(slurp(scratch() / "replayed.obj") == mesh_file);
  CHECK(browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, the keyboard keeps its place, and the pair is chosen again after an undo",
          "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  Browser& browser = editing.browser;
  editing.open(example_mesh("figure-17"));
  const auto focused = [&](const std::string& what) {
    return editing.evaluate("document.activeElement." + what).get<std::string>();
  };
  editing.choose("153 163");
  const json pair = editing.selection();
  // A third vertex is added by its number.
  const json usual = editing.evaluate("helpers()");
  editing.evaluate("document.getElementById('helpers').open = true");
  editing.press("helping");
  CHECK(editing.text("live").find("enter the number of one") != std::string::npos);
  editing.choose(editing.evaluate("editor.library.ask('name', {vertex: " + usual[0].dump() + "}).split(' ')[0]"));
  CHECK(editing.evaluate("helpers()") == json::array({usual[0]}));
  editing.choose("1");  // no irregular vertex
  CHECK(editing.evaluate("helpers()") == json::array({usual[0]}));
  browser.press("Tab");
  browser.press("Escape");  // ends the choice of third vertices only
  CHECK(editing.evaluate("editor.state.helping") == false);
  CHECK(editing.selection()["b"] == pair["b"]);
  // An edit by Enter, and its undo.
  editing.choose("153 163");
  editing.evaluate("document.querySelector('#offers button').focus()");
  browser.press("Tab");
  const std::string name = editing.evaluate("document.activeElement.dataset.name");
  const json chosen = editing.selection();
  browser.press("Enter");
  editing.settle();
  REQUIRE(editing.evaluate("editor.state.status.done") == 1);
  editing.follow(chosen, name);
  CHECK(focused("tagName") == "BUTTON");
  browser.press("Control+z");
  editing.settle();
  CHECK(editing.evaluate("editor.state.status.done") == 0);
  CHECK(editing.selection() == chosen);
  CHECK(focused("tagName") != "BODY");
  // A reduction that is stopped before it cancels anything loses nothing.
  CHECK(editing.evaluate("editor.state.history.length") == 1);
  editing.evaluate("reduce(false), leave()");  // a reduction of this mesh may end between two calls
  REQUIRE(browser.wait("document.getElementById('reduce-text').textContent.includes('stopped')"));
  editing.settle();
  if (editing.evaluate("editor.state.status.done") == 0) CHECK(editing.evaluate("editor.state.history.length") == 1);
  CHECK(browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, the keyboard suffices to edit", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  Browser& browser = editing.browser;
  editing.open(example_mesh("figure-17"));
  const std::string untouched = editing.exported("obj");
  browser.press("?");
  CHECK(editing.evaluate("document.getElementById('help').open") == true);
  browser.press("Escape");
  browser.press("n");
  CHECK(editing.selection()["kind"] == "vertex");
  CHECK(editing.text("live").find("Vertex ") != std::string::npos);
  const json first = editing.selection();
  browser.press("n");
  CHECK(editing.selection() != first);
  browser.press("p");
  CHECK(editing.selection() == first);
  browser.press("m");
  REQUIRE(editing.selection()["kind"] == "pair");
  editing.check_offers();
  const json partner = editing.selection();
  browser.press("m");
  CHECK(editing.selection() != partner);
  CHECK(editing.selection()["a"] == partner["a"]);
  editing.check_offers();
  // The chosen ones are turned into view.
  editing.settle();
  CHECK(editing.evaluate("editor.state.subject.vertices.every((v) => editor.view.inside(editor.view.project(v.at)))") ==
        true);
  REQUIRE(editing.evaluate("editor.state.legal.length").get<int>() > 0);
  const json chosen = editing.selection();
  const std::string name = editing.evaluate("editor.state.legal[0].name");
  browser.press("1");
  REQUIRE(editing.evaluate("editor.state.status.done") == 1);
  editing.follow(chosen, name);
  CHECK(editing.text("live").find("Done: " + name) != std::string::npos);
  browser.press("u");
  CHECK(editing.exported("obj") == untouched);
  browser.press("r");
  editing.check_mesh();
  // Arrow keys turn the mesh when it has the focus.
  browser.evaluate("document.getElementById('canvas').focus()");
  const json before = editing.evaluate("editor.view.camera.position.toArray()");
  browser.press("ArrowLeft");
  CHECK(editing.evaluate("editor.view.camera.position.toArray()") != before);
  browser.press("0");
  // Tab reaches every control, and the focus is visible.
  browser.evaluate("document.activeElement.blur()");
  std::set<std::string> met;
  int rounds = 0;
  for (int i = 0; i < 160; ++i) {
    browser.press("Tab");
    const json here = editing.evaluate(
        "(() => { const e = document.activeElement, shown = e.closest('.button') || e; return [e.id || e.tagName,"
        " getComputedStyle(shown).outlineStyle, Boolean(e.getAttribute('aria-label') || (e.labels && e.labels.length) "
        "||"
        " e.textContent.trim())]; })()");
    if (here[0] == "BODY" && ++rounds == 2) break;
    if (here[0] == "BODY") continue;
    CAPTURE(here[0]);
    CHECK(here[1] != "none");
    CHECK(here[2] == true);
    met.insert(here[0].get<std::string>());
  }
  for (const char* id : {"file",
                         "examples",
                         "undo",
                         "export-obj",
                         "export-script",
                         "export-png",
                         "help-open",
                         "canvas",
                         "show-separatrices",
                         "paint",
                         "animate",
                         "smooth-all",
                         "angle",
                         "until",
                         "reduce",
                         "time",
                         "show-alpha",
                         "reset-view",
                         "previous-vertex",
                         "next-vertex",
                         "number",
                         "choose"}) {
    CAPTURE(id);
    CHECK(met.count(id) == 1);
  }
  CHECK(browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, what cannot be done is said in words", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  Browser& browser = editing.browser;
  editing.open(example_mesh("figure-17"));
  editing.choose("366");
  CHECK(editing.text("offers-note").find("Theorem 7.1") != std::string::npos);
  editing.choose("1 2");
  CHECK(editing.text("offers-note").find("the vertices do not have the valences that this needs") != std::string::npos);
  CHECK(editing.text("offers-note").find("Choose two irregular vertices") != std::string::npos);
  editing.choose("9999");
  CHECK(editing.text("error") ==
        "There is no such vertex or pair: '9999'; expected a number from 1 to 366, or two different ones.");
  editing.choose("153 366");
  editing.check_offers();
  CHECK(editing.evaluate("document.getElementById('error').hidden") == true);
  CHECK(browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, the editor fits a telephone, by touch, in the light and in the dark", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page, 390, 844, true);
  Browser& browser = editing.browser;
  editing.open(example_mesh("figure-17"));
  for (const bool dark : {false, true}) {
    browser.set_dark(dark);
    CHECK(editing.evaluate("document.documentElement.scrollWidth") <= 390);
    CHECK(editing.evaluate("[...document.querySelectorAll('button, select, .button')].filter((b) => b.offsetParent &&"
                           " b.getClientRects().length && (b.offsetHeight < 44 || b.offsetWidth < 44)).length") == 0);
  }
  CHECK(browser.wait("editor.view.renderer.getClearColor().getHexString() === '0d1116'"));
  editing.click_point(editing.at(153));
  REQUIRE(editing.selection().is_object());
  editing.click_point(editing.at(366));
  REQUIRE(editing.selection()["kind"] == "pair");
  editing.check_offers();
  const json chosen = editing.selection();
  const std::string name = editing.evaluate("editor.state.legal[1].name");
  // The first tap shows what the edit would change, and the second makes it.
  const auto tap = [&](int offer) {
    browser.click("document.querySelector('#offers li:nth-child(" + std::to_string(offer) + ") button')");
  };
  for (const int offer : {2, 1, 2}) {
    tap(offer);
    REQUIRE(browser.wait("editor.state.shown !== null && editor.state.shown === editor.state.tapped"));
    CHECK(editing.evaluate("editor.state.status.done") == 0);
    CHECK(editing.evaluate("editor.view.tinted.length").get<int>() > 0);
    CHECK(editing.text("live").find("Tap again to do it.") != std::string::npos);
  }
  // The mesh, what it says and Undo are in view while the list is.
  CHECK(editing.evaluate("['frame', 'live', 'undo'].every((id) => { const box = document.getElementById(id)"
                         ".getBoundingClientRect(); return box.top >= 0 && box.bottom <= innerHeight; })") == true);
  tap(2);
  REQUIRE(browser.wait("editor.state.status.done === 1"));
  editing.follow(chosen, name);
  // A finger that stays half a second chooses any vertex as the second one; beside the mesh, a tap chooses nothing.
  editing.choose("153");
  editing.hold_point(editing.at(140));
  CHECK(editing.selection()["kind"] == "pair");
  const json canvas = editing.evaluate(
      "(() => { const b = document.getElementById('canvas').getBoundingClientRect(); return [b.x, b.y, b.bottom]; "
      "})()");
  const double left = canvas[0], top = canvas[1], bottom = canvas[2];
  browser.click_at(left + 8, bottom - 8);
  editing.settle();
  CHECK(editing.selection().is_null());
  // Two fingers that go down together move the mesh down by as much, and do not make it larger.
  const auto place = [&] { return editing.place(editing.at(1)); };
  const auto from = place(), other = editing.place(editing.at(366));
  browser.drag_fingers({{{left + 140, top + 100}, {left + 230, top + 100}}},
                       {{{left + 140, top + 160}, {left + 230, top + 160}}});
  editing.settle();
  CHECK(std::abs(place()[1] - from[1] - 60) < 12);
  CHECK(std::abs(place()[0] - from[0]) < 6);
  CHECK(std::abs((place()[1] - editing.place(editing.at(366))[1]) - (from[1] - other[1])) < 14);
  CHECK(browser.complaints() == std::vector<std::string>{});
}
