// How a program runs and ends: exit codes, exceptions, signals.
#pragma once

#include <functional>
#include <string_view>

namespace requad::program {

enum ExitCode : int {
  kDone = 0,         // everything was done, and all that was checked is true
  kCheckFailed = 1,  // a check failed, or an edit is impossible
  kBadInput = 2,     // bad arguments or bad input
  kUndecided = 3     // a limit was reached
};

// Calls body and returns its exit code. An exception ends in one line "NAME: message" on standard error. The exit code
// is then kBadInput for UsageError and std::invalid_argument, kUndecided if memory or threads ran out, and kCheckFailed
// for any other exception, which is a fault of this program. A signal that ends the program (SIGINT, SIGTERM, SIGHUP)
// removes the temporary files of outputs that were not committed.
int run(std::string_view name, const std::function<int()>& body);

// Undoes what run() did to signals: for a program that is about to be replaced by another one (exec).
void restore_signals();

}  // namespace requad::program
