#include "mesh/program/run/outputs.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "mesh/program/run/errors.hpp"
#include "mesh/program/run/interruption.hpp"

namespace requad::program {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void throw_unwritable(const std::string& path, const std::string& why) {
  throw UsageError(path + ": cannot be written: " + why);
}

// Where an output goes.
struct Target {
  fs::path path;   // with all links followed
  bool whole;      // whether a new file takes this place; a device or pipe is written to as it is
  fs::perms mode;  // of the new file

  // Equal for two paths of one file; "" for a device or pipe.
  std::string identity() const {
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
    if (fs::is_directory(status)) throw_unwritable(path, "it is a folder");
    return {path, false, {}};
  }
  fs::path target = path;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    const fs::path next = fs::read_symlink(target, error);
    if (error || links == 40) throw_unwritable(path, error ? error.message() : "too many links");
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  // The permissions of the file that is replaced, or those of any new file.
  const mode_t mask = umask(0);
  umask(mask);
  return {target, true, fs::exists(status) ? status.permissions() : static_cast<fs::perms>(0666 & ~mask)};
}

void require_access(const std::string& path, const fs::path& what, int access) {
  if (faccessat(AT_FDCWD, what.c_str(), access, AT_EACCESS) != 0) throw_unwritable(path, std::strerror(errno));
}

}  // namespace

struct Outputs::Output {
  std::string path;  // as it was given
  fs::path target;
  std::string temporary;  // the file that holds the text until the commit; "" if there is none
  std::string text;       // if there is none
};

Outputs::Outputs() = default;
Outputs::Outputs(Outputs&&) noexcept = default;

Outputs::~Outputs() {
  const std::lock_guard lock(temporary_files().mutex);
  for (const Output& output : outputs_) {
    if (output.temporary.empty()) continue;
    unlink(output.temporary.c_str());
    temporary_files().paths.erase(output.temporary);
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
  if (!identities_.insert(target.identity()).second) throw_unwritable(path, "another output goes there");
  Output output{path, target.path, target.path.string() + ".XXXXXX", ""};
  std::ofstream out;
  {
    const std::lock_guard lock(temporary_files().mutex);
    const int descriptor = mkstemp(output.temporary.data());
    if (descriptor < 0) throw_unwritable(path, std::strerror(errno));
    // This must happen before a signal can remove the file: to open it later would make it anew.
    out.open(output.temporary, std::ios::binary);
    close(descriptor);
    temporary_files().paths.insert(output.temporary);
  }
  const std::string temporary = output.temporary;
  outputs_.push_back(std::move(output));
  out << text;
  out.close();
  if (!out) throw_unwritable(path, std::strerror(errno));
  std::error_code error;
  fs::permissions(temporary, target.mode, error);
}

void Outputs::commit() {
  for (const Output& output : outputs_) {
    if (!output.temporary.empty() || output.path == "-") continue;
    // A broken pipe must not end the program, for temporary files would stay behind.
    const auto broken_pipe = std::signal(SIGPIPE, SIG_IGN);
    std::ofstream out(output.target, std::ios::binary);
    out << output.text << std::flush;
    std::signal(SIGPIPE, broken_pipe);
    if (!out) throw_unwritable(output.path, "output error");
  }
  {
    const std::lock_guard lock(temporary_files().mutex);
    for (Output& output : outputs_) {
      if (output.temporary.empty()) continue;
      std::error_code error;
      fs::rename(output.temporary, output.target, error);
      if (error) throw_unwritable(output.path, error.message());
      temporary_files().paths.erase(output.temporary);
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

std::string require_writable(const std::string& path) {
  if (path == "-") return path;
  const Target target = target_of(path);
  if (target.whole) {
    struct stat now {};
    if (stat(target.path.c_str(), &now) != 0 && errno != ENOENT) throw_unwritable(path, std::strerror(errno));
    require_access(path, target.path.has_parent_path() ? target.path.parent_path() : fs::path("."), W_OK | X_OK);
  } else {
    require_access(path, target.path, W_OK);
  }
  return target.identity();
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code none;
  return fs::is_regular_file(a, none) && fs::equivalent(a, b, none);
}

void require_folder(const std::string& path) {
  if (path.empty()) throw UsageError("a folder's name is expected, not nothing");
  // The innermost folder on the path that exists.
  std::error_code error;
  fs::path existing = fs::absolute(path, error);
  while (fs::status(existing, error).type() == fs::file_type::not_found && existing.has_relative_path())
    existing = existing.parent_path();
  if (!fs::is_directory(existing, error))
    throw_unwritable(path, error ? error.message() : existing.string() + " is not a folder");
  require_access(path, existing, W_OK | X_OK);
}

}  // namespace requad::program
