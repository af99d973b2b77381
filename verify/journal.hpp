// A journal on disk: the results of a campaign as they come, so that a run that was killed goes on where it stopped.
//
// Format. Text, a line for each record: CRC-32 of the rest in eight hexadecimal digits, a space, JSON. The first line
// says which run it is, each further one holds the number of a case and its result. A line is appended by one write, so
// a killed run leaves whole lines and at most one torn one, at the end: it is dropped, and its case run again. A case
// that stands there twice, or a bad line anywhere else, is damage, and the journal is refused.
//
// A journal belongs to one run: the same version, claims, methods and regions. What changes no result (threads, reports,
// processes) may differ. It is locked while it is open.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>

#include "verify/case_result.hpp"

namespace requad::verify {

class Journal {
 public:
  // Opens the file or makes it. `run` is a line that tells runs apart. Throws program::UsageError in one line if the file
  // is another run's, is damaged, is open elsewhere, or is no journal.
  Journal(std::string path, const std::string& run, std::size_t cases, std::size_t claims);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // The results that were there when it was opened, by case.
  std::map<std::size_t, CaseResult>& results() { return results_; }
  // Safe from any thread. Throws program::UsageError if the disk does not take it: nothing is lost up to there.
  void append(std::size_t index, const CaseResult& result);

 private:
  void write_line(const std::string& line);
  void read(const std::string& run, std::size_t cases, std::size_t claims);

  std::string path_;
  int file_ = -1;
  std::mutex mutex_;
  std::map<std::size_t, CaseResult> results_;
};

}  // namespace requad::verify
