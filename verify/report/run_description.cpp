#include "verify/report/run_description.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <thread>
#include <utility>

#include <sys/utsname.h>
#include <unistd.h>

#include "mesh/program/layout.hpp"

namespace requad::verify {

namespace {

std::string date_text(std::time_t time) {
  std::tm parts{};
  gmtime_r(&time, &parts);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M UTC", &parts)};
}

// The model of the first processor that Linux names; "" elsewhere.
std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t at = line.find(": ");
    return at == std::string::npos ? "" : line.substr(at + 2);
  }
  return "";
}

std::string machine_text() {
  std::string text;
  const auto add = [&text](const std::string& part) {
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
  };
  utsname system{};
  if (uname(&system) == 0) add(std::string(system.sysname) + " " + system.release + " " + system.machine);
  add(processor());
  if (const unsigned cores = std::thread::hardware_concurrency(); cores > 0) add(program::counted(cores, "core"));
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
  constexpr double kGigabyte = 1 << 30;
  if (pages > 0 && page > 0) {
    const double gigabytes = static_cast<double>(pages) * static_cast<double>(page) / kGigabyte;
    add(std::to_string(std::max(1, static_cast<int>(gigabytes + 0.5))) + " GB");
  }
  return text;
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string("-_./=,:+@%").find(c) != std::string::npos;
}

}  // namespace

std::string command_line(int argc, const char* const* argv) {
  std::string text;
  for (int i = 0; i < argc; ++i) {
    const std::string word = argv[i];
    if (i > 0) text += ' ';
    if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) {
      text += word;
      continue;
    }
    text += '\'';
    for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
    text += '\'';
  }
  return text;
}

RunDescription describe_run(std::string version, std::string command, std::chrono::steady_clock::time_point start) {
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  return {std::move(version), std::move(command), date_text(std::time(nullptr)), machine_text(), took.count()};
}

}  // namespace requad::verify
