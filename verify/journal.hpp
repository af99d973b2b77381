// The journal of a campaign: a file of records (mesh/program/run/journal_file.hpp), one for each case that was run. A case
// whose record is torn is run again. A file with two records of one case is damaged.
//
// A journal belongs to one combination of version, claims, methods and regions. Runs may share it although they differ
// in what does not change results: threads, processes and reports.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "mesh/program/run/journal_file.hpp"
#include "verify/case_result.hpp"

namespace requad::verify {

class Journal {
 public:
  // Opens the file or makes it. Throws program::UsageError like JournalFile.
  Journal(std::string path, const std::string& run, std::size_t cases, std::size_t claims);

  // The results that the file held when it was opened, by case.
  std::map<std::size_t, CaseResult>& results() { return results_; }
  // Safe from any thread. Throws program::UsageError if the disk is full. Earlier records are not lost then.
  void append(std::size_t index, const CaseResult& result);

 private:
  std::map<std::size_t, CaseResult> results_;
  program::JournalFile file_;
};

}  // namespace requad::verify
