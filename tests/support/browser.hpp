// A headless Chromium that tests drive as a person would: real clicks and keys, through the DevTools protocol on a
// pipe.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace requad::tests {

// Where Chromium is: REQUAD_CHROMIUM, or on the path as chromium, chromium-browser or google-chrome. Nothing, and a
// warning that the test was skipped, if there is none; a failure if REQUAD_REQUIRE_CHROMIUM is set, as tests/run does.
std::optional<std::string> chromium();

class Browser {
 public:
  // Starts the program with an empty profile and opens one page. Fails the test if it does not answer.
  explicit Browser(const std::string& program);
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  // Opens a file and waits until it has loaded.
  void open(const std::string& path, const std::string& fragment = "");
  // The value of a JavaScript expression.
  nlohmann::json evaluate(const std::string& expression);
  // Whether an expression becomes true within some seconds.
  bool wait(const std::string& expression, double seconds = 20);
  // One key: "ArrowUp", "Tab", "Enter", "Shift+ArrowLeft", ...
  void press(const std::string& combination);
  // The left button, or a finger, on the middle of the element that a JavaScript expression names.
  void click(const std::string& element);
  void set_size(int width, int height, bool phone);
  void set_reduced_motion(bool reduced);
  void set_dark(bool dark);
  // The page as a PNG, for a person to look at.
  void screenshot(const std::string& path);

  // Errors on the console, uncaught exceptions, and requests to anything but the file itself, since the last call.
  std::vector<std::string> complaints();

 private:
  nlohmann::json call(const std::string& method, const nlohmann::json& parameters = nlohmann::json::object());
  void send(const nlohmann::json& message);
  // The next message; an empty object if there is none in time.
  nlohmann::json receive(double seconds);
  void note(const nlohmann::json& event);
  void set_media();

  int to_ = -1;
  int from_ = -1;
  int process_ = -1;
  int next_id_ = 0;
  bool phone_ = false;
  bool reduced_ = false;
  bool dark_ = false;
  std::string session_;
  std::string pending_;
  std::string profile_;
  std::vector<std::string> complaints_;
};

}  // namespace requad::tests
