#include "mesh/program/run/run.hpp"

#include <csignal>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

#include "mesh/program/run/errors.hpp"
#include "mesh/program/run/interruption.hpp"

namespace requad::program {

int run(std::string_view name, const std::function<int()>& body) {
  const auto report = [name](const std::string& what) {
    std::cerr << one_line(std::string(name) + ": " + what) << '\n';
  };
  try {
    // A file that grows beyond its limit is an error to report, like a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    end_cleanly_on_signals();
    const int code = body();
    std::cout.flush();
    if (!std::cout) throw UsageError("standard output cannot be written");
    return code;
  } catch (const UsageError& error) {
    report(error.what());
    return kBadInput;
  } catch (const std::invalid_argument& error) {
    report(error.what());
    return kBadInput;
  } catch (const std::exception& error) {
    if (is_exhaustion(error)) {
      report(dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "out of memory" : "out of threads");
      return kUndecided;
    }
    report(std::string("internal error: ") + error.what());
    return kCheckFailed;
  }
}

void restore_signals() {
  std::signal(SIGXFSZ, SIG_DFL);
  restore_signals_that_end();
}

}  // namespace requad::program
