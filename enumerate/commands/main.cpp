// requad-enumerate: regions, configuration graphs, paths of moves, exhaustive searches.

#include "enumerate/commands/commands.hpp"

int main(int argc, char** argv) {
  using namespace requad::enumerate;
  return requad::program::run_program(
      argc, argv,
      {
          .name = "requad-enumerate",
          .version = REQUAD_VERSION,
          .summary = "regions of quad meshes, their irregular vertices, and all their fillings",
          .exit_codes = "0 done, 1 a check failed, 2 bad arguments or input, 3 a limit was reached",
          .text = "",
          .commands =
              {
                  region_command(),
                  configurations_command(),
                  graph_command(),
                  path_command(),
                  search_command(),
                  sphere_command(),
                  signature_command(),
                  tau_command(),
              },
      });
}
