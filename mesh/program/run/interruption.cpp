#include "mesh/program/run/interruption.hpp"

#include <csignal>
#include <thread>

#include <unistd.h>

namespace requad::program {

namespace {

sigset_t blocked_before;

}  // namespace

TemporaryFiles& temporary_files() {
  // Never destroyed: a signal may come while the program ends anyway.
  static auto* const files = new TemporaryFiles;
  return *files;
}

// A thread of its own waits for the signals. So none can come between making a file and listing it. The signals are
// blocked in all threads that are started later, for those inherit the mask.
void end_cleanly_on_signals() {
  sigset_t awaited;
  sigemptyset(&awaited);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    if (now.sa_handler != SIG_IGN) sigaddset(&awaited, signal);
  }
  temporary_files();
  pthread_sigmask(SIG_BLOCK, &awaited, &blocked_before);
  std::thread([awaited] {
    int signal = 0;
    if (sigwait(&awaited, &signal) != 0) return;
    const std::lock_guard lock(temporary_files().mutex);
    for (const std::string& path : temporary_files().paths) unlink(path.c_str());
    std::signal(signal, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &awaited, nullptr);
    raise(signal);
  }).detach();
}

void restore_signals_that_end() { pthread_sigmask(SIG_SETMASK, &blocked_before, nullptr); }

}  // namespace requad::program
