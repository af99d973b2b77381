// Signals that end a program, and the temporary files that must go with it. Only this room includes this header.
#pragma once

#include <mutex>
#include <set>
#include <string>

namespace requad::program {

// The temporary files that exist now. A signal that ends the program removes them.
struct TemporaryFiles {
  std::mutex mutex;  // hold it while a file is made, renamed or removed
  std::set<std::string> paths;
};
TemporaryFiles& temporary_files();

// From now on, SIGINT, SIGTERM and SIGHUP remove the temporary files before they end the program. A signal that is
// ignored, as in the background, stays ignored. Call this before any other thread is started.
void end_cleanly_on_signals();
// Gives the signals back the effect that they had before end_cleanly_on_signals().
void restore_signals_that_end();

}  // namespace requad::program
