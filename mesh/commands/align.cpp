// requad-edit align: aligns a pair.

#include "mesh/commands/commands.hpp"
#include "mesh/commands/pair_edit.hpp"

namespace requad::edit {

program::Command align_command() {
  return {
      .name = "align",
      .usage = {"IN A B -o OUT"},
      .summary = "moves a 3-3 or 5-5 pair until a separatrix joins A and B",
      .examples = {"requad-edit align mesh/examples/figure-17.obj 153 366 -o aligned.obj"},
      .options = editing_options({allow_inverted_option()}),
      .words = {3, 3},
      .files = {0},
      .run = [](const program::Options& options) { return edit_pair(options, "align", mesh::align_pair); },
  };
}

}  // namespace requad::edit
