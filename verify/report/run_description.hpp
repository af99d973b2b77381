// What a reader needs to know about a run in order to repeat it.
#pragma once

#include <chrono>
#include <string>

namespace requad::verify {

struct RunDescription {
  std::string version;  // of the program; all of it is left out of the report if this is ""
  std::string command;  // as for a shell
  std::string date;     // when the run ended: "2011-12-01 09:30 UTC"
  std::string machine;  // system, processor, cores, memory
  double seconds = 0;   // that the run took
};

// The arguments in one line, quoted where a shell needs it.
std::string command_line(int argc, const char* const* argv);

// Describes the run that started then and ends now. What the system does not tell is left out.
RunDescription describe_run(std::string version, std::string command, std::chrono::steady_clock::time_point start);

}  // namespace requad::verify
