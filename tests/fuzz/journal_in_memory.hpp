// Input for code that reads journals. No fuzzer guesses a checksum, so each line that starts with { gets its checksum.
// Other lines stay as they are.
#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include <boost/crc.hpp>
#include <sys/mman.h>
#include <unistd.h>

#include "tests/fuzz/fuzz.hpp"

namespace requad::fuzz {

inline std::string with_checksums(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (line.starts_with('{')) {
      boost::crc_32_type crc;
      crc.process_bytes(line.data(), line.size());
      std::array<char, 10> digits{};
      std::snprintf(digits.data(), digits.size(), "%08x ", crc.checksum());
      result += digits.data();
    }
    result += line;
    text.remove_prefix(line.size());
    if (text.empty()) break;
    result += '\n';
    text.remove_prefix(1);
  }
  return result;
}

// A file in memory with a path, so that a journal can open it.
class JournalInMemory {
 public:
  explicit JournalInMemory(std::string_view lines) : descriptor_(memfd_create("journal", 0)) {
    const std::string text = with_checksums(lines);
    require(descriptor_ >= 0 && write(descriptor_, text.data(), text.size()) == static_cast<ssize_t>(text.size()),
            "no file in memory");
  }
  ~JournalInMemory() { close(descriptor_); }
  JournalInMemory(const JournalInMemory&) = delete;
  JournalInMemory& operator=(const JournalInMemory&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace requad::fuzz
