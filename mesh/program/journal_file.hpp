// A file of records that only grows, so that a run that was killed goes on where it stopped.
//
// Format. Text, a line for each record: CRC-32 of the rest in eight hexadecimal digits, a space, JSON. The first line
// says which run it is. A line is appended by one write, so a killed run leaves whole lines and at most one torn one, at
// the end: it is dropped. A bad line anywhere else is damage, and the journal is refused.
//
// A journal belongs to one run. It is locked while it is open.
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

  // Opens the file or makes it, and calls take() for each record, in order. `program` is the program's name, `run` a line
  // that tells its runs apart. Throws UsageError in one line if the file is another run's, is damaged, is open
  // elsewhere, or is no journal; also if take() throws: a UsageError says what is wrong with the record, any other
  // exception why it is none.
  JournalFile(std::string path, const std::string& program, const std::string& run,
              const std::function<void(const Record&)>& take);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  // Safe from any thread. Throws UsageError if the disk does not take it, and whatever comes after that: nothing
  // is lost up to there, and no torn line is left.
  void append(const Record& record);
  // Throws the error of a journal whose contents, line by line as they should be, do not make sense together.
  [[noreturn]] void refuse(const std::string& why) const;

 private:
  void read(const std::string& program, const std::string& run, const std::function<void(const Record&)>& take);

  std::string path_;
  int file_ = -1;
  std::mutex mutex_;
  std::string broken_;  // why a record could not be appended; "" if all could
};

// An integer in low..high, exactly: the JSON library converts any number to any type, whether it fits or not. Throws
// std::invalid_argument.
std::int64_t integer_from(const nlohmann::ordered_json& json, std::int64_t low, std::int64_t high);

}  // namespace requad::program
