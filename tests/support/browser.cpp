#include "tests/support/browser.hpp"

#include <cctype>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/catch.hpp"
#include "tests/support/programs.hpp"

namespace requad::tests {

namespace fs = std::filesystem;
using nlohmann::json;
using Clock = std::chrono::steady_clock;

namespace {

constexpr double kPatience = 180;  // seconds for the browser to start or to answer on a busy machine

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::string base64_decoded(const std::string& text) {
  static const std::string kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  unsigned bits = 0;
  int held = 0;
  for (const char c : text) {
    const std::size_t digit = kAlphabet.find(c);
    if (digit == std::string::npos) break;
    bits = (bits << 6) | static_cast<unsigned>(digit);
    if ((held += 6) >= 8) result += static_cast<char>((bits >> (held -= 8)) & 0xff);
  }
  return result;
}

}  // namespace

std::optional<std::string> chromium() {
  std::vector<std::string> names{"chromium", "chromium-browser", "google-chrome"};
  if (const char* given = std::getenv("REQUAD_CHROMIUM")) names.insert(names.begin(), given);
  const char* path = std::getenv("PATH");
  for (const std::string& name : names) {
    if (name.find('/') != std::string::npos && access(name.c_str(), X_OK) == 0) return name;
    std::stringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
      const std::string file = (fs::path(folder) / name).string();
      if (access(file.c_str(), X_OK) == 0 && !fs::is_directory(file)) return file;
    }
  }
  if (std::getenv("REQUAD_REQUIRE_CHROMIUM") != nullptr)
    FAIL("Chromium is missing, and REQUAD_REQUIRE_CHROMIUM is set");
  WARN("skipped: Chromium is missing");
  return std::nullopt;
}

Browser::Browser(const std::string& program, Graphics graphics) {
  profile_ = (scratch() / "chromium-XXXXXX").string();
  REQUIRE(mkdtemp(profile_.data()) != nullptr);
  int commands[2];
  int answers[2];
  REQUIRE(pipe2(commands, O_CLOEXEC) == 0);
  REQUIRE(pipe2(answers, O_CLOEXEC) == 0);
  std::vector<std::string> words{program,
                                 "--headless",
                                 "--no-sandbox",
                                 "--disable-quic",
                                 "--no-first-run",
                                 "--disable-background-networking",
                                 "--disable-component-update",
                                 "--disable-sync",
                                 "--disable-dev-shm-usage",
                                 "--user-data-dir=" + profile_,
                                 "--remote-debugging-pipe",
                                 "about:blank"};
  if (graphics == Graphics::webgl) {
    words.insert(words.end() - 1, {"--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"});
  } else {
    words.insert(words.end() - 1, "--disable-gpu");
  }
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  process_ = fork();
  REQUIRE(process_ >= 0);
  if (process_ == 0) {
    // Commands come on descriptor 3, and answers go to 4. Both are moved away first, so that neither overwrites the
    // other.
    const int in = fcntl(commands[0], F_DUPFD, 10);
    const int out = fcntl(answers[1], F_DUPFD, 10);
    const int nowhere = ::open("/dev/null", O_RDWR);
    dup2(nowhere, 0);
    dup2(nowhere, 1);
    dup2(nowhere, 2);
    dup2(in, 3);
    dup2(out, 4);
    close(in);
    close(out);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  close(commands[0]);
  close(answers[1]);
  to_ = commands[1];
  from_ = answers[0];
  signal(SIGPIPE, SIG_IGN);

  const std::string target = call("Target.createTarget", {{"url", "about:blank"}})["targetId"];
  session_ = call("Target.attachToTarget", {{"targetId", target}, {"flatten", true}})["sessionId"];
  for (const char* domain : {"Runtime", "Log", "Page", "Network"}) call(std::string(domain) + ".enable");
}

Browser::~Browser() {
  try {
    session_.clear();
    send({{"id", ++next_id_}, {"method", "Browser.close"}});
  } catch (...) {
    // A failure here does not matter: the process is ended below.
  }
  const auto start = Clock::now();
  while (waitpid(process_, nullptr, WNOHANG) == 0) {
    if (seconds_since(start) > 10) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  close(to_);
  close(from_);
  std::error_code error;
  for (int i = 0; i < 50 && (fs::remove_all(profile_, error), fs::exists(profile_)); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

void Browser::send(const json& message) {
  std::string text = message.dump();
  text += '\0';
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = write(to_, text.data() + done, text.size() - done);
    if (n <= 0) throw std::runtime_error("the browser does not listen");
    done += static_cast<std::size_t>(n);
  }
}

json Browser::receive(double seconds) {
  const auto start = Clock::now();
  while (true) {
    if (const std::size_t end = pending_.find('\0'); end != std::string::npos) {
      json message = json::parse(pending_.substr(0, end));
      pending_.erase(0, end + 1);
      return message;
    }
    const double left = seconds - seconds_since(start);
    pollfd ready{from_, POLLIN, 0};
    if (left <= 0 || poll(&ready, 1, static_cast<int>(left * 1000) + 1) <= 0) {
      if (left <= 0) return json::object();
      continue;
    }
    char buffer[65536];
    const ssize_t n = read(from_, buffer, sizeof buffer);
    if (n <= 0) throw std::runtime_error("the browser has ended");
    pending_.append(buffer, static_cast<std::size_t>(n));
  }
}

void Browser::note(const json& event) {
  const std::string method = event.value("method", "");
  const json& what = event.contains("params") ? event["params"] : event;
  if (method == "Runtime.exceptionThrown") complaints_.push_back("exception: " + what["exceptionDetails"].dump());
  if (method == "Runtime.consoleAPICalled" &&
      (what["type"] == "error" || what["type"] == "warning" || what["type"] == "assert")) {
    complaints_.push_back("console: " + what["args"].dump());
  }
  if (method == "Log.entryAdded" && (what["entry"]["level"] == "error" || what["entry"]["level"] == "warning")) {
    const std::string text = what["entry"]["text"];
    // What a driver thinks of its own speed is no complaint.
    if (text.find("GL Driver Message (OpenGL, Performance") == std::string::npos) complaints_.push_back("log: " + text);
  }
  if (method == "Network.requestWillBeSent") {
    const std::string url = what["request"]["url"];
    if (url.rfind("file:", 0) != 0 && url.rfind("data:", 0) != 0 && url.rfind("about:", 0) != 0)
      complaints_.push_back("request: " + url);
  }
}

json Browser::call(const std::string& method, const json& parameters) {
  const int id = ++next_id_;
  json message{{"id", id}, {"method", method}, {"params", parameters}};
  if (!session_.empty()) message["sessionId"] = session_;
  send(message);
  const auto start = Clock::now();
  while (seconds_since(start) < kPatience) {
    const json answer = receive(kPatience - seconds_since(start));
    if (answer.value("id", 0) != id) {
      note(answer);
      continue;
    }
    INFO(method << " " << parameters.dump() << " -> " << answer.dump().substr(0, 2000));
    REQUIRE_FALSE(answer.contains("error"));
    return answer["result"];
  }
  FAIL("the browser did not answer to " << method);
  return {};
}

void Browser::open(const std::string& path, const std::string& fragment) {
  // A page that would ask whether its edits may be lost is not heard.
  evaluate("window.onbeforeunload = null");
  // If only the fragment changed, the page would not be loaded again.
  call("Page.navigate", {{"url", "about:blank"}});
  const json answer = call("Page.navigate", {{"url", "file://" + path + (fragment.empty() ? "" : "#" + fragment)}});
  INFO(answer.dump());
  REQUIRE_FALSE(answer.contains("errorText"));
  REQUIRE(wait("location.protocol === 'file:' && document.readyState === 'complete'"));
}

json Browser::evaluate(const std::string& expression) {
  const json answer =
      call("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
  INFO(expression << " -> " << answer.dump().substr(0, 2000));
  REQUIRE_FALSE(answer.contains("exceptionDetails"));
  return answer["result"].value("value", json());
}

bool Browser::wait(const std::string& expression, double seconds) {
  const auto start = Clock::now();
  do {
    if (evaluate("Boolean(" + expression + ")") == true) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  } while (seconds_since(start) < seconds);
  return false;
}

void Browser::press(const std::string& combination) {
  std::string key = combination;
  int modifiers = 0;
  for (const auto& [name, bit] : {std::pair("Shift+", 8), std::pair("Control+", 2)}) {
    if (key.rfind(name, 0) != 0) continue;
    key.erase(0, std::string(name).size());
    modifiers |= bit;
  }
  static const std::map<std::string, int> kCodes{{"ArrowLeft", 37}, {"ArrowUp", 38}, {"ArrowRight", 39},
                                                 {"ArrowDown", 40}, {"Tab", 9},      {"Enter", 13},
                                                 {"Escape", 27},    {"Space", 32}};
  const bool character = key.size() == 1;
  const int code = character ? std::toupper(static_cast<unsigned char>(key[0])) : kCodes.at(key);
  json event{{"key", key}, {"code", key}, {"windowsVirtualKeyCode", code}, {"modifiers", modifiers}};
  if (key == "Space") event["key"] = " ";
  const std::string text = key == "Enter" ? "\r" : key == "Space" ? " " : character && modifiers != 2 ? key : "";
  event["type"] = text.empty() ? "rawKeyDown" : "keyDown";
  if (!text.empty()) event["text"] = text;
  call("Input.dispatchKeyEvent", event);
  event.erase("text");
  event["type"] = "keyUp";
  call("Input.dispatchKeyEvent", event);
}

void Browser::click(const std::string& element) {
  const json at = evaluate("(() => { const e = " + element +
                           "; e.scrollIntoView({block: 'center'}); const r = e.getBoundingClientRect();"
                           " return [r.x + r.width / 2, r.y + r.height / 2]; })()");
  click_at(at[0], at[1]);
}

void Browser::mouse(const char* type, double x, double y, int buttons, int modifiers) {
  const bool moves = std::string(type) == "mouseMoved";
  call("Input.dispatchMouseEvent", {{"type", type},
                                    {"x", x},
                                    {"y", y},
                                    {"modifiers", modifiers},
                                    {"button", moves && buttons == 0 ? "none" : "left"},
                                    {"buttons", buttons},
                                    {"clickCount", moves ? 0 : 1}});
}

void Browser::touch(const char* type, const std::vector<std::array<double, 2>>& places) {
  json points = json::array();
  for (std::size_t i = 0; i < places.size(); ++i)
    points.push_back({{"x", places[i][0]}, {"y", places[i][1]}, {"id", i}});
  call("Input.dispatchTouchEvent", {{"type", type}, {"touchPoints", points}});
}

void Browser::hold_at(double x, double y) {
  touch("touchStart", {{x, y}});
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  touch("touchEnd", {});
}

void Browser::drag_fingers(const Fingers& from, const Fingers& to) {
  constexpr int kMoves = 6;
  touch("touchStart", {from.begin(), from.end()});
  for (int i = 1; i <= kMoves; ++i) {
    std::vector<std::array<double, 2>> now;
    for (std::size_t finger = 0; finger < 2; ++finger) {
      const auto at = [&](std::size_t k) { return from[finger][k] + i * (to[finger][k] - from[finger][k]) / kMoves; };
      now.push_back({at(0), at(1)});
    }
    touch("touchMove", now);
  }
  touch("touchEnd", {});
}

void Browser::click_at(double x, double y, const std::string& modifier) {
  if (phone_) {
    touch("touchStart", {{x, y}});
    touch("touchEnd", {});
    return;
  }
  const int modifiers = modifier == "Shift" ? 8 : 0;
  mouse("mouseMoved", x, y, 0, modifiers);
  mouse("mousePressed", x, y, 1, modifiers);
  mouse("mouseReleased", x, y, 0, modifiers);
}

void Browser::hover(double x, double y) { mouse("mouseMoved", x, y, 0); }

void Browser::drag(double from_x, double from_y, double to_x, double to_y) {
  mouse("mouseMoved", from_x, from_y, 0);
  mouse("mousePressed", from_x, from_y, 1);
  for (int i = 1; i <= 4; ++i)
    mouse("mouseMoved", from_x + i * (to_x - from_x) / 4, from_y + i * (to_y - from_y) / 4, 1);
  mouse("mouseReleased", to_x, to_y, 0);
}

void Browser::drop_file(const std::string& path, double x, double y) {
  const json data{{"items", json::array()}, {"files", {path}}, {"dragOperationsMask", 1}};
  for (const char* type : {"dragEnter", "dragOver", "drop"})
    call("Input.dispatchDragEvent", {{"type", type}, {"x", x}, {"y", y}, {"data", data}});
}

void Browser::choose_file(const std::string& selector, const std::string& path) {
  const json root = call("DOM.getDocument")["root"]["nodeId"];
  const json node = call("DOM.querySelector", {{"nodeId", root}, {"selector", selector}})["nodeId"];
  call("DOM.setFileInputFiles", {{"files", {path}}, {"nodeId", node}});
}

void Browser::save_to(const std::string& folder) {
  call("Browser.setDownloadBehavior", {{"behavior", "allow"}, {"downloadPath", folder}});
}

void Browser::set_size(int width, int height, bool phone) {
  phone_ = phone;
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", phone ? 2 : 1}, {"mobile", phone}});
  call("Emulation.setTouchEmulationEnabled", {{"enabled", phone}});
}

void Browser::set_media() {
  call("Emulation.setEmulatedMedia",
       {{"media", print_ ? "print" : ""},
        {"features",
         {{{"name", "prefers-reduced-motion"}, {"value", reduced_ ? "reduce" : "no-preference"}},
          {{"name", "prefers-color-scheme"}, {"value", dark_ ? "dark" : "light"}}}}});
}

void Browser::set_reduced_motion(bool reduced) {
  reduced_ = reduced;
  set_media();
}

void Browser::set_dark(bool dark) {
  dark_ = dark;
  set_media();
}

void Browser::set_print(bool print) {
  print_ = print;
  set_media();
}

void Browser::set_downloads(const std::string& folder) {
  call("Browser.setDownloadBehavior", {{"behavior", "allow"}, {"downloadPath", folder}});
}

void Browser::screenshot(const std::string& path) {
  spill(path, base64_decoded(call("Page.captureScreenshot", {{"format", "png"}})["data"]));
}

std::vector<std::string> Browser::complaints() {
  evaluate("new Promise((done) => setTimeout(done, 50))");  // pending messages arrive before the answer
  return std::exchange(complaints_, {});
}

}  // namespace requad::tests
