// What all programs share: exit codes, one-line errors, numbers on command lines, whole files, progress.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace requad::program {

enum ExitCode : int {
  kDone = 0,         // done, and all that was checked is true
  kCheckFailed = 1,  // a check failed
  kBadInput = 2,     // bad arguments or bad input
  kUndecided = 3     // a limit was reached
};

// The text as one line: '?' for what would end the line or act on a terminal.
std::string one_line(std::string text);

// Bad arguments or input: one line that says what, where and what was expected.
class UsageError : public std::runtime_error {
 public:
  // Arguments and names of files are quoted here: one_line() of it is kept.
  explicit UsageError(std::string message) : std::runtime_error(one_line(std::move(message))) {}
};

// Calls body and returns its exit code; an exception ends in one line "NAME: message" on stderr and kBadInput for bad
// arguments and input, in kUndecided if the system has no more memory or threads, in kCheckFailed for anything else: a
// fault of this program. A signal that ends the program (SIGINT, SIGTERM, SIGHUP) takes temporary files along.
int run(std::string_view name, const std::function<int()>& body);
// What run() did to signals undone: for a program that is to take this one's place.
void restore_signals();

// Whether something says no to running out of memory or threads, which is no fault of what ran: to be thrown again.
bool is_exhaustion(const std::exception& error);

// "0.1.0 (build 1a2b3c4d)": the version, and a checksum of the running program, where that can be read. What another build
// of the same version found may not be what this one would find.
std::string version_and_build(const std::string& version);

// A decimal integer and nothing else; `what` names it in the error.
std::int64_t parse_integer(std::string_view text, std::string_view what);
// A finite decimal number and nothing else.
double parse_number(std::string_view text, std::string_view what);
// "6,6,6".
std::vector<std::int64_t> parse_integers(std::string_view text, std::string_view what);
// "3..24", or "7" for 7..7; first <= last.
struct Range {
  std::int64_t first;
  std::int64_t last;
};
Range parse_range(std::string_view text, std::string_view what);

// The files of one result: all of them or none, and each as a whole.
class Outputs {
 public:
  Outputs();
  Outputs(Outputs&&) noexcept;
  ~Outputs();  // what was not committed is gone

  // A file, by a temporary one beside it that is written at once, or standard output if path is "-". Links are followed;
  // a device or pipe is written to as it is, at the commit. Throws UsageError, also if the file was added before.
  void add(const std::string& path, std::string text);
  // Writes to devices and pipes, then gives the files their names, in the order they were added and while signals wait.
  // Throws UsageError; then, unless the system refuses to rename what it let be made, no file has its name. Writes to
  // standard output last: whether it took it, run() sees.
  void commit();

 private:
  struct Output;
  std::vector<Output> outputs_;
  std::set<std::string> places_;
};

// One output by itself.
void write_text(const std::string& path, std::string text);

// Throws the UsageError that write_text() would, as far as can be told without writing: for long work, before it. Returns
// what tells files apart, "-" for standard output and "" for a device or pipe.
std::string require_writable(const std::string& path);
// Likewise for a folder that is there or to be made.
void require_folder(const std::string& path);

// A counter on stderr, shown only if stderr is a terminal and the work has taken a second. A total of 0 is not known.
// Safe to call from any thread.
class Progress {
 public:
  Progress(std::string what, std::int64_t total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void advance(std::int64_t by = 1);
  // Takes the counter off the screen, before other output; the destructor does so too.
  void finish();

 private:
  std::string what_;
  std::int64_t total_;
  bool shown_;
  std::atomic<std::int64_t> done_{0};
  std::mutex mutex_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_;
  bool printed_ = false;
};

}  // namespace requad::program
