// A journal: a file of records that only grows. A run that was killed can continue where it stopped.
//
// Format: text, one line for each record. A line is the CRC-32 of its JSON in eight hexadecimal digits, a space, and
// the JSON. The first line says which run the journal belongs to.
//
// A line is appended by one write. So a killed run leaves whole lines and at most one torn line, at the end, which the
// next run drops. A bad line anywhere else is damage, and the journal is refused. A journal is locked while it is open.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

#include <nlohmann/json.hpp>

namespace requad::program {

class JournalFile {
 public:
  using Record = nlohmann::ordered_json;

  // Opens the file, or makes it, and calls take() for each record in order. `program` is the program's name; `run` is
  // one line that tells its runs apart. Throws UsageError if the file is the journal of another run, is damaged, is
  // open elsewhere, or is no journal. It does so too if take() throws: a UsageError says what is wrong with the record,
  // any other exception why it is no record.
  JournalFile(std::string path, const std::string& program, const std::string& run,
              const std::function<void(const Record&)>& take);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  // Safe from any thread. Throws UsageError if the record could not be written, and again for every record after it.
  // The records before it are kept, and no torn line stays.
  void append(const Record& record);
  // Throws the UsageError of a journal whose records are valid one by one but make no sense together.
  [[noreturn]] void refuse(const std::string& why) const;

 private:
  void read(const std::string& program, const std::string& run, const std::function<void(const Record&)>& take);

  std::string path_;
  int file_ = -1;
  std::mutex mutex_;
  std::string broken_;  // why a record could not be appended; "" if all could
};

// The JSON as an integer in low..high. The JSON library itself converts any number to any type, whether it fits or not.
// Throws std::invalid_argument.
std::int64_t integer_from(const nlohmann::ordered_json& json, std::int64_t low, std::int64_t high);

// "0.1.0 (build 1a2b3c4d)": the version, and a checksum of the running program if that can be read. A run's name should
// have it, for another build of the same version may find something else.
std::string version_and_build(const std::string& version);

}  // namespace requad::program
