#include "mesh/program/run/journal_file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "mesh/program/run/checksum.hpp"
#include "mesh/program/run/errors.hpp"

namespace requad::program {

using nlohmann::ordered_json;

namespace {

constexpr std::size_t kDigits = Checksum::kDigits;

std::string checksum(std::string_view text) {
  Checksum sum;
  sum.add(text);
  return sum.text();
}

std::string record_line(const ordered_json& record) {
  const std::string json = record.dump();
  return checksum(json) + " " + json + "\n";
}

// For the parser. No record is nested deeply, and JSON that is would overflow the stack when it is copied or printed.
bool no_deeper(int depth, ordered_json::parse_event_t, ordered_json&) {
  constexpr int kDeepest = 32;
  if (depth > kDeepest) throw std::invalid_argument("it is nested more than " + std::to_string(kDeepest) + " deep");
  return true;
}

// The JSON of a line; nothing if the line is torn or damaged.
std::optional<std::string_view> content(std::string_view line) {
  if (line.size() <= kDigits || line[kDigits] != ' ') return std::nullopt;
  const std::string_view json = line.substr(kDigits + 1);
  if (line.substr(0, kDigits) != checksum(json)) return std::nullopt;
  return json;
}

}  // namespace

JournalFile::JournalFile(std::string path, const std::string& program, const std::string& run,
                         const std::function<void(const Record&)>& take)
    : path_(std::move(path)) {
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) refuse(std::string("cannot be opened: ") + std::strerror(errno));
  try {
    struct stat status {};
    if (fstat(file_, &status) != 0 || !S_ISREG(status.st_mode)) refuse("is no regular file");
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) refuse("is in use by another run");
    read(program, run, take);
  } catch (...) {
    close(file_);
    throw;
  }
}

JournalFile::~JournalFile() { close(file_); }

void JournalFile::refuse(const std::string& why) const { throw UsageError("--journal: " + path_ + ": " + why); }

void JournalFile::read(const std::string& program, const std::string& run,
                       const std::function<void(const Record&)>& take) {
  std::ifstream in(path_, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  if (!in.good() && !in.eof()) refuse("cannot be read");
  const auto refuse_line = [this](std::size_t line, const std::string& why) {
    refuse("line " + std::to_string(line) + ": " + why);
  };
  const std::string title = program + " journal";
  const ordered_json header{{title, run}};
  std::size_t at = 0;
  for (std::size_t line = 1; at < text.size(); ++line) {
    const std::size_t end = text.find('\n', at);
    const bool is_last = end == std::string::npos || end + 1 == text.size();
    const auto json = content(std::string_view(text).substr(at, end == std::string::npos ? end : end - at));
    if (!json || end == std::string::npos) {
      // The first line may be torn too. But a file that begins differently is no journal, and must be kept.
      if (line == 1 && !record_line(header).starts_with(text)) refuse_line(line, "this is no journal of " + program);
      if (!is_last) refuse_line(line, "it is damaged: the checksum does not fit");
      break;
    }
    try {
      const ordered_json record = ordered_json::parse(*json, no_deeper);
      if (line > 1) {
        take(record);
      } else if (const auto name = record.at(title).get<std::string>(); name != run) {
        throw UsageError("it belongs to another run: " + name);
      }
    } catch (const UsageError& error) {
      refuse_line(line, error.what());
    } catch (const std::exception& error) {
      if (program::is_exhaustion(error)) throw;
      refuse_line(line, std::string("it is no record: ") + error.what());
    }
    at = end + 1;
  }
  if (at < text.size() && ftruncate(file_, static_cast<off_t>(at)) != 0)
    refuse(std::string("cannot be written: ") + std::strerror(errno));
  if (at == 0) append(header);
}

void JournalFile::append(const Record& record) {
  const std::string line = record_line(record);
  const std::scoped_lock lock(mutex_);
  if (!broken_.empty()) refuse(broken_);
  const off_t before = lseek(file_, 0, SEEK_END);
  std::size_t written = 0;
  while (written < line.size()) {
    const ssize_t n = write(file_, line.data() + written, line.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      broken_ = std::string("cannot be written: ") + std::strerror(errno);
      // Removes the torn line. Should that fail too, nothing is lost: no line will follow it.
      [[maybe_unused]] const int ignored = ftruncate(file_, before);
      refuse(broken_);
    }
    written += static_cast<std::size_t>(n);
  }
}

std::int64_t integer_from(const ordered_json& json, std::int64_t low, std::int64_t high) {
  // The parser stores a number that is not negative as an unsigned one.
  const bool fits = json.is_number_integer() &&
                    (!json.is_number_unsigned() || std::in_range<std::int64_t>(json.get<std::uint64_t>()));
  const auto value = fits ? json.get<std::int64_t>() : 0;
  if (!fits || value < low || value > high)
    throw std::invalid_argument("no integer in " + std::to_string(low) + ".." + std::to_string(high));
  return value;
}

std::string version_and_build(const std::string& version) {
  std::ifstream self("/proc/self/exe", std::ios::binary);
  if (!self) return version;
  Checksum sum;
  std::array<char, 1 << 16> piece;
  while (self.read(piece.data(), piece.size()) || self.gcount() > 0)
    sum.add({piece.data(), static_cast<std::size_t>(self.gcount())});
  return version + " (build " + sum.text() + ")";
}

}  // namespace requad::program
