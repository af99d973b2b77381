// A journal of a campaign: the results of its cases as they come, in a file of records (mesh/program/journal_file.hpp).
// A case whose record was torn is run again; one that stands there twice is damage.
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
  // Opens the file or makes it. Throws program::UsageError like JournalFile.
  Journal(std::string path, const std::string& run, std::size_t cases, std::size_t claims);

  // The results that the file held when it was opened, by case.
  std::map<std::size_t, CaseResult>& results() { return results_; }
  // May be called by any thread. Throws program::UsageError if the disk is full; all earlier records are safe then.
  void append(std::size_t index, const CaseResult& result);

 private:
  std::map<std::size_t, CaseResult> results_;
  program::JournalFile file_;
};

}  // namespace requad::verify
