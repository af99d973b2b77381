// Files that a program writes: as a whole or not at all.
//
// An output is named by a path. "-" is standard output. Links are followed. A device or a pipe is written to as it is;
// any other file is written under a temporary name in the same folder, and gets its own name when it is complete.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace requad::program {

// The files of one result. Either all of them are written or none; commit() names the exceptions.
class Outputs {
 public:
  Outputs();
  Outputs(Outputs&&) noexcept;
  // Removes the temporary files that were not committed.
  ~Outputs();

  // Writes the text to a temporary file at once; what goes to "-", a device or a pipe waits for commit(). Throws
  // UsageError if the file cannot be written or was added before.
  void add(const std::string& path, std::string text);
  // Writes to devices and pipes, then gives the files their names in the order in which they were added, then writes to
  // standard output. Signals wait while files are renamed. Throws UsageError if something cannot be written; then no
  // file has its name, unless the system refuses to rename a file that it let be made. run() reports if standard output
  // fails.
  void commit();

 private:
  struct Output;
  std::vector<Output> outputs_;
  std::set<std::string> identities_;  // of the files
};

// Writes one output by itself. Throws UsageError.
void write_text(const std::string& path, std::string text);

// Call these two before long work, so that a wrong path is reported at once.

// Throws the UsageError that write_text() would throw, as far as that can be known without writing. Returns a text that
// is equal for two paths of one file; "-" for standard output, "" for a device or pipe.
std::string require_writable(const std::string& path);
// The same for a folder, which exists or is to be made.
void require_folder(const std::string& path);

// Whether both paths lead to one regular file that exists, also by hard or symbolic links.
bool is_same_file(const std::string& a, const std::string& b);

}  // namespace requad::program
