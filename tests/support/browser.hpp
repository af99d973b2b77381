// A headless Chromium that tests operate like a person, by real clicks and keys. Commands go through the DevTools
// protocol on a pipe.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace requad::tests {

// The path of Chromium: REQUAD_CHROMIUM, or that of chromium, chromium-browser or google-chrome. If there is none,
// warns that the test is skipped, or fails the test if REQUAD_REQUIRE_CHROMIUM is set, as it is by tests/run.
std::optional<std::string> chromium();

class Browser {
 public:
  // Starts the program with an empty profile and opens one page; with WebGL by software if wanted. Fails the test if it
  // does not answer.
  enum class Graphics { none, webgl };
  explicit Browser(const std::string& program, Graphics graphics = Graphics::none);
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  // Opens a file and waits until it has loaded.
  void open(const std::string& path, const std::string& fragment = "");
  // The value of a JavaScript expression.
  nlohmann::json evaluate(const std::string& expression);
  // Whether an expression becomes true within some seconds, which are many, for machines may be busy.
  bool wait(const std::string& expression, double seconds = 120);
  // Presses a key: "ArrowUp", "Tab", "Enter", "Escape", "n", "1", "Shift+ArrowLeft", "Control+z", ...
  void press(const std::string& combination);
  // Clicks the left button, or taps, on the middle of the element that a JavaScript expression names.
  void click(const std::string& element);
  // The same at a place of the window, in CSS pixels; with "Shift" held if that is the modifier.
  void click_at(double x, double y, const std::string& modifier = "");
  // Taps, and keeps the finger there for more than half a second.
  void hold_at(double x, double y);
  // Moves two fingers together from two places to two others.
  using Fingers = std::array<std::array<double, 2>, 2>;
  void drag_fingers(const Fingers& from, const Fingers& to);
  // Moves the mouse there, or drags with the left button from one place to the other.
  void hover(double x, double y);
  void drag(double from_x, double from_y, double to_x, double to_y);
  // Drops a file there; gives one to the file input that a selector names.
  void drop_file(const std::string& path, double x, double y);
  void choose_file(const std::string& selector, const std::string& path);
  // Files that the page saves go to this folder.
  void save_to(const std::string& folder);
  void set_size(int width, int height, bool phone);
  // A desk of 1280 by 900, or a phone of 390 by 844.
  void show_on(bool phone) { set_size(phone ? 390 : 1280, phone ? 844 : 900, phone); }
  void set_reduced_motion(bool reduced);
  void set_dark(bool dark);
  void set_print(bool print);
  // Files that the page offers are kept in this folder.
  void set_downloads(const std::string& folder);
  // Writes the page as a PNG, for a person to look at.
  void screenshot(const std::string& path);

  // What went wrong since the last call: errors on the console, uncaught exceptions, and requests for other files.
  std::vector<std::string> complaints();

 private:
  nlohmann::json call(const std::string& method, const nlohmann::json& parameters = nlohmann::json::object());
  void send(const nlohmann::json& message);
  // The next message, or an empty object if none comes within this time.
  nlohmann::json receive(double seconds);
  void note(const nlohmann::json& event);
  void mouse(const char* type, double x, double y, int buttons, int modifiers = 0);
  void touch(const char* type, const std::vector<std::array<double, 2>>& places);
  void set_media();

  int to_ = -1;
  int from_ = -1;
  int process_ = -1;
  int next_id_ = 0;
  bool phone_ = false;
  bool reduced_ = false;
  bool dark_ = false;
  bool print_ = false;
  std::string session_;
  std::string pending_;
  std::string profile_;
  std::vector<std::string> complaints_;
};

}  // namespace requad::tests
