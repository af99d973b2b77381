#include "mesh/program.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>

#include <sys/stat.h>
#include <unistd.h>

#include "mesh/quad_mesh.hpp"

namespace requad::program {

namespace {

// The file that write_text() is filling, so that a signal that ends the program takes it away. Made and never freed, as
// a signal may come when the program is ending anyway.
struct Unfinished {
  std::mutex mutex;  // held while the file is made, renamed or removed
  std::string path;  // "" if there is none
};
Unfinished& unfinished() {
  static auto* const it = new Unfinished;
  return *it;
}

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
  pthread_sigmask(SIG_BLOCK, &awaited, nullptr);
  std::thread([awaited] {
    int signal = 0;
    if (sigwait(&awaited, &signal) != 0) return;
    const std::lock_guard lock(unfinished().mutex);
    if (!unfinished().path.empty()) unlink(unfinished().path.c_str());
    std::signal(signal, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &awaited, nullptr);
    raise(signal);
  }).detach();
}

// A file beside its target, removed unless it is kept.
class UnfinishedFile {
 public:
  // `path` ends in XXXXXX. Leaves errno and path() empty if no file can be made.
  explicit UnfinishedFile(std::string path) : path_(std::move(path)) {
    const std::lock_guard lock(unfinished().mutex);
    const int descriptor = mkstemp(path_.data());
    if (descriptor < 0) {
      path_.clear();
      return;
    }
    // Opened before a signal can remove the file; opened afterwards, it would be made anew.
    out_.open(path_, std::ios::binary);
    close(descriptor);
    unfinished().path = path_;
  }
  ~UnfinishedFile() {
    const std::lock_guard lock(unfinished().mutex);
    if (!path_.empty()) unlink(path_.c_str());
    unfinished().path.clear();
  }
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  const std::string& path() const { return path_; }
  std::ofstream& out() { return out_; }
  // Gives the file its name.
  std::error_code finish(const std::filesystem::path& target) {
    const std::lock_guard lock(unfinished().mutex);
    std::error_code error;
    std::filesystem::rename(path_, target, error);
    if (error) return error;
    path_.clear();
    unfinished().path.clear();
    return error;
  }

 private:
  std::string path_;
  std::ofstream out_;
};

}  // namespace

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7F'; }, '?');
  return text;
}

int run(std::string_view name, const std::function<int()>& body) {
  // A file that grows beyond its limit is an error to report, like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  end_on_signals();
  const auto say = [name](const char* what) { std::cerr << one_line(std::string(name) + ": " + what) << '\n'; };
  try {
    const int code = body();
    std::cout.flush();
    if (!std::cout) throw UsageError("standard output can not be written");
    return code;
  } catch (const UsageError& error) {
    say(error.what());
    return kBadInput;
  } catch (const mesh::MeshError& error) {
    say(error.what());
    return kBadInput;
  } catch (const std::invalid_argument& error) {
    say(error.what());
    return kBadInput;
  } catch (const std::bad_alloc&) {
    say("out of memory");
    return kUndecided;
  } catch (const std::exception& error) {
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

void write_text(const std::string& path, std::string_view text) {
  namespace fs = std::filesystem;
  if (path == "-") {
    std::cout << text;
    return;
  }
  const auto fail = [&path](const std::string& why) { throw UsageError(path + ": can not be written: " + why); };
  // Through links to what they name. A device or a pipe is written to, never replaced.
  std::error_code error;
  fs::path target = path;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    const fs::path next = fs::read_symlink(target, error);
    if (error || links == 40) fail(error ? error.message() : "too many links");
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    std::ofstream out(target, std::ios::binary);
    out << text;
    out.flush();
    if (!out) fail(fs::is_directory(status) ? "it is a folder" : "output error");
    return;
  }
  UnfinishedFile temporary(target.string() + ".XXXXXX");
  if (temporary.path().empty()) fail(std::strerror(errno));
  std::ofstream& out = temporary.out();
  out << text;
  out.close();
  if (!out) fail(std::strerror(errno));
  // As an ordinary new file would be, or as the file that is replaced was.
  const mode_t mask = umask(0);
  umask(mask);
  const auto usual = static_cast<fs::perms>(0666 & ~mask);
  fs::permissions(temporary.path(), fs::exists(status) ? status.permissions() : usual, error);
  if (const std::error_code refused = temporary.finish(target)) fail(refused.message());
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
