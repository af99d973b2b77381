#include "mesh/program/layout.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <utility>

#include <sys/ioctl.h>
#include <unistd.h>

namespace requad::program {

namespace {

constexpr std::size_t kUsualWidth = 80;
constexpr std::size_t kLeastWidth = 40;

std::string blanks(std::size_t count) { return std::string(count, ' '); }

// Adds the line, broken at blanks. `margin` stands before all pieces but the first. A word that no line can hold is not
// parted from the word before it.
void add_broken(std::vector<std::string>& lines, const std::string& line, const std::string& margin,
                std::size_t width) {
  std::size_t at = std::min(line.find_first_not_of(' '), line.size());
  std::string piece = line.substr(0, at);
  bool is_empty = true;
  while (at < line.size()) {
    const std::size_t end = std::min(line.find(' ', at), line.size());
    const std::size_t next = std::min(line.find_first_not_of(' ', end), line.size());
    const std::string word = line.substr(at, end - at);
    if (!is_empty && piece.size() + word.size() > width && margin.size() + word.size() <= width) {
      piece.erase(piece.find_last_not_of(' ') + 1);
      lines.push_back(std::exchange(piece, margin));
    }
    piece += word + std::string(next < line.size() ? next - end : 0, ' ');
    is_empty = false;
    at = next;
  }
  lines.push_back(std::move(piece));
}

}  // namespace

std::string counted(std::int64_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many.empty() ? one + "s" : many);
}

std::size_t text_width() {
  std::size_t width = 0;
  if (const char* const columns = std::getenv("COLUMNS"); columns != nullptr)
    std::from_chars(columns, columns + std::strlen(columns), width);
  if (winsize size{}; width == 0 && isatty(STDOUT_FILENO) == 1 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0)
    width = size.ws_col;
  return width == 0 ? kUsualWidth : std::max(width, kLeastWidth);
}

std::vector<std::string> wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string entry; std::getline(in, entry);) {
    std::size_t hanging = std::min(entry.find_first_not_of(' '), entry.size());
    if (const std::size_t gap = entry.find("  ", hanging); hanging > 0 && gap != std::string::npos)
      hanging = entry.find_first_not_of(' ', gap);
    add_broken(lines, blanks(indent) + entry, blanks(indent + hanging), width);
  }
  return lines;
}

std::string fitted(const std::string& text, std::size_t hanging) {
  const std::size_t width = text_width();
  std::string result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> pieces;
    add_broken(pieces, line, blanks(std::min(line.find_first_not_of(' '), line.size()) + hanging), width);
    for (const std::string& piece : pieces) result += piece + "\n";
  }
  return result;
}

}  // namespace requad::program
