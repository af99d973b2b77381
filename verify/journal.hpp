// A journal of a campaign: the results of its cases as they come, in a file of records (mesh/program/journal_file.hpp). A
// case whose record was torn is run again; one that stands there twice is damage.
//
// It belongs to one run: the same version, claims, methods and regions. What changes no result (threads, reports,
// processes) may differ.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "mesh/program/journal_file.hpp"
#include "verify/case_result.hpp"

namespace requad::verify {

class Journal {
 public:
  // As JournalFile: opens the file or makes it, and refuses by a program::UsageError.
  Journal(std::string path, const std::string& run, std::size_t cases, std::size_t claims);

  // The results that were there when it was opened, by case.
  std::map<std::size_t, CaseResult>& results() { return results_; }
  // Safe from any thread. Throws program::UsageError if the disk does not take it: nothing is lost up to there.
  void append(std::size_t index, const CaseResult& result);

 private:
  std::map<std::size_t, CaseResult> results_;
  program::JournalFile file_;
};

}  // namespace requad::verify
