// requad-verify: checks the claims of the paper by computer.

#include <iostream>
#include <streambuf>

#include "verify/commands/commands.hpp"
#include "verify/report/run_description.hpp"

namespace {

// Discards everything that is printed.
class Discard : public std::streambuf {
  int_type overflow(int_type c) override { return traits_type::not_eof(c); }
};

}  // namespace

int main(int argc, char** argv) {
  using namespace requad::verify;
  const std::string words = command_line(argc, argv);
  Processes processes(argc, argv);
  // Only the process that leads prints.
  static Discard discard;
  if (!processes.leads()) {
    std::cout.rdbuf(&discard);
    std::cerr.rdbuf(&discard);
  }
  return requad::program::run_program(
      argc, argv,
      {
          .name = "requad-verify",
          .version = REQUAD_VERSION,
          .summary = "checks the claims of \"Connectivity Editing for Quadrilateral Meshes\" by computer",
          .exit_codes =
              "0 all claims hold, 1 one fails, 2 bad arguments, 3 undecided: a claim had no instance in these ranges",
          .text = "",
          .commands = {campaign_command(processes, words), check_command(processes, argv[0]), list_command(),
                       proofs_command(), errata_command(), sentences_command()},
      });
}
