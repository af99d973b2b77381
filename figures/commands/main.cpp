// requad-figures: the paper's figures from computed meshes, and the explorer.

#include "figures/commands/commands.hpp"

int main(int argc, char** argv) {
  using namespace requad::figures;
  return requad::program::run_program(
      argc, argv,
      {
          .name = "requad-figures",
          .version = REQUAD_VERSION,
          .summary = "the paper's figures, and some more, from computed meshes",
          .exit_codes = "0 done, 1 a claim fails in the region of --explorer, 2 bad arguments",
          .text = "",
          .commands = {pictures_command(), explorer_command()},
      });
}
