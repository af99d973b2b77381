#include "mesh/program/program.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "mesh/program/checksum.hpp"

namespace requad::program {

namespace fs = std::filesystem;

namespace {

// The temporary files there are, so that a signal that ends the program takes them away. Made and never freed, as a signal
// may come when the program is ending anyway.
struct Unfinished {
  std::mutex mutex;  // held while files are made, renamed or removed
  std::set<std::string> paths;
};
Unfinished& unfinished() {
  static auto* const it = new Unfinished;
  return *it;
}

sigset_t blocked_before_run;

// Waits in a thread of its own for the signals that end a program, so that none comes between making a file and noting
// that it was made. Threads that are started later inherit that the signals are blocked.
void end_on_signals() {
  sigset_t awaited;
  sigemptyset(&awaited);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    if (now.sa_handler != SIG_IGN) sigaddset(&awaited, signal);  // one that is ignored, as in the background, stays so
  }
  unfinished();
  pthread_sigmask(SIG_BLOCK, &awaited, &blocked_before_run);
  std::thread([awaited] {
    int signal = 0;
    if (sigwait(&awaited, &signal) != 0) return;
    const std::lock_guard lock(unfinished().mutex);
    for (const std::string& path : unfinished().paths) unlink(path.c_str());
    std::signal(signal, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &awaited, nullptr);
    raise(signal);
  }).detach();
}

[[noreturn]] void can_not_write(const std::string& path, const std::string& why) {
  throw UsageError(path + ": can not be written: " + why);
}

// Where an output goes.
struct Target {
  fs::path path;   // through links
  bool whole;      // a regular file, there or not: to be replaced; else written to as it is
  fs::perms mode;  // of the new file

  // What tells files apart.
  std::string place() const {
    std::error_code error;
    const fs::path canonical = whole ? fs::weakly_canonical(fs::absolute(path), error) : fs::path();
    return error ? path.string() : canonical.string();
  }
};

Target target_of(const std::string& path) {
  if (path.empty()) throw UsageError("a file's name is expected, not nothing");
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    if (fs::is_directory(status)) can_not_write(path, "it is a folder");
    return {path, false, {}};
  }
  fs::path target = path;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    const fs::path next = fs::read_symlink(target, error);
    if (error || links == 40) can_not_write(path, error ? error.message() : "too many links");
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  // As an ordinary new file would be, or as the file that is replaced was.
  const mode_t mask = umask(0);
  umask(mask);
  return {target, true, fs::exists(status) ? status.permissions() : static_cast<fs::perms>(0666 & ~mask)};
}

}  // namespace

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7F'; }, '?');
  return text;
}

void restore_signals() {
  std::signal(SIGXFSZ, SIG_DFL);
  pthread_sigmask(SIG_SETMASK, &blocked_before_run, nullptr);
}

bool is_exhaustion(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
  const auto* const refused = dynamic_cast<const std::system_error*>(&error);
  return refused != nullptr && refused->code() == std::errc::resource_unavailable_try_again;  // a thread
}

std::string version_and_build(const std::string& version) {
  std::ifstream self("/proc/self/exe", std::ios::binary);
  if (!self) return version;
  Checksum sum;
  std::array<char, 1 << 16> piece;
  while (self.read(piece.data(), piece.size()) || self.gcount() > 0)
    sum.add({piece.data(), static_cast<std::size_t>(self.gcount())});
  return version + " (build " + sum.text() + ")";
}

int run(std::string_view name, const std::function<int()>& body) {
  const auto say = [name](const char* what) { std::cerr << one_line(std::string(name) + ": " + what) << '\n'; };
  try {
    // A file that grows beyond its limit is an error to report, like a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    end_on_signals();
    const int code = body();
    std::cout.flush();
    if (!std::cout) throw UsageError("standard output can not be written");
    return code;
  } catch (const UsageError& error) {
    say(error.what());
    return kBadInput;
  } catch (const std::invalid_argument& error) {
    say(error.what());
    return kBadInput;
  } catch (const std::exception& error) {
    if (is_exhaustion(error)) {
      say(dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "out of memory" : "out of threads");
      return kUndecided;
    }
    say((std::string("internal error: ") + error.what()).c_str());
    return kCheckFailed;
  }
}

std::int64_t parse_integer(std::string_view text, std::string_view what) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    throw UsageError(std::string(what) + ": " + std::string(text) + " is too large");
  }
  if (error != std::errc() || end != text.data() + text.size()) {
    throw UsageError(std::string(what) + ": '" + std::string(text) + "' is not an integer");
  }
  return value;
}

double parse_number(std::string_view text, std::string_view what) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || end != text.data() + text.size()) {
    throw UsageError(std::string(what) + ": '" + std::string(text) + "' is not a number");
  }
  if (error != std::errc() || !std::isfinite(value)) {
    throw UsageError(std::string(what) + ": " + std::string(text) + " is not a finite number");
  }
  return value;
}

std::vector<std::int64_t> parse_integers(std::string_view text, std::string_view what) {
  std::vector<std::int64_t> values;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    values.push_back(parse_integer(text.substr(start, comma - start), what));
    start = comma + 1;
  }
  return values;
}

Range parse_range(std::string_view text, std::string_view what) {
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) {
    const std::int64_t only = parse_integer(text, what);
    return {only, only};
  }
  const Range range{parse_integer(text.substr(0, dots), what), parse_integer(text.substr(dots + 2), what)};
  if (range.first > range.last) {
    throw UsageError(std::string(what) + ": " + std::string(text) +
                     " is empty; expected FIRST..LAST with FIRST <= LAST");
  }
  return range;
}

struct Outputs::Output {
  std::string path;  // as it was given
  fs::path target;
  std::string temporary;  // "" if the text is written to the target as it is
  std::string text;       // if so
};

Outputs::Outputs() = default;
Outputs::Outputs(Outputs&&) noexcept = default;

Outputs::~Outputs() {
  const std::lock_guard lock(unfinished().mutex);
  for (const Output& output : outputs_) {
    if (output.temporary.empty()) continue;
    unlink(output.temporary.c_str());
    unfinished().paths.erase(output.temporary);
  }
}

void Outputs::add(const std::string& path, std::string text) {
  if (path == "-") {
    outputs_.push_back({path, {}, "", std::move(text)});
    return;
  }
  const Target target = target_of(path);
  if (!target.whole) {
    outputs_.push_back({path, target.path, "", std::move(text)});
    return;
  }
  if (!places_.insert(target.place()).second) can_not_write(path, "another output goes there");
  Output output{path, target.path, target.path.string() + ".XXXXXX", ""};
  std::ofstream out;
  {
    const std::lock_guard lock(unfinished().mutex);
    const int descriptor = mkstemp(output.temporary.data());
    if (descriptor < 0) can_not_write(path, std::strerror(errno));
    // Opened before a signal can remove the file; opened afterwards, it would be made anew.
    out.open(output.temporary, std::ios::binary);
    close(descriptor);
    unfinished().paths.insert(output.temporary);
  }
  const std::string temporary = output.temporary;
  outputs_.push_back(std::move(output));
  out << text;
  out.close();
  if (!out) can_not_write(path, std::strerror(errno));
  std::error_code error;
  fs::permissions(temporary, target.mode, error);
}

void Outputs::commit() {
  for (const Output& output : outputs_) {
    if (!output.temporary.empty() || output.path == "-") continue;
    const auto broken_pipe = std::signal(SIGPIPE, SIG_IGN);  // is an error here, not the end: there are temporary files
    std::ofstream out(output.target, std::ios::binary);
    out << output.text << std::flush;
    std::signal(SIGPIPE, broken_pipe);
    if (!out) can_not_write(output.path, "output error");
  }
  {
    const std::lock_guard lock(unfinished().mutex);
    for (Output& output : outputs_) {
      if (output.temporary.empty()) continue;
      std::error_code error;
      fs::rename(output.temporary, output.target, error);
      if (error) can_not_write(output.path, error.message());
      unfinished().paths.erase(output.temporary);
      output.temporary.clear();
    }
  }
  for (const Output& output : outputs_) {
    if (output.path == "-") std::cout << output.text;  // run() sees whether it could be written
  }
  outputs_.clear();
}

void write_text(const std::string& path, std::string text) {
  Outputs outputs;
  outputs.add(path, std::move(text));
  outputs.commit();
}

namespace {

void require_access(const std::string& path, const fs::path& what, int access) {
  if (faccessat(AT_FDCWD, what.c_str(), access, AT_EACCESS) != 0) can_not_write(path, std::strerror(errno));
}

}  // namespace

std::string require_writable(const std::string& path) {
  if (path == "-") return path;
  const Target target = target_of(path);
  if (target.whole) {
    struct stat now {};
    if (stat(target.path.c_str(), &now) != 0 && errno != ENOENT) can_not_write(path, std::strerror(errno));
    require_access(path, target.path.has_parent_path() ? target.path.parent_path() : fs::path("."), W_OK | X_OK);
  } else {
    require_access(path, target.path, W_OK);
  }
  return target.place();
}

void require_folder(const std::string& path) {
  if (path.empty()) throw UsageError("a folder's name is expected, not nothing");
  // The folder itself, or the first of those it is to be in that is there.
  std::error_code error;
  fs::path there = fs::absolute(path, error);
  while (fs::status(there, error).type() == fs::file_type::not_found && there.has_relative_path())
    there = there.parent_path();
  if (!fs::is_directory(there, error))
    can_not_write(path, error ? error.message() : there.string() + " is not a folder");
  require_access(path, there, W_OK | X_OK);
}

Progress::Progress(std::string what, std::int64_t total, bool quiet)
    : what_(std::move(what)),
      total_(total),
      shown_(!quiet && isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {}

Progress::~Progress() { finish(); }

void Progress::finish() {
  const std::scoped_lock lock(mutex_);
  if (printed_) std::cerr << "\r\033[K" << std::flush;
  printed_ = false;
}

void Progress::advance(std::int64_t by) {
  const std::int64_t done = done_ += by;
  if (!shown_) return;
  const std::scoped_lock lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (now - start_ < std::chrono::seconds(1) || now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  printed_ = true;
  std::cerr << '\r' << what_ << ": " << done;
  if (total_ > 0) std::cerr << " of " << total_;
  std::cerr << "\033[K" << std::flush;
}

}  // namespace requad::program
