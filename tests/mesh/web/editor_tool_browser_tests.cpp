// The editor in a browser: features, third vertices, smoothing, reducing, colours, animation, pictures, scripts and links.
// And what it costs, counted in bytes where it can be.
#include <algorithm>
#include <filesystem>
#include <sstream>

#include "mesh/web/paint.hpp"
#include "tests/mesh/web/editing_in_browser.hpp"
#include "tests/support/catch.hpp"

using namespace requad;
using namespace requad::tests;
using nlohmann::json;
using web::Session;

namespace {

std::string saved(const std::string& name) {
  const std::filesystem::path path = scratch() / name;
  for (int i = 0; i < 400 && !std::filesystem::exists(path); ++i) shell("sleep 0.05");
  return slurp(path);
}

}  // namespace

TEST_CASE("in a browser, features are taken by angle and by hand, and edits keep them", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  editing.open(example_mesh("figure-17"));
  const std::string untouched = editing.exported("obj");
  editing.set("angle", "40");
  const mesh::FeatureEdges sharp = editing.native->sharp(40);
  REQUIRE(sharp.size() > 10);
  REQUIRE(editing.native->set_features(sharp).empty());
  CHECK(editing.evaluate("editor.state.status.features") == sharp.size());
  CHECK(editing.evaluate("editor.state.features.length") == sharp.size());
  CHECK(editing.text("features-text") == std::to_string(sharp.size()) + " feature edges");
  // What is offered keeps them; a refusal says so, and what helps.
  const auto [a, b] = sharp.front();
  editing.choose(std::to_string(editing.native->number(a)) + " " + std::to_string(editing.native->number(b)));
  editing.evaluate("choose({kind: 'edge', a: " + std::to_string(a.index()) + ", b: " + std::to_string(b.index()) +
                   "})");
  editing.check_offers();
  CHECK(editing.text("refused").find("a feature edge would go. What helps: ") != std::string::npos);
  const json chosen = editing.selection();
  editing.browser.click(
      "[...document.querySelectorAll('#offers button')].find((b) => b.dataset.name === 'make it no feature')");
  editing.settle();
  editing.follow(chosen, "make it no feature");
  CHECK(editing.evaluate("editor.state.status.features") == sharp.size() - 1);
  editing.press("no-features");
  CHECK(editing.evaluate("editor.state.status.features") == 0);
  for (int i = 0; i < 3; ++i) editing.press("undo");
  CHECK(editing.evaluate("editor.state.status.features") == 0);
  editing.press("redo");
  CHECK(editing.evaluate("editor.state.status.features") == sharp.size());
  CHECK(editing.exported("obj") == untouched);
  CHECK(editing.browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, third vertices of a cancellation are shown and exchanged", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  editing.open(example_mesh("figure-17"));
  editing.choose("153 163");
  editing.check_offers();
  const json usual = editing.evaluate("helpers()");
  REQUIRE(usual.size() > 1);
  CHECK(editing.evaluate("document.querySelectorAll('#helper-list button').length") == usual.size());
  // One is chosen in place of the nearest ones, and another one beside it.
  editing.browser.click("document.getElementById('helpers-text')");
  editing.press("helping");
  editing.evaluate("chooseVertex(" + usual[1].dump() + ", false)");
  CHECK(editing.evaluate("helpers()") == json::array({usual[1]}));
  editing.check_offers();
  editing.evaluate("chooseVertex(" + usual[0].dump() + ", false)");
  CHECK(editing.evaluate("helpers()").size() == 2);
  editing.check_offers();
  editing.browser.click("document.querySelector('#helper-list button')");
  editing.settle();
  CHECK(editing.evaluate("helpers()") == json::array({usual[0]}));
  editing.check_offers();
  const json chosen = editing.selection();
  editing.browser.click("[...document.querySelectorAll('#offers button')].find((b) => b.dataset.name === 'cancel')");
  editing.settle();
  editing.follow(chosen, "cancel");
  CHECK(editing.browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, a mesh is smoothed and reduced, and the slider goes back", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  Browser& browser = editing.browser;
  editing.open(busy_mesh());
  const std::string untouched = editing.exported("obj");
  editing.press("smooth-all");
  REQUIRE(editing.native->smooth({}, 0).empty());
  editing.check_mesh();
  editing.choose("93");
  editing.press("smooth-near");
  const mesh::VertexId centre = editing.native->numbered(93);
  REQUIRE(editing.native->smooth(std::array{centre}, 3).empty());
  editing.check_mesh();
  const int before = editing.evaluate("editor.state.status.irregular.length");
  // By one; then all of it; what the topology needs is left.
  editing.set("deviation", "0");
  editing.press("reduce-one");
  REQUIRE(browser.wait("editor.state.status.done === 3 && document.getElementById('reduce-one').disabled === false"));
  const int after_one = editing.evaluate("editor.state.status.irregular.length");
  CHECK(after_one < before);
  editing.press("reduce");
  REQUIRE(browser.wait("document.getElementById('reduce-text').textContent.includes(' left')"));
  editing.settle();
  CHECK(editing.evaluate("editor.state.status.irregular.length") == editing.evaluate("editor.state.status.least"));
  const int steps = editing.evaluate("editor.state.status.done");
  CHECK(steps > 4);
  // The same in this process.
  editing.native->start_reduction(0, -1);
  while (editing.native->reduce() != Session::Slice::ended) {
  }
  editing.native->finish_reduction();
  editing.check_mesh();
  CHECK(static_cast<int>(editing.native->steps().size()) == steps);
  const std::string reduced = editing.exported("obj");
  editing.set("time", "3");
  CHECK(editing.evaluate("editor.state.status.irregular.length") == after_one);
  editing.set("time", "0");
  CHECK(editing.exported("obj") == untouched);
  editing.set("time", std::to_string(steps));
  CHECK(editing.exported("obj") == reduced);
  CHECK(browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, a reduction is stopped, and its script is that of requad-edit", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  Browser& browser = editing.browser;
  const std::string path = busy_mesh();
  editing.open(path);
  const int before = editing.evaluate("editor.state.status.irregular.length");
  editing.set("deviation", "0");
  // As soon as one is cancelled, whatever the speed of the machine.
  editing.evaluate(
      "(() => { const ask = editor.library.ask.bind(editor.library); editor.library.ask = (what, more) => {"
      " const answer = ask(what, more); if (answer === 'cancelled') {"
      " window.shown = !document.getElementById('reduce-progress').hidden; "
      "document.getElementById('reduce-stop').click(); }"
      " return answer; }; })()");
  editing.press("reduce");
  REQUIRE(browser.wait("document.getElementById('reduce-text').textContent.includes(' left')"));
  const int after = editing.evaluate("editor.state.status.irregular.length");
  CHECK(after < before);
  CHECK(after > 8);
  CHECK(editing.evaluate("window.shown") == true);
  spill(scratch() / "reduced.txt", editing.exported("script"));
  REQUIRE(call("edit", "apply busy.obj reduced.txt -o reduced.obj --force").code == 0);
  CHECK(slurp(scratch() / "reduced.obj") == editing.exported("obj"));
  CHECK(browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, colours, pictures, scripts and links are what the mesh is", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  Browser& browser = editing.browser;
  browser.save_to(scratch().string());
  editing.take_example("figure-17.obj");
  for (const auto& [name, paint] :
       {std::pair("quality", web::Paint::quality), std::pair("checkerboard", web::Paint::checkerboard),
        std::pair("stripes", web::Paint::stripes), std::pair("plain", web::Paint::plain)}) {
    CAPTURE(name);
    editing.set("paint", name);
    const json shown = editing.evaluate(
        "Array.from({length: editor.state.status.quads}, (_, f) => editor.view.corners.array[28 * f + 6])");
    const std::vector<float> expected = web::paint_all(editing.native->mesh(), editing.native->positions(), paint);
    REQUIRE(shown.size() == expected.size());
    int different = 0;
    for (std::size_t f = 0; f < expected.size(); ++f)
      different += std::abs(shown[f].get<double>() - static_cast<double>(expected[f])) > 1e-6 ? 1 : 0;
    CHECK(different == 0);
  }
  editing.choose("153 163");
  const json chosen = editing.selection();
  browser.press("1");
  editing.settle();
  editing.follow(chosen, editing.native->offers(native_selection(chosen)).list.front().name);
  const std::string edited = editing.exported("obj"), script = editing.exported("script");
  // A picture is a PNG of the canvas's size.
  browser.click("document.getElementById('export-png')");
  const std::string png = saved("figure-17.png");
  CHECK(png.substr(1, 3) == "PNG");
  const auto size_at = [&png](std::size_t i) {
    return (static_cast<unsigned char>(png.at(i)) << 8) + static_cast<unsigned char>(png.at(i + 1));
  };
  CHECK(editing.evaluate("document.getElementById('canvas').width") == size_at(18));
  CHECK(editing.evaluate("document.getElementById('canvas').height") == size_at(22));
  // A link opens the example, makes the edits again and chooses the same vertices.
  const json numbers = editing.evaluate("editor.state.subject.vertices.map((v) => v.number)");
  REQUIRE(numbers.size() == 2);
  editing.press("export-link");
  REQUIRE(browser.wait("location.hash.length > 100"));
  const std::string hash = editing.evaluate("location.hash.slice(1)");
  browser.open(page->page, hash);
  REQUIRE(browser.wait("window.editor && editor.state.name === 'figure-17.obj' && editor.state.status.done === 1"));
  CHECK(editing.exported("obj") == edited);
  CHECK(editing.exported("script") == script);
  CHECK(editing.evaluate("editor.state.subject.vertices.map((v) => v.number)") == numbers);
  // So does a script that is dropped on the mesh; on another mesh it is refused.
  editing.press("undo");
  spill(scratch() / "edits.txt", script);
  browser.drop_file((scratch() / "edits.txt").string(), 300, 300);
  REQUIRE(browser.wait("editor.state.status.done === 1"));
  CHECK(editing.exported("obj") == edited);
  editing.open(example_mesh("figure-16"));
  browser.drop_file((scratch() / "edits.txt").string(), 300, 300);
  REQUIRE(browser.wait("!document.getElementById('error').hidden"));
  CHECK(editing.text("error").find("edits.txt: ") == 0);
  browser.open(page->page, "figure-17.obj,nonsense");
  REQUIRE(browser.wait("window.editor && !document.getElementById('error').hidden"));
  CHECK(editing.text("error").find("The link is broken") == 0);
  CHECK(browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, edits move the mesh unless that is switched off", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  editing.browser.set_reduced_motion(true);
  editing.browser.open(page->page);
  REQUIRE(editing.browser.wait("window.editor"));
  CHECK(editing.evaluate("document.getElementById('animate').checked") == false);
  editing.open(example_mesh("figure-17"));
  editing.choose("153 163");
  const std::string press =
      "(() => { const v = editor.view; document.querySelector('#offers button').click();"
      " return [Boolean(v.playing), v.playing ? v.playing.frames.length : 0]; })()";
  CHECK(editing.evaluate(press) == json::array({false, 0}));
  const json still = editing.evaluate("Array.from(editor.view.corners.array)");
  editing.press("undo");
  editing.evaluate("document.getElementById('animate').checked = true");
  editing.choose("153 163");
  // A frame for each operation, and one in which the mesh comes to rest. In the end the mesh is the same.
  const json played = editing.evaluate(press);
  CHECK(played[0] == true);
  CHECK(played[1] == editing.evaluate("editor.state.history[0].lines.length + 1"));
  editing.settle();
  CHECK(editing.evaluate("Array.from(editor.view.corners.array)") == still);
  // An edit ends what is played.
  editing.evaluate("goTo(0)");
  CHECK(editing.evaluate("Boolean(editor.view.playing)") == true);
  editing.evaluate("goTo(1)");
  editing.settle();
  CHECK(editing.evaluate("Array.from(editor.view.corners.array)") == still);
  CHECK(editing.browser.complaints() == std::vector<std::string>{});
}

TEST_CASE("in a browser, the meshes of Figures 16, 17 and 18 are repaired by clicks", "[editor][browser]") {
  const auto page = editor_page();
  if (!page) return;
  Editing editing(*page);
  editing.evaluate("document.getElementById('animate').checked = false");
  // Chooses the vertices, and clicks the button of the edit. Third vertices are chosen by clicks on their marks.
  const auto repair = [&](const std::string& numbers, const std::vector<int>& helpers, const std::string& name) {
    CAPTURE(numbers, name);
    editing.choose(numbers);
    if (!helpers.empty()) {
      editing.evaluate("document.getElementById('helpers').open = true");
      editing.press("helping");
      editing.press("closer");
    }
    for (const int helper : helpers) {
      editing.click_point(Editing::at(helper));
    }
    const json chosen = editing.selection();
    CHECK(chosen.value("helpers", json::array()).size() == helpers.size());
    editing.browser.click("[...document.querySelectorAll('#offers button')].find((b) => b.dataset.name === '" + name +
                          "')");
    editing.settle();
    REQUIRE(editing.evaluate("editor.state.status.done") == editing.native->steps().size() + 1);
    editing.follow(chosen, name);
  };
  const auto irregular = [&] { return editing.evaluate("editor.state.status.valences"); };
  const auto take_features = [&] {
    editing.set("angle", "40");
    REQUIRE(editing.native->set_features(editing.native->sharp(40)).empty());
  };
  editing.take_example("figure-16.obj");
  CHECK(irregular() == json{{"3", 9}, {"5", 1}});
  repair("389", {}, "move-v3 collapse left from 389 to 99");
  repair("388 97", {93, 91}, "cancel");
  CHECK(irregular() == json{{"3", 8}});
  editing.take_example("figure-17.obj");
  take_features();
  repair("366", {}, "move-v3 flip left from 366 to 149");
  repair("148 195", {153, 163}, "cancel");
  CHECK(irregular() == json{{"3", 8}});
  editing.take_example("figure-18.obj");
  CHECK(editing.evaluate("editor.state.status.inverted") == 1);
  CHECK(editing.text("facts").find("Inverted quads: 1.") != std::string::npos);
  take_features();
  repair("222 360", {}, "from 360 to 350");
  CHECK(editing.evaluate("editor.state.status.inverted") == 0);
  CHECK(editing.browser.complaints() == std::vector<std::string>{});
}
