#include "tests/mesh/web/editing_in_browser.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "tests/support/catch.hpp"

namespace requad::tests {

using nlohmann::json;
using web::Selection;
using web::Session;

std::optional<EditorPage> editor_page() {
  const std::filesystem::path page = std::filesystem::path(REQUAD_PROGRAM_DIR) / "requad-editor.html";
  if (!std::filesystem::exists(page)) {
    if (std::getenv("REQUAD_REQUIRE_EDITOR") != nullptr)
      FAIL("requad-editor.html is not built, and REQUAD_REQUIRE_EDITOR is set");
    WARN("skipped: requad-editor.html is not built (-DREQUAD_WEB=ON)");
    return std::nullopt;
  }
  const auto program = chromium();
  if (!program) return std::nullopt;
  return EditorPage{page.string(), *program};
}

std::string busy_mesh() {
  const std::string input = example_mesh("figure-17");
  Session session(Session::read(slurp(input), input, false));
  for (const int number : {30, 120, 210, 300}) {
    const Selection at{Selection::Kind::vertex, session.numbered(number), {}, {}};
    const web::Offers offers = session.offers(at);
    const auto flip = std::find_if(offers.list.begin(), offers.list.end(), [](const web::Offer& o) {
      return o.is_legal() && o.name.rfind("generate-3355", 0) == 0;
    });
    REQUIRE(flip != offers.list.end());
    REQUIRE(session.perform(at, flip->name).empty());
  }
  spill(scratch() / "busy.obj", session.export_obj());
  return (scratch() / "busy.obj").string();
}

Selection native_selection(const json& s) {
  Selection selection;
  const std::string kind = s["kind"];
  selection.kind = kind == "vertex" ? Selection::Kind::vertex
                   : kind == "pair" ? Selection::Kind::pair
                   : kind == "edge" ? Selection::Kind::edge
                                    : Selection::Kind::quad;
  selection.a = mesh::VertexId(s.value("a", -1));
  selection.b = mesh::VertexId(s.value("b", -1));
  selection.quad = mesh::FaceId(s.value("quad", -1));
  for (const int v : s.value("helpers", std::vector<int>{})) selection.helpers.emplace_back(v);
  return selection;
}

namespace {

template <class Id>
json numbers_of(const std::vector<Id>& ids) {
  json list = json::array();
  for (const Id id : ids) list.push_back(id.index());
  return list;
}

// The lines of a text whose first word is not `word`.
std::string without(const std::string& text, const std::string& word) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(word + " ", 0) != 0) result += line + "\n";
  }
  return result;
}

// The operations of a script, without coordinates: all that comes before the first number with a point.
std::string operations(const std::string& script) {
  std::istringstream lines(script);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("place ", 0) == 0 || line.rfind("mesh ", 0) == 0 || line.rfind("end ", 0) == 0) continue;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (word.find('.') == std::string::npos && word.find('e') != 0) result += word + " ";
    }
    result += "\n";
  }
  return result;
}

}  // namespace

Editing::Editing(const EditorPage& page, int width, int height, bool phone)
    : browser(page.browser, Browser::Graphics::webgl) {
  browser.set_size(width, height, phone);
  browser.open(page.page);
  REQUIRE(browser.wait("window.editor"));
}

void Editing::open(const std::string& path) {
  browser.choose_file("#file", path);
  const std::string name = std::filesystem::path(path).filename().string();
  REQUIRE(browser.wait("editor.state.name === '" + name + "' && editor.state.status"));
  native = std::make_unique<Session>(Session::read(slurp(path), name, false));
  settle();
}

void Editing::take_example(const std::string& name) {
  set("examples", name);
  REQUIRE(browser.wait("editor.state.name === '" + name + "' && editor.state.status"));
  native = std::make_unique<Session>(
      Session::read(slurp(example_mesh(std::filesystem::path(name).stem().string())), name, false));
  settle();
}

void Editing::settle() {
  REQUIRE(browser.wait("!editor.view.waiting && !editor.view.playing && !editor.state.offers.more"));
}

std::array<double, 2> Editing::place(const std::string& point) {
  const json at = evaluate(
      "(() => { document.getElementById('canvas').scrollIntoView({block: 'nearest'});"
      " const b = document.getElementById('canvas').getBoundingClientRect(),"
      " p = editor.view.project(" +
      point + "); return [b.x + p.x, b.y + p.y]; })()");
  return {at[0], at[1]};
}

void Editing::click_point(const std::string& point, const std::string& modifier) {
  const auto [x, y] = place(point);
  browser.click_at(x, y, modifier);
  settle();
}

void Editing::hold_point(const std::string& point) {
  const auto [x, y] = place(point);
  browser.hold_at(x, y);
  settle();
}

std::string Editing::at(int number) {
  return "editor.library.ask('subject', {selection: {kind: 'vertex', a: editor.library.ask('numbered', {number: " +
         std::to_string(number) + "})}}).vertices[0].at";
}

void Editing::choose(const std::string& numbers) {
  evaluate("document.getElementById('number').value = '" + numbers + "'");
  press("choose");
}

void Editing::press(const std::string& id) {
  browser.click("document.getElementById('" + id + "')");
  settle();
}

void Editing::set(const std::string& id, const std::string& value) {
  evaluate("(() => { const e = document.getElementById('" + id + "'); e.value = '" + value +
           "'; for (const type of ['input', 'change']) e.dispatchEvent(new Event(type, {bubbles: true})); })()");
  settle();
}

void Editing::check_offers() {
  settle();  // all of them are there
  const json chosen = selection();
  REQUIRE(chosen.is_object());
  const web::Offers& offers = native->offers(native_selection(chosen));
  const json shown = evaluate("editor.state.offers");
  CHECK(shown["why"] == offers.why);
  CHECK(shown["hint"] == offers.hint);
  REQUIRE(shown["list"].size() == offers.list.size());
  const std::string buttons = text("offers"), refused = text("refused");
  for (std::size_t i = 0; i < offers.list.size(); ++i) {
    const web::Offer& offer = offers.list[i];
    const json& here = shown["list"][i];
    CAPTURE(offer.name);
    CHECK(here["name"] == offer.name);
    CHECK(here["why"] == offer.why);
    CHECK(here["helpers"] == numbers_of(offer.helpers));
    if (!offer.is_legal()) {
      CHECK(refused.find(offer.why) != std::string::npos);
      CHECK(refused.find(offer.help) != std::string::npos);
      continue;
    }
    CHECK(here["effect"] == offer.effect);
    CHECK(here["made"] == offer.counts.faces_made);
    CHECK(here["deleted"] == offer.counts.faces_deleted);
    CHECK(here["vertices"] == numbers_of(offer.vertices));
    CHECK(here["quads"] == numbers_of(offer.quads));
    CHECK(buttons.find(offer.effect) != std::string::npos);
  }
}

void Editing::check_mesh() {
  const std::string here = exported("obj");
  CHECK(without(here, "v") == without(native->export_obj(), "v"));
  CHECK(operations(exported("script")) == operations(native->script()));
  const Session page(Session::read(here, "page.obj", false));
  const Session session(Session::read(native->export_obj(), "session.obj", false));
  REQUIRE(page.positions().size() == session.positions().size());
  const double diagonal = mesh::bounding_box_diagonal(session.mesh(), session.positions());
  double farthest = 0;
  for (std::size_t v = 0; v < page.positions().size(); ++v)
    farthest = std::max(farthest, (page.positions()[v] - session.positions()[v]).norm());
  CHECK(farthest <= 0.01 * diagonal);
}

void Editing::follow(const json& selection, const std::string& name) {
  CAPTURE(selection.dump(), name);
  REQUIRE(native->perform(native_selection(selection), name).empty());
  check_mesh();
  CHECK(evaluate("editor.state.status.quads") == native->describe().quads);
  CHECK(evaluate("editor.state.history[editor.state.status.done - 1].words") == native->steps().back().words);
}

}  // namespace requad::tests
