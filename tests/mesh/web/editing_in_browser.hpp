// The editor's page in a browser, beside the same session in this process. Both must agree: what is offered, what is refused
// and why, the connectivity to the last id, and positions nearly. Eigen sums up in another order where the processor has
// wide registers, as x86 has and WebAssembly has not; and where two points of a surface are equally near, the last bit
// decides which a fit takes. (requad-edit apply makes the page's mesh from the page's script to the last bit.)
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "mesh/web/session.hpp"
#include "tests/support/browser.hpp"
#include "tests/support/programs.hpp"

namespace requad::tests {

// A page of the editor, and a browser for it. Nothing, with a warning, if one of them is missing; a failure if tests/run
// requires it.
struct EditorPage {
  std::string page;
  std::string browser;
};
std::optional<EditorPage> editor_page();

// Writes Figure 17's mesh with sixteen more irregular vertices, and returns the path.
std::string busy_mesh();

web::Selection native_selection(const nlohmann::json& selection);

struct Editing {
  explicit Editing(const EditorPage& page, int width = 1280, int height = 900, bool phone = false);

  // Opens a file by the dialog, here too.
  void open(const std::string& path);
  // Takes an example of the page, here too.
  void take_example(const std::string& name);
  // Waits until the last change is drawn and nothing moves.
  void settle();

  nlohmann::json evaluate(const std::string& expression) { return browser.evaluate(expression); }
  nlohmann::json selection() { return evaluate("editor.state.selection"); }
  // The text of an element, shown or not.
  std::string text(const std::string& id) { return evaluate("document.getElementById('" + id + "').textContent"); }
  std::string exported(const std::string& what) { return evaluate("editor.library.text('" + what + "')"); }

  // Where a point of the mesh, given as JavaScript, is in the window.
  std::array<double, 2> place(const std::string& point);
  void click_point(const std::string& point, const std::string& modifier = "");
  // The same by a finger that stays.
  void hold_point(const std::string& point);
  // The position of a vertex, by its number in the file; as JavaScript.
  static std::string at(int number);
  // Chooses by the number field.
  void choose(const std::string& numbers);
  // Clicks an element by its id, and waits.
  void press(const std::string& id);
  // Sets an input and tells the page, as a person does who moves a slider and lets it go.
  void set(const std::string& id, const std::string& value);

  // Checks that the page offers and refuses what the session here does.
  void check_offers();
  // Performs the edit here that the page has performed, and compares the results.
  void follow(const nlohmann::json& selection, const std::string& name);
  // Checks that mesh and script of the page are those of the session here, as above.
  void check_mesh();

  Browser browser;
  std::unique_ptr<web::Session> native;
};

}  // namespace requad::tests
