// requad-edit: describes and edits quad meshes in space.

#include "mesh/commands/commands.hpp"

int main(int argc, char** argv) {
  using namespace requad::edit;
  return requad::program::run_program(
      argc, argv,
      {
          .name = "requad-edit",
          .version = REQUAD_VERSION,
          .summary = "looks at quad meshes in space and edits them",
          .exit_codes = "0 done, 1 the edit cannot be made, 2 bad arguments or input",
          .text = R"(IN is an OBJ or OFF file of quads; --subdivide accepts other polygons too.
Vertices A, B, C, V, W are given by their numbers in IN, counted from 1. Edits
keep features and the boundary to the last bit. An edit that cannot be made
writes nothing, and a line says why.
)",
          .commands =
              {
                  info_command(),
                  draw_command(),
                  smooth_command(),
                  subdivide_command(),
                  moves_command(),
                  move_command(),
                  cancel_command(),
                  merge_command(),
                  align_command(),
                  part_command(),
                  reduce_command(),
                  atomic_command(),
                  apply_command(),
              },
      });
}
