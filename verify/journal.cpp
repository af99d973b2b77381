#include "verify/journal.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <boost/crc.hpp>

#include "mesh/program.hpp"

namespace requad::verify {

using nlohmann::ordered_json;
using program::UsageError;

namespace {

constexpr std::size_t kDigits = 8;

std::string checksum(std::string_view text) {
  boost::crc_32_type crc;
  crc.process_bytes(text.data(), text.size());
  std::array<char, kDigits + 1> digits{};
  std::snprintf(digits.data(), digits.size(), "%08x", crc.checksum());
  return digits.data();
}

std::string record_line(const std::string& json) { return checksum(json) + " " + json + "\n"; }

// For the parser. No record is nested so deeply; what is copies and prints itself by as many calls in calls.
bool no_deeper(int depth, ordered_json::parse_event_t, ordered_json&) {
  constexpr int kDeepest = 32;
  if (depth > kDeepest) throw std::invalid_argument("it is nested more than " + std::to_string(kDeepest) + " deep");
  return true;
}

// What a line says, if it is whole.
std::optional<std::string_view> content(std::string_view line) {
  if (line.size() <= kDigits || line[kDigits] != ' ') return std::nullopt;
  const std::string_view json = line.substr(kDigits + 1);
  if (line.substr(0, kDigits) != checksum(json)) return std::nullopt;
  return json;
}

}  // namespace

Journal::Journal(std::string path, const std::string& run, std::size_t cases, std::size_t claims)
    : path_(std::move(path)) {
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) throw UsageError("--journal: " + path_ + ": can not be opened: " + std::strerror(errno));
  try {
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) throw UsageError("--journal: " + path_ + ": is in use by another run");
    read(run, cases, claims);
  } catch (...) {
    close(file_);
    throw;
  }
}

Journal::~Journal() { close(file_); }

void Journal::read(const std::string& run, std::size_t cases, std::size_t claims) {
  std::ifstream in(path_, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  if (!in.good() && !in.eof()) throw UsageError("--journal: " + path_ + ": can not be read");
  const auto refuse = [this](std::size_t line, const std::string& why) {
    throw UsageError("--journal: " + path_ + ": line " + std::to_string(line) + ": " + why);
  };
  const std::string header = record_line(ordered_json{{"requad-verify journal", run}}.dump());
  std::size_t at = 0;
  for (std::size_t line = 1; at < text.size(); ++line) {
    const std::size_t end = text.find('\n', at);
    const bool is_last = end == std::string::npos || end + 1 == text.size();
    const auto json = content(std::string_view(text).substr(at, end == std::string::npos ? end : end - at));
    if (!json || end == std::string::npos) {
      // The first line may be torn, too; but a file that does not even start like one is something else, to be kept.
      if (line == 1 && !header.starts_with(text)) refuse(line, "this is no journal of requad-verify");
      if (!is_last) refuse(line, "it is damaged: the checksum does not fit");
      break;
    }
    try {
      const ordered_json record = ordered_json::parse(*json, no_deeper);
      if (line == 1) {
        if (record.at("requad-verify journal").get<std::string>() != run)
          refuse(line, "it belongs to another run: " + record["requad-verify journal"].get<std::string>());
      } else {
        const auto index = static_cast<std::size_t>(
            integer_from(record.at("case"), 0, std::numeric_limits<std::int64_t>::max()));
        if (index >= cases) refuse(line, "there is no case " + std::to_string(index));
        if (!results_.emplace(index, case_result(record.at("result"), claims)).second)
          refuse(line, "case " + std::to_string(index) + " stands here twice");
      }
    } catch (const UsageError&) {
      throw;
    } catch (const std::exception& error) {
      refuse(line, std::string("it is no record: ") + error.what());
    }
    at = end + 1;
  }
  if (at < text.size() && ftruncate(file_, static_cast<off_t>(at)) != 0)
    throw UsageError("--journal: " + path_ + ": can not be written: " + std::strerror(errno));
  if (at == 0) write_line(header);
}

void Journal::append(std::size_t index, const CaseResult& result) {
  const std::string line = record_line(ordered_json{{"case", index}, {"result", to_json(result)}}.dump());
  const std::scoped_lock lock(mutex_);
  write_line(line);
}

void Journal::write_line(const std::string& line) {
  std::size_t written = 0;
  while (written < line.size()) {
    const ssize_t n = write(file_, line.data() + written, line.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw UsageError("--journal: " + path_ + ": can not be written: " + std::strerror(errno));
    written += static_cast<std::size_t>(n);
  }
}

}  // namespace requad::verify
